// Grim's effective wave: the wave of the ship's length with a crest or trough amidships that fits an
// irregular sea along the hull best, by least squares. Its amplitude is the linear operator
//   (2/L) int cos(k x) cos(2 pi x / L) dx over the length = 2 x sin x / (pi^2 - x^2),  x = k_x L / 2,
// k_x = omega^2 |cos mu| / g the wave number along the hull; 1 at x = pi. Its height is taken as
// 5.9725 sqrt(m0): the mean of the highest 3 % (tests/hazard derives it).
// Sources: [Grim1961], [IMO2020]. No state; a sine a frequency.
#pragma once

#include <cmath>

#include "core/base/constants.hpp"

namespace quickstrip {

/// Height over sqrt(m0): sqrt(8) (sqrt(ln N) + N sqrt(pi)/2 erfc(sqrt(ln N))), N = 1/0.03.
inline constexpr double kEffectiveHeight = 5.97253;

/// Variance of the effective amplitude over that of the wave, at x = k_x L / 2 >= 0.
inline double effective_wave_filter(double x) {
  const double apart = kPi - x;
  // Near pi: sin x = sin(pi - x), and 2 x / (pi + x) sinc(pi - x) has no zero over zero.
  const double sinc = std::fabs(apart) < 1e-4 ? 1.0 - apart * apart / 6.0 : std::sin(apart) / apart;
  const double operator_value = 2.0 * x / (kPi + x) * sinc;
  return operator_value * operator_value;
}

/// Mean of the highest 3 % of the effective waves' heights [m]; m0 of their amplitude [m2].
inline double effective_height(double m0) {
  return kEffectiveHeight * std::sqrt(m0);
}

}  // namespace quickstrip
