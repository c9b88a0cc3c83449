// A ship's form from a few figures, where her lines are not public: curves of area, waterline and deck by
// powers, sections by their breadth, draught and area.
//
// Aft of the full part, t = 0 at its end ... 1 at the aft perpendicular; forward likewise:
//   area        A = A_m (1 - (1 - end) t^n)     n aft and n forward follow from CB and LCB, by iteration
//   waterline   y = B/2 (1 - (1 - end) t^m)     on the hydrostatics of the stations themselves
//   deck edge   the same with a larger m; its height D + sheer s^2, s = 0 amidships ... 1 at either end
// KVLCC2's curves are of this kind (n 3 forward, 2 aft; m 4 forward, 2.15 aft).
// Sections, T the draught, h = y T: A/2 > pi/4 h: flat bottom, upright side, bilge a quarter of an ellipse
// with half axes lambda y, lambda T; below it a superellipse, (y'/y)^p + (z'/T)^p = 1, hollow for p < 1.
// Where a section would be finer than 0.55 of its breadth and draught, the keel rises instead (stern, no
// skeg). From the waterline straight to the deck edge. No bulb: the hull ends in a vertical stem at the
// forward perpendicular.
#pragma once

#include "core/base/result.hpp"
#include "core/hull/hull.hpp"

namespace quickstrip::hull_tool {

struct CurveOfBreadth {
  double end_aft = 0.0;  // of the greatest, at the perpendiculars
  double end_fore = 0.0;
  double power_aft = 2.0;
  double power_fore = 2.0;
};

struct ParametricForm {
  double lpp = 0.0;
  double breadth = 0.0;
  double draught = 0.0;
  double depth = 0.0;  // of the deck edge amidships, above base
  double sheer_aft = 0.0;
  double sheer_fore = 0.0;
  double cb = 0.0;
  double cm = 0.0;
  double lcb = 0.0;        // m from the aft perpendicular
  double full_from = 0.5;  // of lpp; the full part amidships
  double full_to = 0.5;
  double area_end_aft = 0.0;  // of the midship area
  CurveOfBreadth waterline;
  CurveOfBreadth deck;
};

/// Name, loading and places of `out` stay; particulars, stations and draughts are set. Offsets to the
/// millimetre. kOutOfRange when the iteration finds no such form.
Status shape_hull(const ParametricForm& form, Hull& out);

}  // namespace quickstrip::hull_tool
