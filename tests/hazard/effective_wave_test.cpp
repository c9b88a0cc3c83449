// Grim's effective wave: the operator against the least-squares fit that it is, and the 5.9725 derived.
#include "core/hazard/effective_wave.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quickstrip {
namespace {

// Projection of cos(kx) on cos(2 pi x / L) over the length, by Simpson's rule.
double fitted_amplitude(double k_half_length) {
  constexpr int kPanels = 2000;
  double sum = 0.0;
  for (int i = 0; i <= kPanels; ++i) {
    const double s = -1.0 + 2.0 * i / kPanels;  // x / (L/2)
    const double weight = i == 0 || i == kPanels ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * std::cos(k_half_length * s) * std::cos(kPi * s);
  }
  return sum * (2.0 / kPanels) / 3.0;
}

TEST(EffectiveWave, IsTheLeastSquaresFitOfTheWaveOfShipLength) {
  for (const double x : {0.05, 0.4, 1.0, 2.5, kPi - 1e-3, kPi, kPi + 1e-3, 4.0, 6.0, 9.5}) {
    const double fit = fitted_amplitude(x);
    EXPECT_NEAR(effective_wave_filter(x), fit * fit, 1e-10) << x;  // Simpson's rule on 2,000 panels
  }
  EXPECT_EQ(effective_wave_filter(kPi), 1.0);  // the limit of [IMO2020]'s form, which is 0/0 there
}

TEST(EffectiveWave, IsTheFormOfTheGuidelines) {
  const double length = 140.0;
  for (const double omega : {0.2, 0.45, 0.6, 0.9}) {
    const double x = omega * omega * length / kStandardGravity;  // omega^2 L / g
    const double theirs = x * std::sin(0.5 * x) / (kPi * kPi - 0.25 * x * x);
    EXPECT_NEAR(effective_wave_filter(0.5 * x), theirs * theirs, 1e-13);
  }
}

// Heights of a narrow band are twice Rayleigh amplitudes: P(H > h) = exp(-h^2 / (8 m0)). The mean of the
// highest part p is the mean over h above h_p = sqrt(8 m0 ln(1/p)):
//   h_p + (1/p) int_{h_p}^inf exp(-h^2/8 m0) dh = sqrt(8 m0) (sqrt(ln N) + N sqrt(pi)/2 erfc(sqrt(ln N))).
TEST(EffectiveWave, HeightIsTheMeanOfTheHighestThreePerCent) {
  const double n = 1.0 / 0.03;
  const double root = std::sqrt(std::log(n));
  const double derived = std::sqrt(8.0) * (root + n * 0.5 * std::sqrt(kPi) * std::erfc(root));
  EXPECT_NEAR(kEffectiveHeight, derived, 5e-6);  // as printed
  EXPECT_NEAR(kEffectiveHeight, 5.9725, 5e-5);   // [IMO2020]
  // The same formula gives the significant height for the highest third: 4.004 sqrt(m0).
  const double third = std::sqrt(std::log(3.0));
  EXPECT_NEAR(std::sqrt(8.0) * (third + 3.0 * 0.5 * std::sqrt(kPi) * std::erfc(third)), 4.0043, 1e-4);
}

}  // namespace
}  // namespace quickstrip
