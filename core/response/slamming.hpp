// Bow slamming after [Ochi1964]: the keel comes out of the water and meets it again faster than a threshold.
//
// P per wave encounter = exp(-(D^2 / 2 m0 + v^2 / 2 m2)), with m0, m2 of the vertical relative motion and
// velocity at the station (independent, both Rayleigh).
// Assumes: no deeper draught by the bow wave (swell_up.hpp: no credit); the threshold was found on a ship of
// 520 ft and is scaled by Froude. Source: [Ochi1964], [Journee1992] §3.
#pragma once

namespace quickstrip {

/// 0.0928 sqrt(g L) [m/s]: 12 ft/s at 520 ft.
double ochi_threshold_velocity(double lpp, double gravity);

/// D^2 / 2 m0 + v^2 / 2 m2, so that P = exp(-exponent) and, with wave heights f times as high,
/// P = exp(-exponent / f^2). draught >= 0 [m]: 0 when the keel is out of the water at rest; velocity >= 0
/// [m/s]. Finite: never above kNeverExponent.
double slamming_exponent(double draught, double threshold_velocity, double m0, double m2);

/// Per wave encounter.
double slamming_probability(double draught, double threshold_velocity, double m0, double m2);

/// N = 3600 / (2 pi) sqrt(m2 / m0) P.
double slams_per_hour(double draught, double threshold_velocity, double m0, double m2);

/// e^-kNeverExponent is zero in double; stands for an event that cannot happen.
inline constexpr double kNeverExponent = 1e30;

}  // namespace quickstrip
