// The way from the present course and speed to new ones: which cells of the grid the ship passes, how long,
// and what the roll on the way may come to.
//
// Course and speed start to change together, each at the ship's own rate (Handling); whichever takes longer
// ends the turn. The way is a line through the grid that is broken once, and each piece of it belongs to the
// nearest cell: times are exact, no sampling. Quasi-stationary: the ship is taken to roll as in the long run
// in each cell; heel of the turn itself, speed lost by rudder and the ship's memory of the last roll are not
// in it.
//
// Largest roll: amplitudes of a Gaussian roll follow Rayleigh, one a natural period T. Of n amplitudes at RMS
// s all stay below a with probability (1 - exp(-a^2 / 2 s^2))^n; with n = dt / T in each cell the largest of
// the way stays below a with P(a) = exp(-E(a)), E(a) = sum of dt / T * -ln(1 - exp(-a^2 / 2 s^2)). Said is
// the a of E(a) = 1. For many amplitudes of one RMS, -ln(1 - x) -> x and a -> s sqrt(2 ln n), the most
// probable maximum of short_term.hpp (0.4 % above it for n = 20, 7 % for n = 3); for a single one it is 0.96
// s, where the mode is s. Unlike an expected number of crossings it has a value for a turn of less than a
// period.
//
// How bad a cell is: `badness`, 1 at a limit. Exposure of a way: integral over time of what its cells are
// worse than the present one (and worse than a limit) [s].
//
// Cost: at most kMaxHeadings + kMaxSpeeds + 1 cells; some 20 us for a quarter turn with its largest roll.
#pragma once

#include "core/advice/advice.hpp"
#include "core/base/angles.hpp"
#include "core/hull/hull.hpp"

namespace quickstrip {

/// Where the ship is and how she changes that.
struct TurnStart {
  Heading heading;
  double speed = 0.0;  // m/s, within the grid's speeds
  Handling handling{};
  double roll_period = 0.0;  // s, natural; 0: not known, and no largest roll
};

/// As turned, + to starboard, |heading_change| < 2 pi [rad]; [m/s].
struct Way {
  double heading_change = 0.0;
  double speed_change = 0.0;
};

/// A warning of the IMO guidance counts as waves 25 % above a limit, at least. Ours.
inline constexpr double kSevereZoneBadness = 1.25;
/// A margin below a quarter is as bad as a quarter.
inline constexpr double kWorstBadness = 4.0;

/// 1 / margin; of an unknown cell at least 1, as if at a limit; of one in a severe zone kSevereZoneBadness.
double badness(const Cell& cell);
double badness(const Change& change);

/// 0 good ... 3 exceeded: unknown is worse than caution, for nothing is known to beat it.
int severity(Verdict verdict);

/// [s]; weighted by how much worse: a minute at twice the badness of max(1, reference) counts 60 max(1, ref).
double turn_exposure(const Grid& grid, const TurnStart& start, const Way& way, double reference);

/// What is met on the way, the present and the new cell included.
Turn sum_up_turn(const Grid& grid, const TurnStart& start, const Way& way);

}  // namespace quickstrip
