// The half contour of an immersed section as the parent's methods take it, and what cannot be one.
#pragma once

#include <vector>

#include "core/hull/hull.hpp"
#include "core/hull/hydrostatics.hpp"

namespace quickstrip {

/// y >= 0, z <= 0 from the waterline, up [m]; from the keel on the centre plane (y == 0) along the hull to
/// the waterline (z == 0), or of a submerged section back to the centre plane (y == 0, z < 0).
struct SectionContour {
  std::vector<Offset> points;
  [[nodiscard]] bool is_submerged() const { return points.back().z < 0.0; }
};

/// The contour of a cut station. Throws std::invalid_argument with the reason where it is none: fewer than
/// three points, it crosses itself, a side of no length only.
SectionContour section_contour(const ImmersedSection& section);

/// The same for points given otherwise (any order of z, so that re-entrant and tunnelled forms have one).
SectionContour section_contour(const std::vector<Offset>& keel_to_waterline);

/// Immersed area, both sides [m2].
double area(const SectionContour& contour);

}  // namespace quickstrip
