// The same ship in another size, by Froude's law: lengths x scale, speeds and times x sqrt(scale). What is
// scaled: stations, draughts, KG, free surface, GM, gyradii, measured roll period, points, slamming stations
// and their threshold velocities, freeboards, propeller, bilge keels, speeds of the grid and of steerage.
// Water and gravity stay what they are, as for a real ship of that size, so the Reynolds number changes:
// motions are the same nondimensionally, to rounding (tests/hull_tool), but for what friction does: viscous
// surge damping and roll damping by Ikeda's method.
#pragma once

#include "core/hull/hull.hpp"

namespace quickstrip::hull_tool {

/// scale > 0, applied in place.
void scale_by_froude(Hull& hull, double scale);

}  // namespace quickstrip::hull_tool
