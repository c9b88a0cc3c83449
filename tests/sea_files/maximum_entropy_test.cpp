#include "sim/sea_files/maximum_entropy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

#include "core/base/angles.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;
constexpr double kStep = kTwoPi / static_cast<double>(kNumDirections);

Complex coefficient(const DirectionalDistribution& distribution, int n) {
  Complex c;
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    c += distribution.density[d] * kStep * std::polar(1.0, n * kStep * static_cast<double>(d));
  }
  return c;
}

TEST(MaximumEntropy, ReturnsTheCoefficientsItWasGiven) {
  for (const double r1 : {0.1, 0.5, 0.8, 0.93}) {
    for (const double alpha1_deg : {0.0, 47.0, 301.5}) {
      for (const double f2 : {0.0, 0.3, 0.7}) {  // of any phase: every admissible c2
        const Complex c1 = std::polar(r1, radians(alpha1_deg));
        const Complex c2 = c1 * c1 + (1.0 - r1 * r1) * std::polar(f2, radians(alpha1_deg + 70.0));
        const DirectionalDistribution d = maximum_entropy(c1, c2);
        EXPECT_FALSE(d.clamped);
        EXPECT_NEAR(std::abs(coefficient(d, 0) - 1.0), 0.0, 1e-12);
        // Poles of length 0.98 are needles of 2 degrees, which 5-degree directions widen.
        const double tolerance = r1 > 0.9 && f2 > 0.5 ? 0.02 : 1e-6;
        EXPECT_NEAR(std::abs(coefficient(d, 1) - c1), 0.0, tolerance);
        EXPECT_NEAR(std::abs(coefficient(d, 2) - c2), 0.0, tolerance);
        EXPECT_GT(*std::min_element(d.density.begin(), d.density.end()), 0.0);
      }
    }
  }
}

// f2 = 0 is a first-order process: D = (1 - r^2) / (2 pi (1 - 2 r cos(theta - alpha) + r^2)), the wrapped
// Cauchy distribution. The mean over 5 degrees differs from the point by (5 deg)^2 / 24 times the curvature:
// below 0.5 % for r = 0.6 at its peak.
TEST(MaximumEntropy, IsTheWrappedCauchyWhenTheSecondIsTheSquareOfTheFirst) {
  const double r = 0.6;
  const Complex c1 = std::polar(r, radians(100.0));
  const DirectionalDistribution d = maximum_entropy(c1, c1 * c1);
  for (std::size_t i = 0; i < kNumDirections; ++i) {
    const double angle = kStep * static_cast<double>(i) - radians(100.0);
    const double closed = (1.0 - r * r) / (kTwoPi * (1.0 - 2.0 * r * std::cos(angle) + r * r));
    EXPECT_NEAR(d.density[i], closed, 5e-3 * closed);
  }
}

TEST(MaximumEntropy, WithoutCoefficientsIsIsotropic) {
  const DirectionalDistribution d = maximum_entropy(0.0, 0.0);
  for (const double value : d.density) {
    EXPECT_NEAR(value, 1.0 / kTwoPi, 1e-12);
  }
}

// r1 = 0.9, r2 = 0.7: (1/pi) (1/2 + r1 cos + r2 cos 2) is negative at 90 degrees.
TEST(MaximumEntropy, StaysPositiveWhereTheSeriesCutAfterTwoTermsDoesNot) {
  const double r1 = 0.9;
  const double r2 = 0.7;
  double least_of_series = 1.0;
  for (std::size_t i = 0; i < kNumDirections; ++i) {
    const double angle = kStep * static_cast<double>(i);
    least_of_series =
        std::min(least_of_series, (0.5 + r1 * std::cos(angle) + r2 * std::cos(2.0 * angle)) / kPi);
  }
  EXPECT_LT(least_of_series, 0.0);
  const DirectionalDistribution d = maximum_entropy(r1, r2);
  EXPECT_GT(*std::min_element(d.density.begin(), d.density.end()), 0.0);
}

TEST(MaximumEntropy, TellsTwoOpposedWaveTrainsApart) {
  // Equal trains from 40 and 220 degrees: c1 = 0, c2 = r2 e^{2 i 40 deg}.
  const DirectionalDistribution d = maximum_entropy(0.0, std::polar(0.8, radians(80.0)));
  EXPECT_EQ(std::max_element(d.density.begin(), d.density.begin() + 36) - d.density.begin(), 8);
  EXPECT_NEAR(d.density[8], d.density[44], 1e-9);
  EXPECT_GT(d.density[8], 5.0 * d.density[26]);
}

TEST(MaximumEntropy, BringsInWhatNoDistributionHasAndSaysSo) {
  for (const auto& [c1, c2] :
       {std::pair<Complex, Complex>{0.2, {0.0, 1.0}}, {1.0, 0.3}, {{0.4, 0.4}, -0.99}}) {
    const DirectionalDistribution d = maximum_entropy(c1, c2);
    EXPECT_TRUE(d.clamped);
    EXPECT_NEAR(std::abs(coefficient(d, 0) - 1.0), 0.0, 1e-12);
    EXPECT_GT(*std::min_element(d.density.begin(), d.density.end()), 0.0);
  }
}

TEST(MaximumEntropy, TurnsByGridSteps) {
  const Complex c1 = std::polar(0.7, radians(33.0));
  const Complex c2 = std::polar(0.4, radians(50.0));
  const Complex turn = std::polar(1.0, 7.0 * kStep);
  const DirectionalDistribution first = maximum_entropy(c1, c2);
  const DirectionalDistribution turned = maximum_entropy(c1 * turn, c2 * turn * turn);
  for (std::size_t i = 0; i < kNumDirections; ++i) {
    EXPECT_NEAR(turned.density[(i + 7) % kNumDirections], first.density[i], 1e-8);
  }
}

}  // namespace
}  // namespace quickstrip
