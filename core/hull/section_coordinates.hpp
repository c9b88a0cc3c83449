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

/// What is stored, in units of M (see lewis_limits.hpp), each smooth and bounded for kappa = 0 ... infinity.
enum SectionQuantity : std::size_t {
  kHeaveMass,       // (a33 + (B^2/pi) ln(kappa/(1+kappa))) / a33(inf)
  kHeaveAmplitude,  // h3 (1+kappa)^2 / B
  kSwayMass,        // a22 / a22(0)
  kCouplingMass,    // a24 / sqrt(a22(0))
  kRollMass,        // a44
  kSwayAmplitude,   // h2 (1+kappa)^2 / (kappa D2)
  kRollAmplitude,   // h4 (1+kappa)^3 / kappa
};
inline constexpr std::size_t kNumSectionQuantities = 7;
using SectionQuantities = std::array<double, kNumSectionQuantities>;

/// The closed forms that scale them, once per section.
struct SectionScales {
  double breadth = 0.0;  // B / M
  double area = 0.0;     // A / M^2
  double heave_mass_at_infinity = 0.0;
  double sway_mass_at_zero = 0.0;
  double coupling = 0.0;        // sqrt(a22(0))
  double sway_radiation = 0.0;  // D2
};
SectionScales section_scales(double a1, double a3);

}  // namespace quickstrip
