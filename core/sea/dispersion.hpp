// Deep-water waves: wave number, length, and the frequency at which a ship meets them.
// Assumes linear waves in deep water (depth above half a wave length). SI, radians. Exact, no state.
// Source: [Journee1992] §2; signs in core/NOTATION.md.
#pragma once

#include <cmath>

#include "core/base/angles.hpp"
#include "core/base/constants.hpp"

namespace quickstrip {

/// k = omega^2 / g [rad/m]; omega >= 0 [rad/s], gravity > 0 [m/s2].
inline constexpr double wave_number(double omega, double gravity = kStandardGravity) {
  return omega * omega / gravity;
}

/// omega = sqrt(g k) [rad/s]; k >= 0 [rad/m].
inline double wave_frequency(double wave_number_value, double gravity = kStandardGravity) {
  return std::sqrt(gravity * wave_number_value);
}

/// lambda = 2 pi g / omega^2 [m]; omega > 0.
inline constexpr double wave_length(double omega, double gravity = kStandardGravity) {
  return kTwoPi * gravity / (omega * omega);
}

/// omega_e = omega - k V cos mu [rad/s], signed: negative when the ship overtakes the waves. V >= 0 [m/s].
inline double encounter_frequency(double omega, double wave_number_value, double speed, EncounterAngle mu) {
  return omega - wave_number_value * speed * std::cos(mu.radians);
}

}  // namespace quickstrip
