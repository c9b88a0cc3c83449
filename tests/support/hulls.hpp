// Parametric hulls for tests. Loading, points and grid are filled so that every room can take them; stations
// run over the whole length, both ends included.
#pragma once

#include <cstddef>

#include "core/hull/hull.hpp"

namespace quickstrip::test {

/// A box: flat bottom at z = 0, sides to `depth`, from 0 to lpp. kg on the waterline (GM must come out
/// positive: B > 2.5 T or so), gyradii 0.35 B and 0.25 L.
Hull box_barge(double length, double breadth, double draught, double depth, std::size_t stations = 21);

/// Wigley hull `which` = 1 ... 4 of the Delft experiments (report 0909): L 3 m, d 0.1875 m, B 0.3 (I, III) or
/// 0.6 m (II, IV), fresh water,
///   y = (B/2) [(1 - z^2)(1 - x^2)(1 + 0.2 x^2) + alpha z^2 (1 - z^8)(1 - x^2)^4],
/// x = 2X/L, z = depth/d, alpha = 1 (I, II) or 0 (III, IV); wall-sided above the waterline up to 0.3 m.
/// The end stations have no breadth and therefore no immersed area.
Hull wigley_hull(int which, std::size_t stations = 41, std::size_t points = 41);

/// Half-breadth of the formula; X from amidships, Z depth below the waterline, both in m.
double wigley_half_breadth(int which, double from_midship, double depth);

/// The S-175 container ship of sim/hulls/s175.hull.toml, T 9.5 m, KG 9.55 m; her roll damped by a ratio of
/// 0.05, which figures of other programs rest on.
Hull s175();

/// The same ship `scale` times as large, by Froude's law: lengths x scale, speeds and times x sqrt(scale),
/// viscosity x scale^1.5, density and gravity unchanged.
Hull scaled(const Hull& hull, double scale);

}  // namespace quickstrip::test
