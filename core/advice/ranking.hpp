// Which change of course or speed brings the ship back inside the limits, and which is the smallest.
//
// Effort of a change: sqrt((course / 20 degrees)^2 + (speed / 2 kn)^2): 20 degrees of course are as much
// trouble as 2 kn of speed. Speeding up with the governing seas from astern counts double (it brings the ship
// nearer to the speed of the waves). A choice of ours; constants below.
//
// Candidates: a pure change of speed (to a speed of the grid, on the present course), a pure change of course
// (to a heading of the grid, at the present speed), and the cells of the grid where both change. When the
// present course or speed lies between two columns or rows, a pure change must hold in both: the worse one
// speaks. Never: below steerage speed; into cells that are unknown.
//
// Aim: a good cell. If there is none: for a ship that exceeds a limit, a cell of caution; if there is none of
// these either, the one cell with the greatest margin, if that is greater than the present one.
//
// Offered: the smallest slowing, speeding up, turn to starboard and turn to port, as far as there are any,
// and the smallest combined change if it is smaller than every pure one; the smallest first.
// Ties: slower before faster, then the smaller turn, then starboard before port (COLREG's side).
//
// Cost: one pass over the cells.
#pragma once

#include "core/advice/advice.hpp"
#include "core/base/angles.hpp"

namespace quickstrip {

inline constexpr double kEffortCourse = radians(20.0);           // rad for one unit of effort
inline constexpr double kEffortSpeed = 2.0 * (1852.0 / 3600.0);  // m/s for one unit: 2 kn
inline constexpr double kSpeedingUpInFollowingSeas = 2.0;        // factor on the speed term

/// course_change in (-pi, pi], + to starboard; speed_change signed [m/s].
double change_effort(double course_change, double speed_change, bool following_seas);

struct Present {
  Heading heading;
  double speed = 0.0;           // m/s, within the grid's speeds
  bool following_seas = false;  // the governing wave system comes from abaft the beam
};

/// Fills heading, speed, present, changes and the flags of `out`, and clears its no_advice.
void rank_changes(const Grid& grid, const Present& present, const Cell& present_cell, Advice& out);

}  // namespace quickstrip
