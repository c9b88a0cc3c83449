#include "firmware/session/alerts.hpp"

#include <gtest/gtest.h>

#include "core/advice/advice.hpp"
#include "msgs/convert/text.hpp"

namespace quickstrip {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kStart = 1'567'600'800 * kSecond;
constexpr std::int8_t kGood = 1;
constexpr std::int8_t kCaution = 2;
constexpr std::int8_t kExceeded = 3;

advice_t with_verdict(std::int64_t utime, std::int8_t verdict) {
  advice_t advice{};
  advice.utime = utime;
  advice.verdict = verdict;
  advice.governing = 2;
  advice.governing_value = 7.1;
  advice.governing_limit = 6.0;
  put_text("Roll 7.1 of 6 degrees", advice.reasons_text);
  return advice;
}

advice_t without(std::int64_t utime, NoAdvice reason) {
  advice_t advice{};
  advice.utime = utime;
  advice.no_advice = static_cast<std::int16_t>(reason);
  put_text("No advice, because", advice.no_advice_text);
  return advice;
}

alert_t acknowledgement(alert_t of) {
  of.state = alert_t::STATE_ACKNOWLEDGED;
  return of;
}

class AlertsTest : public testing::Test {
 protected:
  AlertsTest() { alerts_.configure(1, 10.0); }
  const alert_t* after(const advice_t& advice) {
    alerts_.follow(advice);
    return alerts_.next_to_send(advice.utime);
  }
  Alerts alerts_;
};

TEST_F(AlertsTest, AnExceededLimitRaisesAWarningWithItsReasonOnce) {
  const alert_t* const alert = after(with_verdict(kStart, kExceeded));
  ASSERT_NE(alert, nullptr);
  EXPECT_EQ(alert->priority, 3);  // warning
  EXPECT_EQ(alert->state, 1);     // active
  EXPECT_EQ(alert->criterion, 2);
  EXPECT_EQ(get_text(alert->text), "Roll 7.1 of 6 degrees");
  EXPECT_EQ(after(with_verdict(kStart + kSecond, kExceeded)), nullptr);
}

TEST_F(AlertsTest, AnActiveAlertIsRepeatedEveryTenSecondsUnchanged) {
  after(with_verdict(kStart, kExceeded));
  const alert_t* const again = after(with_verdict(kStart + 10 * kSecond, kExceeded));
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(again->revision, 1);
}

TEST_F(AlertsTest, AcknowledgedAndOverIsNormal) {
  const alert_t raised = *after(with_verdict(kStart, kExceeded));
  ASSERT_TRUE(alerts_.accept(acknowledgement(raised), kStart + kSecond).ok());
  EXPECT_EQ(after(with_verdict(kStart + kSecond, kExceeded))->state, 3);  // acknowledged
  EXPECT_EQ(after(with_verdict(kStart + 2 * kSecond, kGood))->state, 0);  // normal
}

TEST_F(AlertsTest, OverBeforeAcknowledgedStaysRectifiedUntilSeen) {
  after(with_verdict(kStart, kExceeded));
  const alert_t over = *after(with_verdict(kStart + kSecond, kGood));
  EXPECT_EQ(over.state, 4);  // rectified
  ASSERT_TRUE(alerts_.accept(acknowledgement(over), kStart + 2 * kSecond).ok());
  EXPECT_EQ(after(with_verdict(kStart + 2 * kSecond, kGood))->state, 0);
}

TEST_F(AlertsTest, AnAcknowledgementOfAnOlderRevisionIsIgnored) {
  const alert_t first = *after(with_verdict(kStart, kExceeded));
  after(with_verdict(kStart + kSecond, kGood));
  after(with_verdict(kStart + 2 * kSecond, kExceeded));  // raised anew
  ASSERT_TRUE(alerts_.accept(acknowledgement(first), kStart + 3 * kSecond).ok());
  EXPECT_EQ(after(with_verdict(kStart + 3 * kSecond, kExceeded)), nullptr);  // unchanged
}

TEST_F(AlertsTest, FromCautionToExceededIsAChangeThatMustBeAcknowledgedAgain) {
  const alert_t caution = *after(with_verdict(kStart, kCaution));
  EXPECT_EQ(caution.priority, 4);
  ASSERT_TRUE(alerts_.accept(acknowledgement(caution), kStart).ok());
  after(with_verdict(kStart + kSecond, kCaution));
  const alert_t* const worse = after(with_verdict(kStart + 2 * kSecond, kExceeded));
  ASSERT_NE(worse, nullptr);
  EXPECT_EQ(worse->priority, 3);
  EXPECT_EQ(worse->state, 1);
}

TEST_F(AlertsTest, NoAdviceWarnsAfterTheStartButNotForOneCycleOfRebuilding) {
  EXPECT_EQ(after(without(kStart, NoAdvice::kSeaMissing)), nullptr);  // just started
  EXPECT_EQ(after(without(kStart + 60 * kSecond, NoAdvice::kLoadingChanged)), nullptr);
  const alert_t* const stale = after(without(kStart + 61 * kSecond, NoAdvice::kSeaStale));
  ASSERT_NE(stale, nullptr);
  EXPECT_EQ(stale->alert_id, static_cast<int>(AlertId::kNoAdvice));
  EXPECT_EQ(stale->priority, 3);
}

TEST_F(AlertsTest, WhileThereIsNoAdviceTheLimitsAlertDoesNotEnd) {
  after(with_verdict(kStart, kExceeded));
  alerts_.follow(without(kStart + 20 * kSecond, NoAdvice::kSeaStale));
  const alert_t* const limit = alerts_.next_to_send(kStart + 20 * kSecond);
  ASSERT_NE(limit, nullptr);
  EXPECT_EQ(limit->alert_id, static_cast<int>(AlertId::kLimit));
  EXPECT_EQ(limit->state, 1);
}

TEST_F(AlertsTest, LateCyclesAreACautionOfTheSystemForAMinuteAfterTheLast) {
  alerts_.follow_misses(0, kStart);
  EXPECT_EQ(alerts_.next_to_send(kStart), nullptr);
  alerts_.follow_misses(2, kStart + kSecond);
  const alert_t* const late = alerts_.next_to_send(kStart + kSecond);
  ASSERT_NE(late, nullptr);
  EXPECT_EQ(late->alert_id, static_cast<int>(AlertId::kLate));
  EXPECT_EQ(late->priority, 4);  // caution
  EXPECT_EQ(late->criterion, -1);
  alerts_.follow_misses(2, kStart + 50 * kSecond);
  EXPECT_EQ(alerts_.next_to_send(kStart + 50 * kSecond)->state, 1);  // active, repeated
  alerts_.follow_misses(2, kStart + 62 * kSecond);
  EXPECT_EQ(alerts_.next_to_send(kStart + 62 * kSecond)->state, 0);  // a caution ends by itself
}

TEST_F(AlertsTest, AreNeverMoreThanAWarning) {
  comparison_t gap{};
  gap.confidence = comparison_t::CONFIDENCE_LOWERED;
  gap.num_lines = 1;
  gap.gap_since_s[0] = 7200.0;
  alerts_.follow(gap, kStart);
  alerts_.follow_misses(1'000, kStart);
  alerts_.follow(with_verdict(kStart, kExceeded));
  alerts_.follow(without(kStart + 60 * kSecond, NoAdvice::kSeaStale));
  int num_sent = 0;
  while (const alert_t* const alert = alerts_.next_to_send(kStart + 60 * kSecond)) {
    EXPECT_GE(alert->priority, 3);  // warning; caution is 4
    ++num_sent;
  }
  EXPECT_EQ(num_sent, 4);
}

TEST_F(AlertsTest, AnUnknownAlertIsRefused) {
  alert_t unknown{};
  unknown.utime = kStart;
  unknown.alert_id = 9;
  unknown.instance = 1;
  EXPECT_EQ(alerts_.accept(unknown, kStart).refusal, Refusal::kUnknownKind);
}

}  // namespace
}  // namespace quickstrip
