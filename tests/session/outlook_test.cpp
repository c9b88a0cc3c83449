// What a session says beside its advice: the outlook, and measured beside predicted motion.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/session/session_fixture.hpp"

namespace quickstrip {
namespace {

using namespace test;

SessionOptions with_members() {
  SessionOptions options;
  options.ensemble_per_cycle = 16;
  return options;
}

motion_t roll_of(std::int64_t utime, double rms_deg, std::int32_t seq) {
  motion_t motion{};
  motion.utime = utime;
  motion.seq = seq;
  motion.source_id = 50;
  motion.valid = motion_t::VALID_ROLL;
  motion.window_s = 1200.0;
  motion.roll_rms_deg = rms_deg;
  motion.roll_zero_crossing_s = 17.0;
  return motion;
}

TEST(SessionOutlook, BelongsToTheAdviceAndSaysWhatToExpect) {
  const auto b = bridge_at_sea(with_members());
  const advice_t& advice = b->cycle(kStart);
  const auto outlook = b->outbox.decoded<outlook_t>(OutChannel::kOutlook);
  EXPECT_EQ(outlook.seq, advice.seq);
  EXPECT_EQ(outlook.utime, advice.utime);
  EXPECT_EQ(outlook.limits_digest, advice.limits_digest);
  EXPECT_EQ(outlook.num_members, 16);
  EXPECT_GE(outlook.present_exceeded, 0);
  EXPECT_LE(outlook.present_exceeded, 16);
  // A manual swell without standard deviations: ours, and said.
  EXPECT_EQ(outlook.std_assumed, 31);
  // Most probable maximum of some hundred rolls: sqrt(2 ln 100) and more of the RMS.
  EXPECT_GT(outlook.expected_max_roll_deg, 3.0 * advice.roll_rms_deg);
  EXPECT_LT(outlook.expected_max_roll_deg, 3.6 * advice.roll_rms_deg);
  EXPECT_EQ(outlook.expect_s, 1800.0);
  // Strip theory's period of the S-175 is 18.1 s: 10 % on either side.
  EXPECT_EQ(outlook.roll_period_kind, static_cast<int>(RollPeriodSource::kComputed));
  EXPECT_NEAR(outlook.roll_period_low_s, 16.3, 0.2);
  EXPECT_NEAR(outlook.roll_period_high_s, 19.9, 0.2);
}

TEST(SessionOutlook, WithoutAdviceKnowsNothing) {
  const auto b = bridge(with_members());
  b->cycle(kStart);
  const auto outlook = b->outbox.decoded<outlook_t>(OutChannel::kOutlook);
  EXPECT_EQ(outlook.num_members, 0);
  EXPECT_EQ(outlook.present_exceeded, -1);
  EXPECT_EQ(outlook.exceeded[0][0], -1);
  EXPECT_EQ(outlook.expected_max_roll_deg, -1.0);
  EXPECT_EQ(outlook.next_criterion, -1);
}

TEST(SessionOutlook, TakesTheDeviationsThatTheSeaStateGives) {
  const auto b = bridge_at_sea(with_members());
  sea_state_t sea = swell(kStart + kSecond, 3.0, 90.0, 2);
  sea.valid |= sea_state_t::VALID_STD;
  sea.hs_std_m[0] = 0.3;
  sea.period_std_s[0] = 1.1;
  sea.dir_std_deg[0] = 7.0;
  ASSERT_TRUE(b->session.accept(sea, kStart + kSecond).ok());
  b->cycle(kStart + kSecond);
  const auto outlook = b->outbox.decoded<outlook_t>(OutChannel::kOutlook);
  EXPECT_NEAR(outlook.std_height_part, 0.1, 1e-12);
  EXPECT_NEAR(outlook.std_period_part, 0.1, 1e-12);
  EXPECT_NEAR(outlook.std_dir_deg, 7.0, 1e-12);
  EXPECT_EQ(outlook.std_assumed, outlook_t{}.std_assumed + 8 + 16);  // GM and damping only
}

/// Half an hour of predictions, a cycle every ten seconds with inputs that stay fresh.
class SessionComparison : public testing::Test {
 protected:
  void SetUp() override {
    sail(180);
    predicted_deg_ = bridge_->session.advice().roll_rms_deg;
    ASSERT_GT(predicted_deg_, 0.1);
  }
  void sail(int num_cycles) {
    for (int i = 0; i < num_cycles; ++i) {
      now_ += 10 * kSecond;
      ASSERT_TRUE(bridge_->session.accept(ship(now_, 0.0, 15.0, ++seq_), now_).ok());
      ASSERT_TRUE(bridge_->session.accept(swell(now_, 3.0, 90.0, seq_), now_).ok());
      bridge_->cycle(now_);
    }
  }
  comparison_t measure(double rms_deg) {
    EXPECT_TRUE(bridge_->session.accept(roll_of(now_, rms_deg, ++seq_), now_).ok());
    bridge_->cycle(now_ + kSecond);
    return bridge_->outbox.decoded<comparison_t>(OutChannel::kComparison);
  }
  std::unique_ptr<Bridge> bridge_ = bridge();
  std::int64_t now_ = kStart;
  std::int32_t seq_ = 0;
  double predicted_deg_ = 0.0;
};

TEST_F(SessionComparison, SetsPredictedBesideMeasuredWithBounds) {
  const comparison_t line = measure(predicted_deg_);
  ASSERT_EQ(line.num_lines, 1);
  EXPECT_EQ(line.state[0], +comparison_t::AGREES);
  EXPECT_NEAR(line.predicted_rms[0], predicted_deg_, 1e-3 * predicted_deg_);  // sums of floats
  EXPECT_LT(line.low_rms[0], predicted_deg_);
  EXPECT_GT(line.high_rms[0], predicted_deg_);
  EXPECT_EQ(line.confidence, +comparison_t::CONFIDENCE_NORMAL);
  char expected[96];
  std::snprintf(expected, sizeof(expected), "roll: predicted %.1f°, measured %.1f° over the last 20 min",
                predicted_deg_, predicted_deg_);
  EXPECT_EQ(get_text(line.text[0]), expected);
}

TEST_F(SessionComparison, AGapThatLastsLowersTheConfidenceAndRaisesACaution) {
  comparison_t line = measure(3.0 * predicted_deg_);
  EXPECT_EQ(line.state[0], +comparison_t::ABOVE_PREDICTED);
  EXPECT_EQ(line.confidence, +comparison_t::CONFIDENCE_NORMAL);  // once is not lasting
  const double before = bridge_->session.advice().roll_rms_deg;
  for (int window = 0; window < 3; ++window) {
    sail(121);
    line = measure(3.0 * predicted_deg_);
  }
  EXPECT_EQ(line.confidence, +comparison_t::CONFIDENCE_LOWERED);
  EXPECT_GT(line.gap_since_s[0], 3600.0);
  EXPECT_EQ(bridge_->session.advice().roll_rms_deg, before);  // nothing is re-tuned
  const auto alert = bridge_->outbox.decoded<alert_t>(OutChannel::kAlert);
  EXPECT_EQ(alert.alert_id, static_cast<int>(AlertId::kMotionGap));
  EXPECT_EQ(alert.priority, +alert_t::PRIORITY_CAUTION);
  sail(121);
  line = measure(predicted_deg_);
  EXPECT_EQ(line.confidence, +comparison_t::CONFIDENCE_NORMAL);
}

TEST_F(SessionComparison, SaysWhenThereIsNothingToCompareWith) {
  motion_t motion = roll_of(now_, 2.0, ++seq_);
  motion.valid = 0;
  motion.num_accelerometers = 1;
  motion.x_m[0] = 3.0;  // no point of the hull file
  motion.a_x_rms_m_s2[0] = -1.0;
  motion.a_y_rms_m_s2[0] = -1.0;
  motion.a_z_rms_m_s2[0] = 0.4;
  motion.a_z_zero_crossing_s[0] = 9.0;
  ASSERT_TRUE(bridge_->session.accept(motion, now_).ok());
  bridge_->cycle(now_ + kSecond);
  const auto line = bridge_->outbox.decoded<comparison_t>(OutChannel::kComparison);
  ASSERT_EQ(line.num_lines, 1);
  EXPECT_EQ(line.state[0], +comparison_t::NOT_COMPARED);
  EXPECT_EQ(line.predicted_rms[0], -1.0);
  EXPECT_EQ(line.confidence, +comparison_t::CONFIDENCE_NOT_KNOWN);
}

}  // namespace
}  // namespace quickstrip
