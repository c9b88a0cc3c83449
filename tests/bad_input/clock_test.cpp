// The clock itself may be wrong: a QS_TIME of nonsense, one from far ahead, and time set back.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/bad_input/good_messages.hpp"

namespace quickstrip::test {
namespace {

quickstrip::clock_t time_message(std::int64_t utime, double rate = 1.0) {
  quickstrip::clock_t out{};
  out.utime = utime;
  out.rate = rate;
  return out;
}

TEST(BadClock, ATimeThatIsNoneIsRefusedAndCounted) {
  const auto bridge = bridge_at_sea();
  constexpr std::int64_t kEnd = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t utime : {std::int64_t{0}, std::int64_t{-1}, kEnd, -kEnd - 1, kLatestUtime}) {
    EXPECT_EQ(bridge->session.accept(time_message(utime)).refusal, Refusal::kTime) << utime;
  }
  EXPECT_EQ(bridge->session.accept(time_message(kStart, std::nan(""))).refusal, Refusal::kNotFinite);
  EXPECT_EQ(bridge->session.accept(time_message(kStart, -2.0)).refusal, Refusal::kOutOfRange);
  for (const double rate : {-1.0, 0.0, 60.0}) {
    EXPECT_TRUE(bridge->session.accept(time_message(kStart, rate)).ok());
  }
  EXPECT_EQ(bridge->session.inputs().counters(Input::kTime).refused, 7);
  EXPECT_EQ(bridge->session.inputs().counters(Input::kTime).received, 10);
}

// One wrong time far ahead, or a replay started again: health, limits and alerts fell silent until the old
// time had come round again.
TEST(BadClock, SetBackTheSessionSpeaksOnAtOnce) {
  const auto bridge = bridge_at_sea();
  const std::int64_t far_ahead = kStart + 10 * 365 * 24 * kHour;
  static_cast<void>(bridge->cycle(kStart));
  EXPECT_EQ(bridge->cycle(far_ahead).no_advice, code(NoAdvice::kOwnShipStale));
  const int num_health = bridge->outbox.sent(OutChannel::kHealth);
  const int num_limits = bridge->outbox.sent(OutChannel::kLimits);
  EXPECT_EQ(bridge->cycle(kStart + kSecond).no_advice, 0) << bridge->no_advice_text();
  EXPECT_EQ(bridge->outbox.sent(OutChannel::kHealth), num_health + 1);
  EXPECT_EQ(bridge->outbox.sent(OutChannel::kLimits), num_limits + 1);
  EXPECT_EQ(bridge->outbox.decoded<health_t>(OutChannel::kHealth).utime, kStart + kSecond);
}

TEST(BadClock, SetBackTheAlertOnNoAdviceStillComes) {
  const auto bridge = test::bridge();
  static_cast<void>(bridge->cycle(kStart));  // just started: no alert yet
  const std::int64_t earlier = kStart - 10 * 24 * kHour;
  for (int i = 0; i < 12; ++i) {
    static_cast<void>(bridge->cycle(earlier + i * kSecond));
  }
  EXPECT_GT(bridge->outbox.sent(OutChannel::kAlert), 0);
  EXPECT_EQ(bridge->outbox.decoded<alert_t>(OutChannel::kAlert).alert_id,
            static_cast<int>(AlertId::kNoAdvice));
}

}  // namespace
}  // namespace quickstrip::test
