// Which inputs an advice may rest on: missing, stale, refused, from the future, the newer of two.
#include <gtest/gtest.h>

#include <limits>

#include "tests/session/session_fixture.hpp"

namespace quickstrip::test {
namespace {

TEST(SessionAges, WithSeaAndShipThereIsAdviceOnTheDefaultLoading) {
  const auto b = bridge_at_sea();
  const advice_t& advice = b->cycle(kStart);
  EXPECT_EQ(advice.no_advice, 0);
  EXPECT_NE(advice.verdict, 0);
  EXPECT_EQ(advice.input_use[4], static_cast<int>(InputUse::kDefault));
  EXPECT_EQ(advice.input_use[0], static_cast<int>(InputUse::kLive));
  EXPECT_EQ(advice.input_seq[3], 1);
}

TEST(SessionAges, BeforeAnyInputThereIsNoAdviceAndTheReason) {
  const auto b = bridge();
  EXPECT_EQ(b->cycle(kStart).no_advice, code(NoAdvice::kOwnShipMissing));
  ASSERT_TRUE(b->session.accept(ship(kStart, 0.0, 15.0), kStart).ok());
  EXPECT_EQ(b->cycle(kStart).no_advice, code(NoAdvice::kSeaMissing));
  EXPECT_EQ(b->no_advice_text().rfind("No advice, because", 0), 0u) << b->no_advice_text();
}

TEST(SessionAges, OwnShipIsStaleAfterTenSecondsAndNotBefore) {
  const auto b = bridge_at_sea();
  EXPECT_EQ(b->cycle(kStart + 10 * kSecond).no_advice, 0);
  EXPECT_EQ(b->cycle(kStart + 10 * kSecond + 1).no_advice, code(NoAdvice::kOwnShipStale));
}

TEST(SessionAges, TheSeaIsStaleAfterNinetyMinutesAndTheSentenceSaysHowOld) {
  const auto b = bridge_at_sea();
  const std::int64_t later = kStart + 130 * kMinute;
  ASSERT_TRUE(b->session.accept(ship(later, 0.0, 15.0, 2), later).ok());
  EXPECT_EQ(b->cycle(later).no_advice, code(NoAdvice::kSeaStale));
  EXPECT_NE(b->no_advice_text().find("2 h 10 min"), std::string::npos) << b->no_advice_text();
}

TEST(SessionAges, ASeaIsNotUsedAfterItsOwnValidUntil) {
  const auto b = bridge_at_sea();
  sea_state_t sea = swell(kStart + 1, 3.0, 90.0, 2);
  sea.valid = sea_state_t::VALID_UNTIL;
  sea.valid_until_utime = kStart + 5 * kSecond;
  ASSERT_TRUE(b->session.accept(sea, kStart + 1).ok());
  EXPECT_EQ(b->cycle(kStart + 4 * kSecond).no_advice, 0);
  EXPECT_EQ(b->cycle(kStart + 6 * kSecond).no_advice, code(NoAdvice::kSeaStale));
}

TEST(SessionAges, ALoadingMessageReplacesTheDefaultAndThenAges) {
  const auto b = bridge_at_sea();
  ASSERT_TRUE(b->session.accept(loaded(kStart, 9.4), kStart).ok());
  b->cycle(kStart);  // changed: rebuilt
  EXPECT_EQ(b->cycle(kStart + kSecond).no_advice, 0);
  const std::int64_t later = kStart + 24 * 60 * kMinute + kSecond;
  ASSERT_TRUE(b->session.accept(ship(later, 0.0, 15.0), later).ok());
  ASSERT_TRUE(b->session.accept(swell(later, 3.0, 90.0), later).ok());
  EXPECT_EQ(b->cycle(later).no_advice, code(NoAdvice::kLoadingStale));
}

TEST(SessionAges, StaleAfterIsAnOption) {
  SessionOptions options;
  options.stale_after.own_ship_s = 60.0;
  const auto b = bridge_at_sea(options);
  EXPECT_EQ(b->cycle(kStart + 59 * kSecond).no_advice, 0);
}

TEST(SessionAges, AMessageFromTheFutureIsRefusedAndCounted) {
  const auto b = bridge_at_sea();
  const Conversion refused = b->session.accept(ship(kStart + 6 * kSecond, 90.0, 10.0, 2), kStart);
  EXPECT_EQ(refused.refusal, Refusal::kFromTheFuture);
  EXPECT_TRUE(b->session.accept(ship(kStart + 4 * kSecond, 90.0, 10.0, 3), kStart).ok());  // clocks differ
  b->cycle(kStart);
  const auto health = b->outbox.decoded<health_t>(OutChannel::kHealth);
  EXPECT_EQ(health.input_refused[3], 1);
  EXPECT_EQ(health.input_last_refusal[3], static_cast<int>(Refusal::kFromTheFuture));
}

TEST(SessionAges, WhatWasHeldWhenTheClockIsSetBackCountsAsMissing) {
  const auto b = bridge_at_sea();
  const std::int64_t before = kStart - 60 * kMinute;
  EXPECT_NE(b->cycle(before).no_advice, 0);
  ASSERT_TRUE(b->session.accept(swell(before, 2.0, 90.0), before).ok());
  ASSERT_TRUE(b->session.accept(ship(before, 0.0, 15.0), before).ok());
  EXPECT_EQ(b->cycle(before).no_advice, 0);
}

TEST(SessionAges, ARefusedMessageLeavesTheLastValidOneInForce) {
  const auto b = bridge_at_sea();
  sea_state_t nonsense = swell(kStart + kSecond, 3.0, 90.0, 2);
  nonsense.hs_m[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(b->session.accept(nonsense, kStart + kSecond).ok());
  const advice_t& advice = b->cycle(kStart + kSecond);
  EXPECT_EQ(advice.no_advice, 0);
  EXPECT_EQ(advice.input_seq[0], 1);
}

TEST(SessionAges, WhenOnlyNonsenseHasComeTheSentenceSaysWhy) {
  const auto b = bridge();
  ASSERT_TRUE(b->session.accept(ship(kStart, 0.0, 15.0), kStart).ok());
  EXPECT_FALSE(b->session.accept(swell(kStart, 31.0, 90.0), kStart).ok());
  EXPECT_EQ(b->cycle(kStart).no_advice, code(NoAdvice::kSeaImplausible));
  EXPECT_NE(b->no_advice_text().find("wave height"), std::string::npos) << b->no_advice_text();
}

TEST(SessionAges, TheNewerOfSeaStateAndSpectrumIsUsedAndNamed) {
  const auto b = bridge_at_sea();
  ASSERT_TRUE(b->session.accept(spectrum(kStart + kSecond, 0.5, 2, 7), kStart + kSecond).ok());
  const advice_t with_spectrum = b->cycle(kStart + kSecond);
  EXPECT_EQ(with_spectrum.no_advice, 0);
  EXPECT_EQ(with_spectrum.input_use[1], static_cast<int>(InputUse::kLive));
  EXPECT_EQ(with_spectrum.input_seq[1], 7);
  EXPECT_EQ(with_spectrum.input_use[0], static_cast<int>(InputUse::kNone));
  ASSERT_TRUE(b->session.accept(swell(kStart + 2 * kSecond, 3.0, 90.0, 8), kStart + 2 * kSecond).ok());
  const advice_t with_state = b->cycle(kStart + 2 * kSecond);
  EXPECT_EQ(with_state.input_use[0], static_cast<int>(InputUse::kLive));
  EXPECT_EQ(with_state.input_use[1], static_cast<int>(InputUse::kNone));
}

TEST(SessionAges, AMessageMeasuredBeforeTheOneHeldIsOvertaken) {
  const auto b = bridge_at_sea();
  ASSERT_TRUE(b->session.accept(ship(kStart - 2 * kSecond, 90.0, 10.0, 9), kStart).ok());
  EXPECT_EQ(b->cycle(kStart).input_seq[3], 1);
  EXPECT_EQ(b->outbox.decoded<health_t>(OutChannel::kHealth).input_dropped[3], 1);
}

TEST(SessionAges, RestoredInputsAgeAndAreSaidToBeRestored) {
  const auto before = bridge_at_sea();
  const auto kept = std::make_unique<KeptInputs>();
  before->session.inputs().keep(*kept);
  const auto after = bridge();
  const std::int64_t restart = kStart + 5 * kSecond;
  ASSERT_TRUE(after->session.accept(kept->sea_state, restart, InputUse::kRestored).ok());
  ASSERT_TRUE(after->session.accept(kept->own_ship, restart, InputUse::kRestored).ok());
  EXPECT_FALSE(kept->has_loading);  // the default is the hull file's to give
  const advice_t& advice = after->cycle(restart);
  EXPECT_EQ(advice.no_advice, 0);
  EXPECT_EQ(advice.input_use[0], static_cast<int>(InputUse::kRestored));
  EXPECT_EQ(after->cycle(kStart + 11 * kSecond).no_advice, code(NoAdvice::kOwnShipStale));
}

}  // namespace
}  // namespace quickstrip::test
