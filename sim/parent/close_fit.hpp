// Close-fit conformal mapping of a section: the coefficients a1, a3 ... a_{2N-1}, N = 2 ... 10, and the scale
// whose contour (sim/section_table/conformal_mapping.hpp) lies nearest to the section's, breadth at the
// waterline and draught at the centre plane kept ([JourneeAdegeest2003]; there the angles of the offsets and
// the coefficients are found by turns, here together: Gauss-Newton on the distances at right angles to the
// mapped contour, from N = 1 upwards, each from the one before).
//
// The contour is taken as the polygon that it is, divided along its length. A mapped contour is wall-sided at
// the waterline and flat at the keel, and its knuckles are round: the error says how much that costs.
// Range: surface-piercing sections of H0 0.05 ... 20 whose mapping is conformal; others are flagged.
// Cost: 5 ms a section with ten coefficients, up to 40 ms for one that has no mapping.
#pragma once

#include <string>

#include "sim/parent/mapped_flow.hpp"
#include "sim/parent/section_contour.hpp"
#include "sim/section_table/conformal_mapping.hpp"

namespace quickstrip {

inline constexpr int kLeastMappingCoefficients = 2;

struct CloseFit {
  MappingCoefficients a;  // N that could be used, up to those asked for
  double scale = 0.0;     // M [m]
  // Distances of the contours [m]: RMS along the section's length, largest either way.
  double rms_error = 0.0;
  double largest_error = 0.0;
  double area_error = 0.0;  // (mapped - true) / true
  // False: no flow of the mapped section should stand for the section's, because of `reason`.
  bool is_conventional = false;
  std::string reason;
};

/// `num_coefficients` 2 ... 10. Fewer are used where the contour with as many is not the conformal image of a
/// circle.
CloseFit close_fit(const SectionContour& contour,
                   int num_coefficients = static_cast<int>(kMaxMappingCoefficients));

/// sqrt(half-breadth x draught) [m]: what the errors are to be measured by.
double error_scale(const SectionContour& contour);

/// Largest errors of a conventional section, shares of error_scale: within them added mass, damping and the
/// loads of waves are within 0.5 % of the sum of mass and damping of Frank's method on the polygon (S-175:
/// bulb stations of 0.5 ... 0.9 % RMS are outside, 0.6 % off). A knuckle may be rounded by more.
inline constexpr double kConventionalRmsError = 0.005;
inline constexpr double kConventionalLargestError = 0.04;

/// The mapped section of a conventional fit (fit.is_conventional), prepared for any number of frequencies.
MappedSection mapped_section(const CloseFit& fit);
SectionFlow close_fit_flow(const CloseFit& fit, double wave_number);

}  // namespace quickstrip
