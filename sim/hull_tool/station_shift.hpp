// Another block coefficient and another centre of buoyancy by moving the sections along the ship, each with
// its form: the swing of the curve of areas [Lackenby1950]. Between the end of the full part amidships (f)
// and the end of the ship (e) a section moves from f + (e - f) u to f + (e - f) u',
//   u' = u / (u + (1 - u) exp(-c)) = u + c u (1 - u) + ...,
// which keeps the ends, the full part, lpp, breadth, draughts and the midship section; c > 0 makes that end
// fuller. To first order it is Lackenby's parabola; in whole it never changes the order of the sections, and
// -c undoes c: there and back is the same ship. c forward and c aft follow from the two wishes by Newton's
// method on the hydrostatics of the moved ship itself, whatever the stations' spacing, to 1e-8.
// The full part: the stations next to the largest whose area is within 0.1 % of its. Sections beyond the
// perpendiculars stay. Range: |c| <= 0.7: neighbours stay within half and twice their distance; for the S-175
// CB -0.117 ... +0.117 or LCB -0.055 ... +0.057 lpp.
#pragma once

#include "core/base/result.hpp"
#include "core/hull/hull.hpp"
#include "core/hull/hydrostatics.hpp"

namespace quickstrip::hull_tool {

struct FormChange {
  double cb = 0.0;   // added to the block coefficient
  double lcb = 0.0;  // added to the centre of buoyancy's x, positive forward [m]
};

struct ShiftedHull {
  Hull hull;
  Hydrostatics hydrostatics;
  double swing_aft = 0.0;   // c
  double swing_fore = 0.0;  // c
};

/// `hull` floats at its own loading with these sections and hydrostatics. kOutOfRange when it cannot be done
/// within the swing allowed; `out` then has no meaning. Errors of immerse() and hydrostatics().
Status shift_stations(const Hull& hull, const ImmersedSections& sections, const Hydrostatics& hydrostatics,
                      const FormChange& change, ShiftedHull& out);

/// The largest share of `change`, 0 ... 1, that can be done.
double possible_share(const Hull& hull, const ImmersedSections& sections, const Hydrostatics& hydrostatics,
                      const FormChange& change);

}  // namespace quickstrip::hull_tool
