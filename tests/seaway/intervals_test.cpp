// Intervals: quantiles against tables, coverage against synthetic counts whose rate is known.
#include "sim/seaway/intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim/seaway/gaussian.hpp"

namespace quickstrip::seaway {
namespace {

TEST(GammaQuantile, IsHalfOfChiSquares) {
  // [AbramowitzStegun1964] table 26.8: chi-square quantiles of 2, 10 and 100 degrees of freedom.
  EXPECT_NEAR(2.0 * gamma_quantile(1.0, 0.95), 5.99146, 1e-5);
  EXPECT_NEAR(2.0 * gamma_quantile(5.0, 0.05), 3.94030, 1e-5);
  EXPECT_NEAR(2.0 * gamma_quantile(50.0, 0.95), 124.342, 1e-3);
  // Large shapes tend to the normal distribution (Wilson-Hilferty).
  const double shape = 1e5;
  const double cube = std::pow(1.0 - 1.0 / (9.0 * shape) + 1.6448536 / std::sqrt(9.0 * shape), 3);
  EXPECT_NEAR(gamma_quantile(shape, 0.95) / (shape * cube), 1.0, 1e-6);
}

TEST(StudentQuantile, IsTheTables) {
  EXPECT_NEAR(student_quantile_95(3), 2.353, 0.02);
  EXPECT_NEAR(student_quantile_95(10), 1.812, 0.001);
  EXPECT_NEAR(student_quantile_95(100), 1.660, 0.001);
}

double poisson(double mean, Gaussian& random) {
  double count = -1.0;
  for (double sum = 0.0; sum < mean; sum -= std::log(1.0 - random.uniform())) {
    count += 1.0;
  }
  return count;
}

// Share of runs whose interval holds the true rate. Events come in groups of `group`.
double coverage(double mean_per_block, std::size_t blocks, double group, int runs) {
  Gaussian random(11, static_cast<std::uint64_t>(1000.0 * mean_per_block + group));
  int covered = 0;
  for (int r = 0; r < runs; ++r) {
    std::vector<BlockCount> counts(blocks);
    for (BlockCount& block : counts) {
      block.events = group * poisson(mean_per_block / group, random);
      block.exposure = 100.0;
    }
    const auto interval = ratio_interval(counts);
    const double truth = mean_per_block / 100.0;
    covered += interval && truth >= interval->low && truth <= interval->high ? 1 : 0;
  }
  return static_cast<double>(covered) / runs;
}

TEST(RatioInterval, CoversItsShareOfRuns) {
  constexpr int kRuns = 2000;  // standard error of the coverage 0.7 %
  for (const double group : {1.0, 3.0}) {
    for (const double mean : {0.15, 1.0, 20.0}) {
      // 50 blocks: 7 events, in two or three groups, at the least. Jeffreys' interval swings about its
      // nominal share by some per cent for small counts.
      const double share = coverage(mean, 50, group, kRuns);
      EXPECT_GT(share, mean * 50.0 / group < 5.0 ? 0.75 : 0.85) << mean << " in groups of " << group;
      EXPECT_LT(share, 0.95) << mean << " in groups of " << group;
    }
  }
  EXPECT_NEAR(coverage(20.0, 8, 1.0, kRuns), 0.90, 0.04);  // few blocks
}

TEST(RatioInterval, WithoutEventsSaysHowManyThereMayBe) {
  const std::vector<BlockCount> none(10, {0.0, 500.0});
  const auto interval = ratio_interval(none);
  ASSERT_TRUE(interval.has_value());
  EXPECT_EQ(interval->low, 0.0);
  EXPECT_GT(interval->high, 0.0);
  EXPECT_LT(interval->high, 3.0 / 5000.0);  // the 95 % bound of no event among 5,000
}

TEST(RatioInterval, NeedsBlocksAndEncounters) {
  EXPECT_FALSE(ratio_interval(std::vector<BlockCount>(3, {1.0, 10.0})).has_value());
  EXPECT_FALSE(ratio_interval(std::vector<BlockCount>(30, {0.0, 0.0})).has_value());
  EXPECT_FALSE(ratio_interval({}).has_value());
}

}  // namespace
}  // namespace quickstrip::seaway
