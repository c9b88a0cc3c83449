// Bandwidth, maxima and crossings: closed forms, and a Gaussian record in which they are counted.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "core/base/constants.hpp"
#include "core/response/propeller_emergence.hpp"
#include "core/response/short_term.hpp"

namespace quickstrip {
namespace {

TEST(Bandwidth, OfASingleFrequencyIsZeroAndAllItsPeriodsAreOne) {
  const double w = 0.7;
  const double m0 = 2.0;
  EXPECT_NEAR(bandwidth(m0, m0 * w * w, m0 * w * w * w * w), 0.0, 2e-8);  // root of a rounding
  EXPECT_NEAR(crest_period(m0 * w * w, m0 * w * w * w * w), kTwoPi / w, 1e-12);
  EXPECT_EQ(bandwidth(0.0, 0.0, 0.0), 0.0);
  EXPECT_EQ(crest_period(0.0, 0.0), 0.0);
}

TEST(Bandwidth, OfBretschneiderCutAtAFrequencyIsTheClosedFormAndGrowsWithTheCut) {
  // S = A w^-5 exp(-B w^-4), x = B / cut^4: m0 = A/4B e^-x, m2 = A sqrt(pi/B)/4 erfc(sqrt x), m4 = A/4 E1(x).
  WaveSystem system;
  system.hs = 4.0;
  system.period = 10.0;
  const Result<Spectrum> spectrum = spectrum_of(system);
  ASSERT_TRUE(spectrum);
  const double b = 1.25 * std::pow(spectrum->peak_frequency, 4);
  double before = 0.0;
  for (const double cut : {2.0, 3.0, 5.0, 10.0, 30.0}) {
    const double to = cut * spectrum->peak_frequency;
    const double x = b / std::pow(to, 4);
    const double m0 = std::exp(-x) / (4.0 * b);
    const double m2 = std::sqrt(kPi / b) / 4.0 * std::erfc(std::sqrt(x));
    const double m4 = -std::expint(-x) / 4.0;
    const double computed =
        bandwidth(moment_between(*spectrum, 0, 0.0, to), moment_between(*spectrum, 2, 0.0, to),
                  moment_between(*spectrum, 4, 0.0, to));
    EXPECT_NEAR(computed, std::sqrt(1.0 - m2 * m2 / (m0 * m4)), 1e-7) << cut;  // quadrature 1e-9 of m_n
    EXPECT_GT(computed, before);
    before = computed;
  }
  EXPECT_NEAR(before, 0.8691, 1e-4);  // 30 peak frequencies, by hand: x = 1.543e-6, E1 = 12.805
}

TEST(Maxima, AreRayleighWhenNarrowAndHalfANormalDistributionWhenWide) {
  for (const double eta : {0.0, 0.5, 1.0, 2.0, 3.0}) {
    EXPECT_NEAR(maxima_exceedance(eta, 1.0, 0.0), std::exp(-0.5 * eta * eta), 1e-15);
    EXPECT_NEAR(maxima_exceedance(eta, 1.0, 1e-6), std::exp(-0.5 * eta * eta), 1e-6);
    EXPECT_NEAR(maxima_exceedance(2.0 * eta, 4.0, 1.0), std::erfc(eta / std::sqrt(2.0)), 1e-15);
  }
  EXPECT_EQ(maxima_exceedance(0.1, 0.0, 0.5), 0.0);
}

TEST(Maxima, AtTheLimitOfWideBandExceedAHighLevelFourFifthsAsOftenAsRayleigh) {
  EXPECT_NEAR(kWideBandwidth, std::sqrt(5.0) / 3.0, 1e-6);
  for (const double eta : {3.0, 4.0, 5.0}) {
    const double ratio = maxima_exceedance(eta, 1.0, kWideBandwidth) / std::exp(-0.5 * eta * eta);
    EXPECT_NEAR(ratio, 0.8, 0.002) << eta;  // the limit of high levels
  }
}

TEST(MostProbableMaximum, IsTheSameCountedByCrossingsAndByMaximaWhateverTheBandwidth) {
  const double m0 = 2.0;
  const double m2 = 0.9;
  const double hours = 3.0;
  for (const double epsilon : {0.2, 0.5, 0.8}) {
    const double alpha = std::sqrt(1.0 - epsilon * epsilon);
    const double positive = 3600.0 * hours / (2.0 * kTwoPi) * (1.0 + alpha) / alpha * std::sqrt(m2 / m0);
    const double level = most_probable_maximum(m0, m2, 3600.0 * hours);
    // exceeded once in all positive maxima
    EXPECT_NEAR(positive * maxima_exceedance(level, m0, epsilon), 1.0, 0.01) << epsilon;  // high-level limit
  }
  EXPECT_NEAR(most_probable_maximum(m0, m2, 1000.0 * zero_crossing_period(m0, m2)),
              std::sqrt(2.0 * m0 * std::log(1000.0)), 1e-12);
  EXPECT_EQ(most_probable_maximum(m0, m2, 0.5 * zero_crossing_period(m0, m2)), 0.0);
  EXPECT_EQ(most_probable_maximum(0.0, 0.0, 3600.0), 0.0);
}

TEST(MostProbableMaximum, GrowsWithTheWaveHeightAndScalesByFroude) {
  const double once = most_probable_maximum(2.0, 0.9, 7200.0);
  EXPECT_NEAR(most_probable_maximum(8.0, 3.6, 7200.0), 2.0 * once, 1e-12);  // waves twice as high
  const double lambda = 25.0;
  EXPECT_NEAR(most_probable_maximum(2.0 / (lambda * lambda), 0.9 / lambda, 7200.0 / std::sqrt(lambda)),
              once / lambda, 1e-12);
}

/// A Gaussian record of a flat spectrum between 0 and 1 rad/s: epsilon = 2/3 exactly, T2 = 2 pi sqrt(3) s.
struct Counted {
  double upcrossings_of_zero = 0.0;
  double upcrossings_of_two = 0.0;
  double positive_maxima = 0.0;
  double maxima_above = 0.0;  // 1.5 standard deviations
  double duration = 0.0;
};

Counted count_record(unsigned seed) {
  constexpr std::size_t kComponents = 300;
  constexpr double kStep = 0.25;  // s: T4 is 8.1 s, maxima are told apart
  constexpr int kSteps = 7000;    // 1,750 s: within the record's own period, 2 pi 300 s
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 1.0 / std::sqrt(double{kComponents}));
  std::vector<std::complex<double>> phasor(kComponents);
  std::vector<std::complex<double>> turn(kComponents);
  for (std::size_t i = 0; i < kComponents; ++i) {
    phasor[i] = {normal(random), normal(random)};
    turn[i] = std::polar(1.0, kStep * (static_cast<double>(i) + 0.5) / double{kComponents});
  }
  Counted out{.duration = kStep * kSteps};
  std::array<double, 3> x{};
  for (int n = 0; n < kSteps; ++n) {
    double sum = 0.0;
    for (std::size_t i = 0; i < kComponents; ++i) {
      phasor[i] *= turn[i];
      sum += phasor[i].real();
    }
    x = {x[1], x[2], sum};
    if (n < 2) {
      continue;
    }
    out.upcrossings_of_zero += x[1] < 0.0 && x[2] >= 0.0 ? 1.0 : 0.0;
    out.upcrossings_of_two += x[1] < 2.0 && x[2] >= 2.0 ? 1.0 : 0.0;
    if (x[1] > x[0] && x[1] >= x[2] && x[1] > 0.0) {
      out.positive_maxima += 1.0;
      out.maxima_above += x[1] > 1.5 ? 1.0 : 0.0;
    }
  }
  return out;
}

TEST(CountedRecord, CrossesLevelsAsRayleighSaysAndHasTheMaximaOfItsBandwidth) {
  Counted all;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const Counted one = count_record(seed);
    all.upcrossings_of_zero += one.upcrossings_of_zero;
    all.upcrossings_of_two += one.upcrossings_of_two;
    all.positive_maxima += one.positive_maxima;
    all.maxima_above += one.maxima_above;
    all.duration += one.duration;
  }
  const double m0 = 1.0;
  const double m2 = 1.0 / 3.0;
  const double m4 = 1.0 / 5.0;
  const double epsilon = bandwidth(m0, m2, m4);
  EXPECT_NEAR(epsilon, 2.0 / 3.0, 1e-12);
  // 8,000 crossings of zero, 1,090 of the level, 9,400 maxima: tolerances are four standard errors.
  EXPECT_NEAR(3600.0 * all.upcrossings_of_zero / all.duration / oscillations_per_hour(m0, m2), 1.0, 0.03);
  EXPECT_NEAR(all.upcrossings_of_two / all.upcrossings_of_zero / rayleigh_exceedance(2.0, m0), 1.0, 0.12);
  const double counted = all.maxima_above / all.positive_maxima;
  EXPECT_NEAR(counted, maxima_exceedance(1.5, m0, epsilon), 0.018);
  EXPECT_LT(counted, rayleigh_exceedance(1.5, m0) - 0.018);  // where "not too wide" fails
}

TEST(PropellerEmergence, IsRayleighOfTheDepthOfTheTipAndCertainWhenItIsOutAtRest) {
  EXPECT_NEAR(emergence_probability(3.0, 2.0), std::exp(-9.0 / 4.0), 1e-15);
  EXPECT_EQ(emergence_probability(0.0, 2.0), 1.0);
  EXPECT_EQ(emergence_probability(3.0, 0.0), 0.0);
  EXPECT_NEAR(emergences_per_hour(3.0, 2.0, 1.5),
              3600.0 / kTwoPi * std::sqrt(1.5 / 2.0) * std::exp(-9.0 / 4.0), 1e-12);
}

}  // namespace
}  // namespace quickstrip
