// The half contour of an immersed section as the parent's methods take it, and what cannot be one.
#pragma once

#include <vector>

#include "core/hull/hull.hpp"
#include "core/hull/hydrostatics.hpp"

namespace quickstrip {

/// y >= 0, z <= 0 from the waterline, up [m]; from the keel on the centre plane (y == 0) along the hull to
/// the waterline (z == 0), or of a submerged section back to the centre plane (y == 0, z < 0). Three points
/// at least, no side shorter than 1e-6 of the section's size.
struct SectionContour {
  std::vector<Offset> points;
  [[nodiscard]] bool is_submerged() const { return points.back().z < 0.0; }
  [[nodiscard]] double half_breadth() const { return is_submerged() ? 0.0 : points.back().y; }  // waterline
  [[nodiscard]] double draught() const { return -points.front().z; }  // at the centre plane
};

/// The contour of a cut station. A first point off the centre plane is the edge of a flat bottom: the bottom
/// is added. What a cut leaves of a straight frame (keel and waterline alone) is divided in two sides.
/// Throws std::invalid_argument with the reason where there is no contour: see below.
SectionContour section_contour(const ImmersedSection& section);

/// The same for points given otherwise (any order of z, so that re-entrant and tunnelled forms have one).
/// Points nearer together than 1e-6 of the section's size are one. Throws std::invalid_argument in one
/// sentence, points counted from 1: fewer than three points, not finite, y < 0, z > 0, not from the centre
/// plane, ends under water off the centre plane, is at the waterline or the centre plane between its ends,
/// runs downwards, crosses itself.
SectionContour section_contour(const std::vector<Offset>& keel_to_waterline);

/// Immersed area, both sides [m2].
double area(const SectionContour& contour);

}  // namespace quickstrip
