// The hull at a waterline: immersed sections, displacement, centres, stability, by the trapezoidal rule over
// the stations as given. Trim: each station floats at its own local draught; sections stay vertical (small
// trim). A section is the polygon through its offsets, closed horizontally to the centre plane at its lowest
// point; area and centroid of that polygon are exact.
// Error: of the cut, rounding; of the trapezoidal rule about (station spacing)^2: 0.3 % of the volume of a
// Wigley hull on 21 stations, 0.08 % on 41 (tests/hull).
// Cost: about 10 us for 24 stations; no heap, no large object on the stack. Source: ship geometry, [D].
#pragma once

#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/base/static_vector.hpp"
#include "core/hull/hull.hpp"

namespace quickstrip {

/// One station below the waterline. Contour: half-breadth y >= 0 against z measured from the waterline
/// (z <= 0, never decreasing), keel first. The last point of a surface-piercing section has z == 0; of a
/// wholly submerged one y == 0, z < 0. A first point with y > 0 is the edge of a flat bottom. A station of
/// minimal form has a curve of its breadth, draught and area (minimal_section.hpp; its bulbs reach up to z ==
/// 0 with y == 0).
struct ImmersedSection {
  double x = 0.0;            // from the aft perpendicular [m]
  double breadth = 0.0;      // at the waterline, both sides [m]; 0 for a wholly submerged section
  double draught = 0.0;      // from the waterline to the lowest point of the section [m]
  double area = 0.0;         // m2
  double centroid_z = 0.0;   // of the area, from the waterline, negative [m]
  double waterline_z = 0.0;  // of the local waterline above base [m]
  // Trapezoidal weight in x [m]: integral of f over the hull = sum of weight f. A neighbouring station that
  // is out of the water ends the hull there with f = 0, so its panel counts.
  double weight = 0.0;
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
  double gml = 0.0;       // with the waterplane's inertia about x = lcb (not lcf): c55 about G = rho g V gml
  double lcf = 0.0;
  double waterplane_area = 0.0;
  double draught_at_lcb = 0.0;  // of the waterline above base at x = lcb
  double cb = 0.0;              // on lpp, the greatest waterline breadth, mean draught
  double cm = 0.0;              // of the fullest section
  double cwp = 0.0;
};

/// Height above base of the waterline at x: linear between the perpendiculars, continued outside them.
double waterline_height(const Hull& hull, const Loading& loading, double x);

/// Cuts every station at its waterline. Errors: kTooFewStations, kStationsNotOrdered, kContourNotOrdered,
/// kDraughtAboveDeck, kDraughtNotSupported, kNotFinite, kOutOfRange.
/// A contour that ends below the waterline is overtopped (kDraughtAboveDeck) unless it closes at the centre
/// plane: then it is a wholly submerged section (bulb).
/// Minimal form (may be mixed with stations of offsets): valid at the draughts of hull.loading only, to
/// 0.1 % of the mean draught (1 cm for a ship of 10 m), and on a hull of nothing else at least one station
/// must reach down to the base line: its draught then is the local draught. Others may be shallower (cruiser
/// stern) or deeper (dome).
Status immerse(const Hull& hull, const Loading& loading, ImmersedSections& out);

/// Errors: kNoImmersedVolume (also: no waterplane), kUnstable, kNotFinite, kOutOfRange.
Result<Hydrostatics> hydrostatics(const Hull& hull, const Loading& loading, const ImmersedSections& sections);

}  // namespace quickstrip
