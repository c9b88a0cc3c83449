// A contour for a section of which only breadth, draught and area are known [Journee1992] §4: the Lewis form
// where there is a plain one, else a plain curve of the same three figures.
//   Lewis          reentrant_limit <= sigma <= upper_limit
//   skeg           below: straight from the keel to (sigma B/2, -sigma T) and on to the waterline
//   bulb           above, or no breadth at the waterline: y = (B/2) s + c s (1 - s), s = 1 at the waterline
// The polygon is then widened by a smooth factor, 1 at the waterline, until its area is exact and, for
// sigma <= 1, its centroid that of Morrish's rule; depths beyond the draught (tunnelled forms) are cut to a
// flat bottom. Error: the curve is a guess; on the S-175 it puts KB, and so GM (0.99 m), 0.06 m too high.
// Where GM is known, give it. Cost: about 3 us.
#pragma once

#include "core/hull/hydrostatics.hpp"

namespace quickstrip {

/// breadth >= 0, draught > 0, area > 0, finite. 41 points from keel (y == 0, or the middle of a flat bottom)
/// to waterline (y == breadth/2, z == 0); z never decreases.
void minimal_contour(double breadth, double draught, double area,
                     StaticVector<Offset, kMaxOffsets + 2>& contour);

}  // namespace quickstrip
