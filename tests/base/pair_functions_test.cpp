// Two at once against libm, whose own error is below one unit in the last place.
#include "core/base/pair_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace quickstrip {
namespace {

TEST(PairFunctions, SineAndCosineAreThoseOfTheLibraryWithinRounding) {
  double worst = 0.0;
  for (int i = -20000; i <= 20000; ++i) {
    const double x = 0.0123 * static_cast<double>(i);
    const SinCos at = sin_cos(pair_of(x, -0.5 * x));
    for (const double error : {at.sin[0] - std::sin(x), at.cos[0] - std::cos(x),
                               at.sin[1] - std::sin(-0.5 * x), at.cos[1] - std::cos(-0.5 * x)}) {
      worst = std::max(worst, std::fabs(error));
    }
  }
  EXPECT_LT(worst, 2.3e-16);  // one unit in the last place of a number near 1
  EXPECT_GT(worst, 0.0);      // not the same routine
}

TEST(PairFunctions, SineIsOddAndCosineEvenBitForBit) {
  for (int i = 0; i <= 2000; ++i) {
    const double x = 0.037 * static_cast<double>(i);
    const SinCos at = sin_cos(pair_of(x, -x));
    EXPECT_EQ(at.sin[0], -at.sin[1]);
    EXPECT_EQ(at.cos[0], at.cos[1]);
  }
}

TEST(PairFunctions, ExponentialAndLogarithmAreThoseOfTheLibraryWithinRounding) {
  double worst = 0.0;
  for (int i = -6000; i <= 6000; ++i) {
    const double x = 0.1101 * static_cast<double>(i);
    const Pair y = exponential(pair_of(x, 0.01 * x));
    worst =
        std::max({worst, std::fabs(y[0] / std::exp(x) - 1.0), std::fabs(y[1] / std::exp(0.01 * x) - 1.0)});
    const Pair back = logarithm(y);
    worst = std::max(worst, std::fabs(back[0] - std::log(y[0])) / std::max(1.0, std::fabs(x)));
    worst = std::max(worst, std::fabs(back[1] - std::log(y[1])) / std::max(1.0, std::fabs(0.01 * x)));
  }
  EXPECT_LT(worst, 4.5e-16);  // two units in the last place
}

TEST(PairFunctions, TheFarEndsOfTheExponentialStayFinite) {
  const Pair y = exponential(pair_of(-1e6, 1e6));
  EXPECT_GT(y[0], 0.0);
  EXPECT_LT(y[0], 1e-300);
  EXPECT_GT(y[1], 1e300);
  EXPECT_TRUE(std::isfinite(y[1]));
}

// What enters as no number leaves as none, in its own lane only.
TEST(PairFunctions, NoNumberStaysNoNumber) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const SinCos at = sin_cos(pair_of(none, 1.0));
  EXPECT_TRUE(std::isnan(at.sin[0]) && std::isnan(at.cos[0]));
  EXPECT_FALSE(std::isnan(at.sin[1]) || std::isnan(at.cos[1]));
}

}  // namespace
}  // namespace quickstrip
