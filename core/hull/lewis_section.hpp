// Two-parameter (Lewis) sections: the conformal image of a circle that has the breadth, draught and area of a
// ship's section [vonKerczekTuck1969], [Journee1992] §4.
// Contour, theta = 0 at the keel ... pi/2 at the waterline, z from the waterline, up:
//   y = M {(1+a1) sin theta - a3 sin 3 theta},  z = -M {(1-a1) cos theta + a3 cos 3 theta}.
// Assumes symmetry about the centre plane. Every such section is wall-sided at the waterline, flat at the
// keel. Range: 0 < sigma <= upper_limit(h0). Error of the closed forms: rounding. Cost: under 0.1 us.
#pragma once

#include <cstdint>

#include "core/base/result.hpp"

namespace quickstrip {

enum class LewisClass : std::uint8_t {
  kReentrant,  // the contour crosses the centre plane (H0 > 1) or the waterline (H0 < 1)
  kConventional,
  kBulbous,    // H0 <= 1: broadest below the waterline
  kTunnelled,  // H0 >= 1: deepest off the centre plane
  kBulbousAndTunnelled,
};

/// "conventional", "re-entrant", ... as printed on listings.
const char* name_of(LewisClass lewis_class);

struct LewisSection {
  double breadth = 0.0;  // at the waterline [m]
  double draught = 0.0;  // at the centre plane [m]
  double area = 0.0;     // immersed [m2] = sigma breadth draught
  double h0 = 0.0;       // breadth / (2 draught)
  double sigma = 0.0;    // area / (breadth draught)
  double a1 = 0.0;
  double a3 = 0.0;
  double scale = 0.0;  // M [m]
  LewisClass lewis_class = LewisClass::kConventional;
  bool replaced = false;      // not the section that was asked for: see hydrodynamic_lewis_section
  bool extrapolated = false;  // and even the replaced one had to be brought into the range of H0
};

/// The range of H0 in which the added mass and damping of Lewis sections are tabulated.
inline constexpr double kMinTabulatedH0 = 0.05;
inline constexpr double kMaxTabulatedH0 = 10.0;

/// Bounds of sigma at H0 > 0 (derived from the contour; h = min(H0, 1/H0)).
double reentrant_limit(double h0);     // 3 pi/32 (2 - h): a cusp on an axis of symmetry
double conventional_limit(double h0);  // 3 pi/32 (3 + h/4): curvature vanishes at an axis
double single_bulge_limit(double h0);  // 3 pi/32 (3 + 1/(4h)): bulge at both axes above it
double upper_limit(double h0);         // pi/32 (10 + H0 + 1/H0): a3 = -1/3, no Lewis form above it

/// The Lewis form of this breadth, draught [m] and area [m2]. Re-entrant forms are given too (class says so).
/// kNotFinite; kOutOfRange where an argument is not positive or no Lewis form exists (sigma above the limit).
Result<LewisSection> lewis_section(double breadth, double draught, double area);

/// The form for added mass and damping ALONE, inside the tabulated range. Area, hydrostatics and wave forces
/// from the undisturbed wave come from the real section. Where the true form is not usable, `replaced`:
///  - re-entrant: sigma raised to just above the limit, breadth and draught kept;
///  - bulb (sigma above the limit, H0 below the range, no breadth at the waterline): draught and area kept,
///    sigma' = 0.9, breadth' = area / (0.9 draught);
///  - H0 then still outside the range, also `extrapolated`: thin sections keep the draught and take the
///    least breadth, flat ones keep the breadth and take the least draught.
/// breadth >= 0, draught > 0, area > 0; kNotFinite, kOutOfRange otherwise.
Result<LewisSection> hydrodynamic_lewis_section(double breadth, double draught, double area);

struct ContourPoint {
  double y = 0.0;  // half-breadth, to port [m]
  double z = 0.0;  // from the waterline, up [m]
};

/// theta = 0 at the keel ... pi/2 at the waterline [rad].
ContourPoint contour_point(const LewisSection& section, double theta);

}  // namespace quickstrip
