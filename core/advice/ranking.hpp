// Which change of course or speed brings the ship back inside the limits, and which is the smallest.
// What may be recommended, what it costs and which way the ship turns: candidates.hpp.
//
// Aim: a good cell. If there is none: for a ship that exceeds a limit, a cell of caution; if there is none of
// these either, the smallest change among those that come within a tenth of the least bad cell (turn.hpp,
// badness), if that is less bad than the present one.
//
// Offered: the smallest slowing, speeding up, turn to starboard and turn to port, as far as there are any,
// and the smallest combined change if it is smaller than every pure one; the smallest first. Besides,
//   larger    the greatest margin for at most twice the effort of the first, if that is at least 1.25 times
//             the first one's and comes with no zone that the first one has not;
//   heave-to  for a ship that exceeds a limit when no cell is good, or the first costs more than six units
//             (120 degrees): the lowest steerage speed of the grid, heading within 30 degrees of the most
//             energetic sea, where that is best there; if it is better than the present state.
// A recommendation that stands (steadiness.hpp) stays the first while it costs at most half as much again and
// half a unit more than the smallest one, and meets the aim or is at least inside the limits, clearly better
// than the present state, and less than a quarter worse than where the smallest one leads.
//
// Cost: a few passes over the cells, and a walk of turn.hpp for those that are smaller than the smallest one
// so far: 0.1 to 0.3 ms on 1,800 cells (one x86-64 core).
#pragma once

#include "core/advice/advice.hpp"
#include "core/advice/candidates.hpp"

namespace quickstrip {

inline constexpr double kMuchMoreMargin = 1.25;  // factor that a larger change must buy
inline constexpr double kMuchMoreEffort = 2.0;   // factor that it may cost
inline constexpr double kLeastBadWithin = 1.1;   // factor on the badness of the least bad cell
inline constexpr double kLittleWorks = 6.0;      // effort above which heaving to is named
inline constexpr double kHeaveToSector = radians(30.0);
inline constexpr double kStandingFactor = 1.5;   // on the effort of the smallest change
inline constexpr double kStandingSlack = 0.5;    // units of effort
inline constexpr double kStandingWithin = 1.25;  // factor on the badness of where the smallest change leads
inline constexpr double kStandingGain = 1.1;     // factor on the badness of the present state

/// What a recommendation goes to, so that it is known again when the ship yaws and the sea shakes.
struct Standing {
  bool is_there = false;
  bool turns = false;
  bool changes_speed = false;
  int side = 0;          // +1 starboard, -1 port
  double heading = 0.0;  // rad, if it turns
  double speed = 0.0;    // m/s, if it changes speed
};

Standing standing_of(const Change& change);

/// Fills heading, speed, present, changes with their turns, and the flags of `out`; clears its no_advice.
/// The verdicts of the grid and of the present cell are taken as they are.
void rank_changes(const Grid& grid, const Present& present, const Cell& present_cell, Advice& out,
                  const Standing& standing = {});

}  // namespace quickstrip
