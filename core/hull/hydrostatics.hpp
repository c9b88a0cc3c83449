// The hull at a waterline: immersed sections, displacement, centres, stability, by the trapezoidal rule over
// the stations as given. Trim: each station floats at its own local draught; sections stay vertical (small
// trim).
#pragma once

#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/base/static_vector.hpp"
#include "core/hull/hull.hpp"

namespace quickstrip {

/// One station below the waterline. Contour: half-breadth y against z measured from the waterline (z <= 0),
/// keel first, last point on the waterline; empty for a hull of minimal form.
struct ImmersedSection {
  double x = 0.0;            // from the aft perpendicular [m]
  double breadth = 0.0;      // at the waterline, both sides [m]; 0 for a wholly submerged section
  double draught = 0.0;      // from the waterline to the lowest point of the section [m]
  double area = 0.0;         // m2
  double centroid_z = 0.0;   // of the area, from the waterline, negative [m]
  double waterline_z = 0.0;  // of the local waterline above base [m]
  StaticVector<Offset, kMaxOffsets + 2> contour;
};

using ImmersedSections =
    StaticVector<ImmersedSection, kMaxStations>;  // stations without immersed area are left out

/// SI; x from the aft perpendicular, z above base.
struct Hydrostatics {
  double volume = 0.0;        // m3
  double displacement = 0.0;  // kg
  double lcb = 0.0;
  double kb = 0.0;
  double bm = 0.0;
  double kg = 0.0;        // solid
  double kg_fluid = 0.0;  // solid + free-surface correction (or from a given gm)
  double gm = 0.0;        // fluid, > 0
  double gml = 0.0;
  double lcf = 0.0;
  double waterplane_area = 0.0;
  double draught_at_lcb = 0.0;  // of the waterline above base at x = lcb
  double cb = 0.0;              // on lpp, the greatest waterline breadth, mean draught
  double cm = 0.0;              // of the fullest section
  double cwp = 0.0;
};

/// Cuts every station at its waterline. Errors: kTooFewStations, kStationsNotOrdered, kContourNotOrdered,
/// kDraughtAboveDeck, kDraughtNotSupported, kNotFinite, kOutOfRange.
Status immerse(const Hull& hull, const Loading& loading, ImmersedSections& out);

/// Errors: kNoImmersedVolume, kUnstable, kNotFinite.
Result<Hydrostatics> hydrostatics(const Hull& hull, const Loading& loading, const ImmersedSections& sections);

}  // namespace quickstrip
