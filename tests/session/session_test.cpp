// The cycle: a new loading, queries, rates of the channels, digests, and the heap.
#include "firmware/session/session.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "msgs/convert/digest.hpp"
#include "tests/session/session_fixture.hpp"
#include "tests/support/heap_guard.hpp"

namespace quickstrip::test {
namespace {

TEST(Session, ANewLoadingSaysSoForExactlyOneCycleAndMakesAnotherShip) {
  const auto b = bridge_at_sea();
  const double before = b->cycle(kStart).roll_rms_deg;
  const std::int64_t digest = b->session.advice().hull_digest;
  ASSERT_TRUE(b->session.accept(loaded(kStart, 9.0), kStart).ok());
  EXPECT_EQ(b->cycle(kStart + kSecond).no_advice, code(NoAdvice::kLoadingChanged));
  EXPECT_EQ(b->cycle(kStart + 2 * kSecond).no_advice, 0);
  EXPECT_NE(b->session.advice().roll_rms_deg, before);  // KG 9.0 instead of 9.55 m
  EXPECT_NE(b->session.advice().hull_digest, digest);
}

TEST(Session, TheSameLoadingRepeatedChangesNothing) {
  const auto b = bridge_at_sea();
  ASSERT_TRUE(b->session.accept(loaded(kStart, 9.0), kStart).ok());
  b->cycle(kStart);
  for (int i = 1; i <= 3; ++i) {
    ASSERT_TRUE(b->session.accept(loaded(kStart + i * kSecond, 9.0, i), kStart + i * kSecond).ok());
    EXPECT_EQ(b->cycle(kStart + i * kSecond).no_advice, 0);
  }
}

TEST(Session, ALoadingThatCannotFloatUprightGivesNoAdviceUntilAGoodOneComes) {
  const auto b = bridge_at_sea();
  ASSERT_TRUE(b->session.accept(loaded(kStart, 12.0), kStart).ok());  // KM is 10.5 m
  b->cycle(kStart);
  EXPECT_EQ(b->cycle(kStart + kSecond).no_advice, code(NoAdvice::kLoadingImplausible));
  ASSERT_TRUE(b->session.accept(loaded(kStart + 2 * kSecond, 9.5, 2), kStart + 2 * kSecond).ok());
  EXPECT_EQ(b->cycle(kStart + 2 * kSecond).no_advice, code(NoAdvice::kLoadingChanged));
  EXPECT_EQ(b->cycle(kStart + 3 * kSecond).no_advice, 0);
}

TEST(Session, AdviceGridAndResponseComeEachCycleLimitsEveryTenSecondsHealthEverySecond) {
  const auto b = bridge_at_sea();
  for (int i = 0; i < 20; ++i) {  // ten seconds, two cycles each
    b->cycle(kStart + i * kSecond / 2);
  }
  EXPECT_EQ(b->outbox.sent(OutChannel::kAdvice), 20);
  EXPECT_EQ(b->outbox.sent(OutChannel::kGrid), 20);
  EXPECT_EQ(b->outbox.sent(OutChannel::kResponse), 20);
  EXPECT_EQ(b->outbox.sent(OutChannel::kLimits), 1);
  EXPECT_EQ(b->outbox.sent(OutChannel::kHealth), 10);
  b->cycle(kStart + 10 * kSecond);
  EXPECT_EQ(b->outbox.sent(OutChannel::kLimits), 2);
}

query_t query(std::int64_t id, double heading_deg, double speed_kn) {
  query_t out{};
  out.utime = kStart;
  out.source_id = 50;
  out.query_id = id;
  out.heading_deg = heading_deg;
  out.speed_kn = speed_kn;
  return out;
}

TEST(Session, AQueryIsAnsweredInTheNextCycleWithItsIdAndTheGridsVerdict) {
  const auto b = bridge_at_sea();
  ASSERT_TRUE(b->session.accept(query(77, 90.0, 12.0), kStart).ok());
  b->cycle(kStart);
  EXPECT_EQ(b->outbox.sent(OutChannel::kResponse), 2);
  const auto answer = b->outbox.decoded<response_t>(OutChannel::kResponse);
  EXPECT_EQ(answer.query_id, 77);
  EXPECT_EQ(answer.query_source_id, 50);
  EXPECT_EQ(answer.refusal, 0);
  EXPECT_GT(answer.num_quantities, 6);
  EXPECT_EQ(answer.verdict, b->session.grid().verdict[2][3]);  // 12 kn, 090
}

TEST(Session, AQueryOutsideTheGridIsRefusedWithItsId) {
  const auto b = bridge_at_sea();
  ASSERT_TRUE(b->session.accept(query(78, 0.0, 30.0), kStart).ok());
  b->cycle(kStart);
  const auto answer = b->outbox.decoded<response_t>(OutChannel::kResponse);
  EXPECT_EQ(answer.query_id, 78);
  EXPECT_EQ(answer.refusal, static_cast<int>(Refusal::kSpeedOutsideGrid));
}

TEST(Session, ASpeedOutsideTheGridKeepsTheGridAndNamesTheSpeed) {
  const auto b = bridge_at_sea();
  ASSERT_TRUE(b->session.accept(ship(kStart, 0.0, 28.0, 2), kStart).ok());
  const advice_t& advice = b->cycle(kStart);
  EXPECT_EQ(advice.no_advice, code(NoAdvice::kSpeedOutsideGrid));
  EXPECT_NE(b->no_advice_text().find("28"), std::string::npos) << b->no_advice_text();
  EXPECT_NEAR(advice.speed_kn, 28.0, 1e-9);  // rounding of the unit
  EXPECT_NE(b->session.grid().verdict[2][3], 0);
}

TEST(Session, WithoutAdviceNoCellOfTheGridIsGood) {
  const auto b = bridge_at_sea();
  b->cycle(kStart);
  b->cycle(kStart + 60 * kSecond);  // own ship is stale
  const grid_t& grid = b->session.grid();
  for (int s = 0; s < grid.num_speeds; ++s) {
    for (int h = 0; h < grid.num_headings; ++h) {
      EXPECT_EQ(grid.verdict[s][h], 0);
    }
  }
}

TEST(Session, TheSameInputsAtTheSameTimesGiveTheSameBytes) {
  const auto a = bridge_at_sea();
  const auto b = bridge_at_sea();
  for (int i = 0; i < 3; ++i) {
    a->cycle(kStart + i * kSecond);
    b->cycle(kStart + i * kSecond);
    EXPECT_EQ(a->session.advice().digest, b->session.advice().digest);
    EXPECT_NE(a->session.advice().digest, 0);
    EXPECT_TRUE(a->outbox.last == b->outbox.last);
  }
}

TEST(Session, TheDigestIsOfTheMessageWithDigestZero) {
  const auto b = bridge_at_sea();
  b->cycle(kStart);
  auto sent = b->outbox.decoded<advice_t>(OutChannel::kAdvice);
  const std::int64_t digest = sent.digest;
  sent.digest = 0;
  const auto bytes = std::make_unique<std::array<std::uint8_t, kMaxMessageBytes>>();
  Fnv1a fnv;
  fnv.add(encode(sent, *bytes));
  EXPECT_EQ(digest, fnv.as_int64());
}

TEST(Session, MessagesThatAreLostOnTheWayOutAreCounted) {
  const auto b = bridge_at_sea();
  b->outbox.is_broken = true;
  b->cycle(kStart);
  b->cycle(kStart + kSecond);
  EXPECT_GE(b->outbox.decoded<health_t>(OutChannel::kHealth).publish_failures, 3);
}

TEST(Session, AThousandCyclesWithChangingSeasAndLoadingsDoNotTouchTheHeap) {
  const auto b = bridge_at_sea();
  b->cycle(kStart);
  const HeapGuard guard;
  for (int i = 1; i <= 1000; ++i) {
    const std::int64_t now = kStart + i * kSecond;
    QS_CHECK(b->session.accept(ship(now, i % 360, 1.0 + i % 20, i), now).ok());
    if (i % 10 == 0) {
      QS_CHECK(b->session.accept(swell(now, 1.0 + i % 7, (7 * i) % 360, i), now).ok());
    }
    if (i % 25 == 0) {
      QS_CHECK(b->session.accept(spectrum(now, 0.1 + 0.01 * (i % 9), i % 8, i), now).ok());
    }
    if (i % 250 == 0) {
      QS_CHECK(b->session.accept(loaded(now, 9.0 + 0.0001 * i, i), now).ok());
    }
    b->cycle(now);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace
}  // namespace quickstrip::test
