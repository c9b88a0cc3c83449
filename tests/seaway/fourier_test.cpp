// Transforms and random numbers of the simulated seaway.
#include "sim/seaway/fourier.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/base/constants.hpp"
#include "sim/seaway/gaussian.hpp"

namespace quickstrip::seaway {
namespace {

constexpr double kRounding = 1e-12;

TEST(Fourier, TwoSeriesAreTheCosinesTheyWereMadeOf) {
  constexpr std::size_t kSamples = 64;
  Fourier fourier(kSamples);
  std::vector<Complex> first(kSamples / 2);
  std::vector<Complex> second(kSamples / 2);
  first[0] = 0.5;
  first[3] = {1.0, -2.0};
  second[5] = {0.3, 0.7};
  std::vector<double> x(kSamples);
  std::vector<double> y(kSamples);
  fourier.series(first, second, x, y);
  for (std::size_t j = 0; j < kSamples; ++j) {
    const double t = kTwoPi * static_cast<double>(j) / static_cast<double>(kSamples);
    EXPECT_NEAR(x[j], 0.5 + std::cos(3.0 * t) + 2.0 * std::sin(3.0 * t), kRounding);
    EXPECT_NEAR(y[j], 0.3 * std::cos(5.0 * t) - 0.7 * std::sin(5.0 * t), kRounding);
  }
}

TEST(Fourier, AmplitudesComeBack) {
  constexpr std::size_t kSamples = 1024;
  Fourier fourier(kSamples);
  Gaussian random(3, 0);
  std::vector<Complex> amplitudes(kSamples / 2);
  for (Complex& amplitude : amplitudes) {
    const Gaussian::Pair pair = random.pair();
    amplitude = {pair.first, pair.second};
  }
  amplitudes[0].imag(0.0);  // a mean is real
  std::vector<double> x(kSamples);
  fourier.series(amplitudes, {}, x, {});
  std::vector<Complex> back(kSamples / 2);
  fourier.amplitudes(x, back);
  for (std::size_t n = 0; n < back.size(); ++n) {
    EXPECT_NEAR(std::abs(back[n] - amplitudes[n]), 0.0, kRounding);
  }
}

TEST(Gaussian, HasTheMomentsOfANormalDistribution) {
  constexpr int kPairs = 500'000;
  Gaussian random(1, 2);
  double sum = 0.0;
  double square = 0.0;
  double fourth = 0.0;
  double product = 0.0;
  int beyond_2 = 0;
  for (int i = 0; i < kPairs; ++i) {
    const Gaussian::Pair p = random.pair();
    for (const double v : {p.first, p.second}) {
      sum += v;
      square += v * v;
      fourth += v * v * v * v;
      beyond_2 += std::fabs(v) > 2.0 ? 1 : 0;
    }
    product += p.first * p.second;
  }
  constexpr double kNumbers = 2.0 * kPairs;
  // Four standard errors: 1/sqrt(n), sqrt(2/n), sqrt(96/n), 1/sqrt(n/2), sqrt(p q/n).
  EXPECT_NEAR(sum / kNumbers, 0.0, 4e-3);
  EXPECT_NEAR(square / kNumbers, 1.0, 6e-3);
  EXPECT_NEAR(fourth / kNumbers, 3.0, 4e-2);
  EXPECT_NEAR(product / kPairs, 0.0, 6e-3);
  EXPECT_NEAR(beyond_2 / kNumbers, 0.0455, 9e-4);
}

TEST(Gaussian, StreamsAndSeedsDiffer) {
  const double value = Gaussian(1, 0).pair().first;
  EXPECT_EQ(Gaussian(1, 0).pair().first, value);
  EXPECT_NE(Gaussian(1, 1).pair().first, value);
  EXPECT_NE(Gaussian(2, 0).pair().first, value);
}

}  // namespace
}  // namespace quickstrip::seaway
