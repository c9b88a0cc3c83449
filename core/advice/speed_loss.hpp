// Involuntary speed loss: what is left of a speed when the sea adds to the resistance and the engine gives no
// more than that speed takes in calm water.
//
// P eta = R_calm(V0) V0 = (R_calm(V) + R_added(V)) V, eta taken as constant; bisection of a fixed number of
// steps over 0 ... V0. R_added of a cell is the larger one of strip theory and the semi-empirical method,
// where both are at hand (a loss is rather said too large); between the speeds of the grid it is linear. A
// sea that pushes gives no gain. Wind, steering and a propeller that works worse in waves are not in it, and
// a master who slows down of his own accord is not: this is what the engine does. Calm-water resistance
// between the given speeds is linear, beyond them as the square of speed. A cell whose speed would take more
// power than the highest given speed takes in calm water cannot be kept: kQualitySpeedNotKept, and never
// recommended. Cost: 0.6 us a cell, and nothing without a table.
#pragma once

#include <span>

#include "core/advice/advice.hpp"
#include "core/hull/hull.hpp"

namespace quickstrip {

using ResistanceTable = StaticVector<CalmWaterResistance, kMaxResistancePoints>;

/// N, at a speed >= 0 [m/s]; table not empty, speeds > 0 and both columns increasing.
double calm_water_resistance(const ResistanceTable& table, double speed);

/// The larger one of the two methods; 0 when there is none or the sea pushes [N].
double added_resistance(const Cell& cell);

/// The speed [m/s] in a column of the grid at the power that `ordered` takes in calm water.
double speed_kept(const ResistanceTable& table, const Grid& grid, std::size_t heading, double ordered);

/// Fills speed_loss and the quality bit of every cell; leaves kNotComputed without a table.
void fill_speed_loss(const ResistanceTable& table, Grid& grid);

}  // namespace quickstrip
