// Crossings of levels, counted on series whose crossings are known.
#include "sim/seaway/crossings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/constants.hpp"
#include "sim/seaway/fourier.hpp"
#include "sim/seaway/gaussian.hpp"

namespace quickstrip::seaway {
namespace {

std::vector<double> sine(double amplitude, int cycles, std::size_t samples) {
  std::vector<double> x(samples);
  for (std::size_t j = 0; j < samples; ++j) {
    x[j] =
        amplitude * std::sin(kTwoPi * cycles * static_cast<double>(j) / static_cast<double>(samples) + 0.3);
  }
  return x;
}

TEST(Crossings, OfASineComeWhereTheyAreAndAsFast) {
  constexpr std::size_t kSamples = 4000;
  constexpr int kCycles = 200;  // 20 samples each: omega dt = 0.31
  constexpr double kDt = 0.5;
  const std::vector<double> x = sine(2.0, kCycles, kSamples);
  const double omega = kTwoPi * kCycles / (kDt * static_cast<double>(kSamples));
  std::vector<Crossing> found;
  list_crossings(x, kDt, 1.0, 1.0, found);
  ASSERT_EQ(found.size(), 200U);
  // sin = 1/2 at pi/6, where the slope is 2 omega cos(pi/6). Cubic interpolation: (omega dt)^4 / 40.
  EXPECT_NEAR(found[0].time, (kPi / 6.0 - 0.3) / omega, 1e-3);
  for (const Crossing& crossing : found) {
    EXPECT_NEAR(crossing.speed, 2.0 * omega * std::sqrt(0.75), 3e-3 * omega);
  }
  list_crossings(x, kDt, 1.0, -1.0, found);  // the mirror image
  ASSERT_EQ(found.size(), 200U);
  EXPECT_NEAR(found[0].time, (kPi + kPi / 6.0 - 0.3) / omega, 1e-3);
}

TEST(Crossings, AShortExcursionBetweenTwoSamplesCounts) {
  constexpr std::size_t kSamples = 4000;
  constexpr int kCycles = 190;  // samples meet the crest everywhere
  const std::vector<double> x = sine(1.0, kCycles, kSamples);
  std::vector<Crossing> found;
  list_crossings(x, 1.0, 0.999, 1.0, found);                     // above for 2.8 % of a cycle: 0.6 samples
  EXPECT_NEAR(static_cast<double>(found.size()), kCycles, 3.0);  // parabola: 1e-3 of the crest
}

TEST(Crossings, NothingIsCrossedByWhatStaysBelow) {
  std::vector<Crossing> found = {{1.0, 1.0}};
  list_crossings(sine(1.0, 3, 200), 1.0, 1.01, 1.0, found);
  EXPECT_TRUE(found.empty());
}

TEST(Crossings, EncountersWithAnEventAreCountedOnce) {
  const std::vector<Crossing> zeros = {{10.0, 1.0}, {20.0, 1.0}, {30.0, 1.0}};
  const std::vector<Crossing> events = {{12.0, 1.0}, {13.0, 1.0}, {31.0, 1.0}};
  EXPECT_EQ(encounters_with_event(zeros, events), 2U);
  EXPECT_EQ(encounters_with_event(zeros, std::vector<Crossing>{{5.0, 1.0}}), 1U);  // of the last encounter
  EXPECT_EQ(encounters_with_event({}, events), 0U);
}

// Rice's formula: a Gaussian process crosses a level nu_0 exp(-level^2 / 2 m0) times a second, whatever its
// bandwidth; and its speed there is Rayleigh's, so the share of crossings faster than v is exp(-v^2 / 2 m2).
TEST(Crossings, OfAGaussianProcessAreRicesAndTheirSpeedsRayleighs) {
  constexpr std::size_t kSamples = 1U << 18U;
  constexpr double kDt = 0.5;
  const double step = kTwoPi / (kDt * static_cast<double>(kSamples));
  Gaussian random(5, 0);
  std::vector<Complex> amplitude(kSamples / 2);
  double m0 = 0.0;
  double m2 = 0.0;
  for (std::size_t n = 1; n < amplitude.size(); ++n) {
    const double omega = step * static_cast<double>(n);
    const double energy = std::pow(omega, -5.0) * std::exp(-0.2 / std::pow(omega, 4));  // a wave spectrum
    if (omega > 2.0) {
      break;  // omega dt = 1 at most
    }
    const Gaussian::Pair p = random.pair();
    amplitude[n] = std::sqrt(energy) * Complex(p.first, p.second);
    m0 += energy;
    m2 += omega * omega * energy;
  }
  std::vector<double> x(kSamples);
  Fourier(kSamples).series(amplitude, {}, x, {});
  std::vector<Crossing> found;
  const double duration = kDt * static_cast<double>(kSamples);
  const double expected_zeros = duration / kTwoPi * std::sqrt(m2 / m0);  // some 16,000
  list_crossings(x, kDt, 0.0, 1.0, found);
  EXPECT_NEAR(static_cast<double>(found.size()) / expected_zeros, 1.0, 0.015);  // 3 standard errors
  for (const double level : {1.0, 2.0}) {
    list_crossings(x, kDt, level * std::sqrt(m0), 1.0, found);
    const double expected = expected_zeros * std::exp(-0.5 * level * level);
    EXPECT_NEAR(static_cast<double>(found.size()) / expected, 1.0, 5.0 / std::sqrt(expected));  // in groups
    double fast = 0.0;
    for (const Crossing& crossing : found) {
      fast += crossing.speed > std::sqrt(m2) ? 1.0 : 0.0;
    }
    EXPECT_NEAR(fast / static_cast<double>(found.size()), std::exp(-0.5), 2.5 / std::sqrt(expected));
  }
}

}  // namespace
}  // namespace quickstrip::seaway
