#include "core/response/motion_sickness.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

constexpr double kTwoHours = 7200.0;

/// Of a mean |acceleration| [g] and a frequency [Hz], as tables have it.
VerticalShaking shaking(double a, double f) {
  return {a * kStandardGravity / std::sqrt(2.0 / kPi), kTwoPi * f};
}

double percent_1974(double a, double f) {
  return 100.0 * motion_sickness(shaking(a, f), 0.0);
}
double percent_1976(double a, double f, double minutes = 120.0) {
  return 100.0 * motion_sickness(shaking(a, f), 60.0 * minutes);
}

TEST(MotionSickness, IsThatOfTheTableInBothModels) {
  // O'Hanlon and McCauley (1974), McCauley et al. (1976) at two hours; figures computed apart from this code.
  struct Row {
    double a, f, of_1974, of_1976;
  };
  constexpr std::array kTable{Row{0.05, 0.16, 11.41, 10.38}, Row{0.10, 0.10, 24.55, 22.65},
                              Row{0.10, 0.16, 32.54, 32.17}, Row{0.10, 0.25, 24.97, 23.08},
                              Row{0.20, 0.16, 61.79, 61.06}};
  for (const Row& row : kTable) {
    EXPECT_NEAR(percent_1974(row.a, row.f), row.of_1974, 0.1) << row.a << " g, " << row.f << " Hz";
    EXPECT_NEAR(percent_1976(row.a, row.f), row.of_1976, 0.1) << row.a << " g, " << row.f << " Hz";
  }
}

TEST(MotionSickness, TakesTheFrequencyOf1974InRadiansASecond) {
  // In Hz the same polynomial would make 0.0018 % of people sick at 0.1 g and 0.16 Hz.
  EXPECT_GT(percent_1974(0.10, 0.16), 30.0);
  const double worst = percent_1974(0.10, 1.0 / kTwoPi);  // at 1 rad/s, which is 0.159 Hz
  EXPECT_GT(worst, percent_1974(0.10, 0.95 / kTwoPi));
  EXPECT_GT(worst, percent_1974(0.10, 1.05 / kTwoPi));
}

TEST(MotionSickness, IsWorstAtTheSameFrequencyInBothModels) {
  double worst_f = 0.0;
  double worst = 0.0;
  for (double f = 0.10; f < 0.25; f += 0.0005) {
    if (percent_1976(0.1, f) > worst) {
      worst = percent_1976(0.1, f);
      worst_f = f;
    }
  }
  EXPECT_NEAR(worst_f, 1.0 / kTwoPi, 0.001);  // 0.1585 Hz by the polynomial's rounded figures
}

TEST(MotionSickness, GrowsWithMotionAndWithTime) {
  double before = 0.0;
  for (const double minutes : {10.0, 30.0, 60.0, 120.0, 240.0, 480.0}) {
    EXPECT_GT(percent_1976(0.1, 0.16, minutes), before);
    before = percent_1976(0.1, 0.16, minutes);
  }
  before = 0.0;
  for (const double a : {0.01, 0.05, 0.1, 0.3, 1.0}) {
    EXPECT_GT(percent_1976(a, 0.2), before);
    before = percent_1976(a, 0.2);
  }
}

TEST(MotionSickness, TakesTheMeanAndNotTheRmsOfTheAcceleration) {
  const VerticalShaking rms_of_a_tenth{0.1 * kStandardGravity, kTwoPi * 0.16};
  EXPECT_NEAR(motion_sickness(rms_of_a_tenth, 0.0), motion_sickness(shaking(0.0797885, 0.16), 0.0), 1e-6);
}

TEST(MotionSickness, MarginLandsOnTheLimit) {
  for (const double exposure : {0.0, 600.0, kTwoHours, 4.0 * 3600.0, 24.0 * 3600.0}) {
    for (const double limit : {1e-4, 0.01, 0.1, 0.2, 0.5, 0.95}) {
      for (const double a : {1e-3, 0.05, 0.6}) {
        VerticalShaking at = shaking(a, 0.2);
        at.rms_acceleration *= motion_sickness_margin(at, exposure, limit);
        EXPECT_NEAR(motion_sickness(at, exposure) / limit, 1.0, 1e-9)  // rounding of erfc
            << exposure << " s, limit " << limit << ", " << a << " g";
      }
    }
  }
}

TEST(MotionSickness, ComesToNobodyWhereNothingMoves) {
  for (const double exposure : {0.0, kTwoHours}) {
    EXPECT_EQ(motion_sickness({0.0, 1.0}, exposure), 0.0);
    EXPECT_EQ(motion_sickness(vertical_shaking(0.0, 0.0), exposure), 0.0);
    EXPECT_EQ(motion_sickness_margin({0.0, 1.0}, exposure, 0.1), std::numeric_limits<double>::infinity());
    EXPECT_GE(motion_sickness({1e-12, 1e-9}, exposure), 0.0);  // far out: small, and a number
    EXPECT_LT(motion_sickness({1e-12, 1e-9}, exposure), 1e-12);
  }
}

}  // namespace
}  // namespace quickstrip
