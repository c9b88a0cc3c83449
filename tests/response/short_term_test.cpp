#include "core/response/short_term.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/constants.hpp"
#include "core/response/deck_wetness.hpp"
#include "core/response/slamming.hpp"

namespace quickstrip {
namespace {

TEST(ShortTerm, SignificantAmplitudeIsTheMeanOfTheHighestThirdOfARayleighDistribution) {
  // Integrated here: a_third from P(a > a_third) = 1/3, then the mean above it.
  const double m0 = 2.3;
  const double from = std::sqrt(2.0 * m0 * std::log(3.0));
  double mean = 0.0;
  const double da = 1e-4;
  for (double a = from; a < 12.0 * std::sqrt(m0); a += da) {
    const double middle = a + 0.5 * da;
    mean += 3.0 * middle * (middle / m0) * std::exp(-middle * middle / (2.0 * m0)) * da;
  }
  EXPECT_NEAR(significant_amplitude(m0), mean, 0.0015 * mean);  // 2 stands for 2.0024
}

TEST(ShortTerm, ExceedanceAtTheSignificantAmplitudeIsEToTheMinusTwo) {
  EXPECT_NEAR(rayleigh_exceedance(significant_amplitude(0.7), 0.7), std::exp(-2.0), 1e-15);
}

TEST(ShortTerm, NothingIsExceededWithoutMotionAndAPeriodOfZeroSaysSo) {
  EXPECT_EQ(rayleigh_exceedance(0.1, 0.0), 0.0);
  EXPECT_EQ(rayleigh_exceedance(0.0, 0.0), 1.0);
  EXPECT_EQ(mean_period(0.0, 0.0), 0.0);
  EXPECT_EQ(zero_crossing_period(0.0, 0.0), 0.0);
  EXPECT_EQ(oscillations_per_hour(0.0, 0.0), 0.0);
}

TEST(ShortTerm, PeriodsOfASingleFrequencyAreItsPeriod) {
  const double omega_e = 0.63;
  const double m0 = 1.7;
  EXPECT_NEAR(mean_period(m0, m0 * omega_e), kTwoPi / omega_e, 1e-13);
  EXPECT_NEAR(zero_crossing_period(m0, m0 * omega_e * omega_e), kTwoPi / omega_e, 1e-13);
  EXPECT_NEAR(oscillations_per_hour(m0, m0 * omega_e * omega_e), 3600.0 * omega_e / kTwoPi, 1e-10);
}

TEST(Slamming, ThresholdIsTwelveFeetPerSecondAt520Feet) {
  const double threshold = ochi_threshold_velocity(520.0 * 0.3048, kStandardGravity);
  EXPECT_NEAR(threshold, 12.0 * 0.3048, 0.002);  // 0.0928 is rounded to three figures
  EXPECT_NEAR(threshold, 3.6588, 5e-4);          // computed by hand: 0.0928 sqrt(9.80665 x 158.496)
}

TEST(Slamming, ProbabilityAndRateMeetTheHandComputedVector) {
  // Typed from a worked example: m0 1.5 m2, m2 1.2 m2/s2, draught 5 m, threshold 3.6 m/s.
  EXPECT_NEAR(slamming_probability(5.0, 3.6, 1.5, 1.2), 1.0856e-6, 5e-11);  // its last figure
  EXPECT_NEAR(slams_per_hour(5.0, 3.6, 1.5, 1.2), 5.5636e-4, 5e-9);
}

TEST(Slamming, CannotHappenInACalmAndIsCertainWithTheKeelOutOfTheWaterAndNoThreshold) {
  EXPECT_EQ(slamming_probability(5.0, 3.6, 0.0, 0.0), 0.0);
  EXPECT_EQ(slams_per_hour(5.0, 3.6, 0.0, 0.0), 0.0);
  EXPECT_EQ(slamming_probability(0.0, 0.0, 1.0, 1.0), 1.0);
}

TEST(Slamming, ExponentIsFiniteAlsoForTinyVariances) {
  EXPECT_TRUE(std::isfinite(slamming_exponent(5.0, 3.6, 1e-300, 1e-300)));
  EXPECT_TRUE(std::isfinite(slamming_exponent(5.0, 3.6, 0.0, 0.0)));
}

TEST(Slamming, IsTheSameForAModelScaledByFroude) {
  const double lambda = 40.0;  // lengths; velocities by its root, rates by its inverse root
  const double ship = slamming_probability(5.0, ochi_threshold_velocity(150.0, kStandardGravity), 6.0, 3.0);
  const double model =
      slamming_probability(5.0 / lambda, ochi_threshold_velocity(150.0 / lambda, kStandardGravity),
                           6.0 / (lambda * lambda), 3.0 / lambda);
  EXPECT_NEAR(model, ship, 1e-12 * ship);
  EXPECT_NEAR(slams_per_hour(5.0 / lambda, 2.0 / std::sqrt(lambda), 6.0 / (lambda * lambda), 3.0 / lambda),
              std::sqrt(lambda) * slams_per_hour(5.0, 2.0, 6.0, 3.0), 1e-9);
}

TEST(Slamming, TwoEqualSystemsOfOnePercentEachMakeTenPercentTogether) {
  // Variances add before any probability is taken: the exponent halves, so P = sqrt(0.01).
  const double m0 = 5.0 * 5.0 / (2.0 * std::log(100.0));
  EXPECT_NEAR(wetness_probability(5.0, m0), 0.01, 1e-15);
  EXPECT_NEAR(wetness_probability(5.0, m0 + m0), 0.10, 1e-15);
  EXPECT_NEAR(slamming_probability(5.0, 0.0, m0 + m0, 1.0), 0.10, 1e-15);
}

TEST(DeckWetness, RateIsProbabilityTimesCrossings) {
  EXPECT_NEAR(wetnesses_per_hour(4.0, 2.0, 1.1),
              3600.0 / kTwoPi * std::sqrt(1.1 / 2.0) * std::exp(-16.0 / 4.0), 1e-12);
}

}  // namespace
}  // namespace quickstrip
