#include "firmware/nmea/motion_window.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "msgs/convert/received_checks.hpp"
#include "tests/nmea/support.hpp"

namespace quickstrip::nmea {
namespace {

using test::kNow;
using test::kSecond;

/// mean + amplitude * sin(2 pi t / period), sampled for `seconds`.
struct Sine {
  double mean, amplitude, period_s;
  [[nodiscard]] double at(double t) const {
    return mean + amplitude * std::sin(2.0 * std::numbers::pi * t / period_s);
  }
};

void fill(MotionWindow& window, const Sine& roll, double rate_hz, double seconds, double noise = 0.0) {
  std::mt19937 random(7);
  std::normal_distribution<double> gauss;
  for (int i = 0; i <= static_cast<int>(seconds * rate_hz); ++i) {
    const double t = i / rate_hz;
    const auto utime = kNow + static_cast<std::int64_t>(t * 1e6);
    window.take_roll(roll.at(t) + noise * gauss(random), utime);
    window.take_pitch(-0.5 * roll.at(t), utime);
    window.take_heave(0.1 * roll.at(t), utime);
  }
}

TEST(NmeaMotion, ASineHasItsAmplitudeOverRootTwoItsPeriodItsMeanAndItsMaximum) {
  const auto window = std::make_unique<MotionWindow>(1200.0);
  fill(*window, {2.0, 5.0, 11.0}, 10.0, 1200.0);
  const auto m = window->motion(kNow + 1200 * kSecond);
  ASSERT_TRUE(m);
  EXPECT_TRUE(check_motion(*m).ok());
  EXPECT_EQ(m->valid, 31);
  // An incomplete last period leaves 1/(4 pi 109) of the amplitude in the mean: 0.1 %.
  EXPECT_NEAR(m->mean_heel_deg, 2.0, 0.005);
  EXPECT_NEAR(m->mean_trim_deg, -1.0, 0.005);
  EXPECT_NEAR(m->roll_rms_deg, 5.0 / std::numbers::sqrt2, 0.005);
  EXPECT_NEAR(m->pitch_rms_deg, 2.5 / std::numbers::sqrt2, 0.005);
  EXPECT_NEAR(m->heave_rms_m, 0.5 / std::numbers::sqrt2, 0.001);
  EXPECT_NEAR(m->roll_zero_crossing_s, 11.0, 0.001);  // crossings interpolated
  EXPECT_NEAR(m->roll_max_deg, 5.0, 0.01);
  EXPECT_NEAR(m->window_s, 1200.0, 0.01);
  EXPECT_EQ(m->utime, kNow + 1200 * kSecond);
}

TEST(NmeaMotion, NoiseOfTheSensorMakesNoWaves) {
  const auto window = std::make_unique<MotionWindow>(1200.0);
  fill(*window, {0.0, 3.0, 12.0}, 20.0, 1200.0, 0.05);
  const auto m = window->motion(kNow + 1200 * kSecond);
  ASSERT_TRUE(m);
  // Two noisy ends of a hundred periods: a crossing is out by noise / slope = 0.05 / 1.57 s.
  EXPECT_NEAR(m->roll_zero_crossing_s, 12.0, 0.002);
}

TEST(NmeaMotion, OnlyTheLastWindowCounts) {
  const auto window = std::make_unique<MotionWindow>(120.0);
  fill(*window, {0.0, 20.0, 8.0}, 1.0, 300.0);
  for (int i = 301; i <= 430; ++i) {
    window->take_roll(Sine{0.0, 1.0, 8.0}.at(i), kNow + i * kSecond);
  }
  const auto m = window->motion(kNow + 430 * kSecond);
  ASSERT_TRUE(m);
  EXPECT_LT(m->roll_rms_deg, 0.8);
  EXPECT_EQ(m->valid, motion_t::VALID_ROLL);  // pitch has been silent for 130 s
}

TEST(NmeaMotion, TooShortTooFewOrSilentIsNoWindow) {
  const auto window = std::make_unique<MotionWindow>(1200.0);
  EXPECT_FALSE(window->motion(kNow));
  fill(*window, {0.0, 5.0, 10.0}, 10.0, 250.0);
  EXPECT_FALSE(window->motion(kNow + 250 * kSecond));  // less than a quarter
  fill(*window, {0.0, 5.0, 40.0}, 10.0, 350.0);        // begins anew: time went back
  EXPECT_FALSE(window->motion(kNow + 350 * kSecond));  // eight waves
  fill(*window, {0.0, 5.0, 10.0}, 10.0, 350.0);
  EXPECT_TRUE(window->motion(kNow + 350 * kSecond));
  EXPECT_TRUE(window->motion(kNow + 359 * kSecond));
  EXPECT_FALSE(window->motion(kNow + 361 * kSecond));  // a frozen window is not told as fresh
}

TEST(NmeaMotion, AGapIsNeitherCountedNorBridgedByAWave) {
  const auto window = std::make_unique<MotionWindow>(600.0);
  for (int i = 0; i <= 6000; ++i) {
    const double t = i / 10.0;
    if (t < 200.0 || t > 303.0) {
      window->take_roll(Sine{0.0, 4.0, 9.0}.at(t), kNow + i * kSecond / 10);
    }
  }
  const auto m = window->motion(kNow + 600 * kSecond);
  ASSERT_TRUE(m);
  EXPECT_NEAR(m->window_s, 497.0, 0.3);
  EXPECT_NEAR(m->roll_zero_crossing_s, 9.0, 0.01);
}

TEST(NmeaMotion, AThousandSamplesASecondAreThinnedToWhatTheWindowHolds) {
  const auto window = std::make_unique<MotionWindow>(120.0);
  fill(*window, {0.0, 5.0, 8.0}, 1000.0, 120.0);
  const auto m = window->motion(kNow + 120 * kSecond);
  ASSERT_TRUE(m);
  EXPECT_NEAR(m->roll_rms_deg, 5.0 / std::numbers::sqrt2, 0.01);
  EXPECT_NEAR(m->window_s, 120.0, 0.1);
}

}  // namespace
}  // namespace quickstrip::nmea
