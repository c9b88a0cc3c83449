#include "core/sea/spreading.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

constexpr double kStepDeg = 360.0 / static_cast<double>(kNumDirections);

struct Circular {
  double sum = 0.0;
  double mean_deg = 0.0;
  double spreading_deg = 0.0;
};

Circular circular(const DirectionWeights& weights) {
  double sum = 0.0;
  double c = 0.0;
  double s = 0.0;
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    const double angle = radians(kStepDeg * static_cast<double>(d));
    sum += weights[d];
    c += weights[d] * std::cos(angle);
    s += weights[d] * std::sin(angle);
  }
  return {sum, degrees(std::atan2(s, c)), degrees(std::sqrt(std::fmax(0.0, 2.0 - 2.0 * std::hypot(c, s))))};
}

DirectionWeights weights(double from_deg, double spreading_deg) {
  return *direction_weights(WaveFrom{radians(from_deg)}, radians(spreading_deg));
}

// s 1: 57.3; 2: 46.8; 5: 33.1; 10: 24.4; 15: 20.3; 25: 15.9 degrees, three printed digits.
TEST(Spreading, ExponentIsThatOfTheListOfWidths) {
  constexpr std::array<std::array<double, 2>, 6> kList = {
      {{1, 57.3}, {2, 46.8}, {5, 33.1}, {10, 24.4}, {15, 20.3}, {25, 15.9}}};
  for (const auto& [s, sigma_deg] : kList) {
    // 0.05 degrees of rounding: 2 * 0.05 / sigma of s + 1.
    EXPECT_NEAR(spreading_exponent(radians(sigma_deg)), s, (s + 1.0) * 0.1 / sigma_deg);
  }
}

TEST(Spreading, GridKeepsEnergyMeanAndCircularDeviation) {
  for (const double from_deg : {0.0, 31.0, 92.5, 178.8, -90.0, 359.9}) {
    for (const double spreading_deg : {3.0, 8.0, 20.0, 31.5, 57.3, 75.0}) {
      const Circular c = circular(weights(from_deg, spreading_deg));
      EXPECT_NEAR(c.sum, 1.0, 1e-14);
      EXPECT_NEAR(std::remainder(c.mean_deg - from_deg, 360.0), 0.0, 2e-3);
      // Narrow needles: the hat's spreading depends on where they fall, 3 degrees by up to 0.5. Below s = 1
      // D has a cusp opposite the mean, inside an interval: 0.03 degrees.
      const double tolerance = spreading_deg < 5.0 ? 0.6 : (spreading_deg > 60.0 ? 0.05 : 1e-3);
      EXPECT_NEAR(c.spreading_deg, spreading_deg, tolerance);
    }
  }
}

// The mean of cos^2 of the angle to the mean is (1 + c2)/2, c2 = s (s-1) / ((s+1)(s+2)); the hat takes
// 1 - (5 deg)^2 / 3 = 0.25 % of c2, less what the narrower D gives back.
TEST(Spreading, SecondHarmonicIsThatOfCosine2s) {
  const double s = 5.0;
  const double sigma_deg = degrees(std::sqrt(2.0 / (s + 1.0)));
  const DirectionWeights w = weights(0.0, sigma_deg);
  double c2 = 0.0;
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    c2 += w[d] * std::cos(2.0 * radians(kStepDeg * static_cast<double>(d)));
  }
  EXPECT_NEAR(c2, s * (s - 1.0) / ((s + 1.0) * (s + 2.0)), 2e-3);
}

TEST(Spreading, WidestIsTheSameFromEverywhere) {
  const DirectionWeights widest = *direction_weights(WaveFrom{1.0}, std::sqrt(2.0));
  for (const double w : widest) {
    EXPECT_NEAR(w, 1.0 / static_cast<double>(kNumDirections), 1e-12);
  }
}

TEST(Spreading, LongCrestedOnTheGridIsOneDirection) {
  const DirectionWeights w = weights(85.0, 0.0);
  EXPECT_EQ(w[17], 1.0);
  EXPECT_EQ(circular(w).sum, 1.0);
}

// Split by distance: 1.25 degrees past 85 of 5.
TEST(Spreading, LongCrestedBetweenTwoDirectionsIsSplitByDistance) {
  const DirectionWeights w = weights(86.25, 0.0);
  EXPECT_NEAR(w[17], 0.75, 1e-6);
  EXPECT_NEAR(w[18], 0.25, 1e-6);
  EXPECT_NEAR(w[17] + w[18], 1.0, 1e-15);
  EXPECT_NEAR(circular(w).mean_deg, 86.25, 1e-3);  // a chord against the circle
  const DirectionWeights north = weights(359.0, 0.0);
  EXPECT_NEAR(north[71], 0.2, 1e-6);
  EXPECT_NEAR(north[0], 0.8, 1e-6);
}

TEST(Spreading, NarrowingGoesOverIntoTheNeedleWithoutAJump) {
  const DirectionWeights narrow = weights(86.25, 2.1);
  const DirectionWeights needle = weights(86.25, 0.0);
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    EXPECT_NEAR(narrow[d], needle[d], 0.02);
  }
}

TEST(Spreading, IsMirroredAboutTheMean) {
  for (const double spreading_deg : {0.0, 4.0, 30.0}) {
    const DirectionWeights starboard = weights(37.0, spreading_deg);
    const DirectionWeights port = weights(-37.0, spreading_deg);
    for (std::size_t d = 0; d < kNumDirections; ++d) {
      EXPECT_NEAR(starboard[d], port[(kNumDirections - d) % kNumDirections], 1e-15);
    }
  }
}

TEST(Spreading, TurnsWithTheDirectionBitForBit) {
  for (const double spreading_deg : {0.0, 4.0, 30.0}) {
    const DirectionWeights first = weights(37.3, spreading_deg);
    for (std::size_t k = 0; k < kNumDirections; ++k) {
      const DirectionWeights turned = weights(37.3 + 5.0 * static_cast<double>(k), spreading_deg);
      for (std::size_t d = 0; d < kNumDirections; ++d) {
        EXPECT_EQ(turned[(d + k) % kNumDirections], first[d]);
      }
    }
  }
}

TEST(Spreading, RefusesWhatIsNoSpreading) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(direction_weights(WaveFrom{nan}, 0.5).error(), Error::kNotFinite);
  EXPECT_EQ(direction_weights(WaveFrom{1.0}, nan).error(), Error::kNotFinite);
  EXPECT_EQ(direction_weights(WaveFrom{1.0}, -0.1).error(), Error::kOutOfRange);
  EXPECT_EQ(direction_weights(WaveFrom{1.0}, 1.5).error(), Error::kOutOfRange);
  EXPECT_EQ(direction_weights(WaveFrom{1e9}, 0.5).error(), Error::kOutOfRange);
}

}  // namespace
}  // namespace quickstrip
