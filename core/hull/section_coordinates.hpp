// The coordinates in which the coefficients of Lewis sections are smooth, shared by the table and its
// generator:
//   log H0; fullness p: a3 between its bounds at this H0, 0 at a3 = -1/3 (fullest) ... 1 at the re-entrant
//   limit; frequency u = ln((kappa + low) / (kappa + high)), linear in kappa near zero, in 1/kappa near
//   infinity and logarithmic between; kappa = K M = xi / (1 + a1 + a3).
// The bound of a3 has a fold at H0 = 1: interpolation must not run across it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/hull/lewis_limits.hpp"

namespace quickstrip {

/// q = (H0 - 1) / (H0 + 1).
inline double breadth_draught_parameter(double h0) {
  return (h0 - 1.0) / (h0 + 1.0);
}

inline constexpr double kLeastA3 = -1.0 / 3.0;  // upper limit of sigma
/// a3 of the re-entrant limit, (1 - |a1|) / 3 with a1 = q (1 + a3).
inline double greatest_a3(double q) {
  return (1.0 - std::abs(q)) / (3.0 + std::abs(q));
}

inline double fullness(double q, double a3) {
  return (a3 - kLeastA3) / (greatest_a3(q) - kLeastA3);
}
inline double a3_of_fullness(double q, double p) {
  return kLeastA3 + p * (greatest_a3(q) - kLeastA3);
}

inline double frequency_coordinate(double kappa) {
  constexpr double kLow = 0.003;
  constexpr double kHigh = 60.0;
  return std::log((kappa + kLow) / (kappa + kHigh));
}

inline constexpr std::size_t kNumTabulatedFrequencies = 32;

/// What is stored, in units of M (see lewis_limits.hpp): smooth and bounded for kappa = 0 ... infinity, and
/// divided by the scale of quantity_scales at the same H0.
enum SectionQuantity : std::size_t {
  kHeaveMass,       // a33 + (B^2/pi) ln(kappa/(1+kappa))
  kHeaveAmplitude,  // h3 / decay.heave
  kSwayMass,        // a22
  kCouplingMass,    // a24
  kRollMass,        // a44
  kSwayAmplitude,   // h2 / decay.sway
  kRollAmplitude,   // h4 / decay.roll
};
inline constexpr std::size_t kNumSectionQuantities = 7;
using SectionQuantities = std::array<double, kNumSectionQuantities>;

/// Closed forms that take most of the variation with H0 out of the quantities: those of a form of middling
/// fullness. Along the fullness the quantities themselves are nearly parabolas (the closed forms are, in a3),
/// so the scales must not vary with it.
SectionQuantities quantity_scales(double q);

/// What is taken out of the amplitudes of the radiated waves. Sway: kappa at low, 2/kappa at high frequency.
/// Heave: const and (g kappa)^-2, because short waves see only the curvature at the waterline,
/// 4 (1+a1+9a3) / ((1-a1-3a3)^3 kappa^2). g would be (1-a1-3a3)^(3/2), but that has no second derivative at
/// the re-entrant limit of wide sections, where it vanishes and the amplitudes do not: its square instead,
/// which leaves a bounded factor in the quantity. The factor 0.15 gave the least error of 0.1 ... 0.7.
struct AmplitudeDecay {
  double heave = 1.0;
  double sway = 1.0;
  double roll = 1.0;
};
inline double waterline_bluntness(double a1, double a3) {  // g
  const double d = 1.0 - a1 - 3.0 * a3;
  return 0.15 * d * d;
}
inline AmplitudeDecay amplitude_decay(double bluntness, double kappa) {
  const double long_waves = 1.0 / (1.0 + kappa);
  const double curvature = 1.0 / (1.0 + bluntness * kappa);
  return {.heave = curvature * curvature,
          .sway = kappa * long_waves * long_waves,
          .roll = kappa * long_waves * curvature * curvature};
}

inline double breadth_in_scale(double a1, double a3) {
  return 2.0 * (1.0 + a1 + a3);
}  // B / M
double area_in_scale(double a1, double a3);  // A / M^2

}  // namespace quickstrip
