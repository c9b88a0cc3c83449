// The same ship in the same long-crested sea by several sets of wave frequencies: what a set costs, and what
// it gets wrong.
//
//   reference   2,000 frequencies even in omega, 0.05 rad/s to max(3, 7 sqrt(g/lpp)) and to 4 omega_p
//   default     the transfer functions of core: their frequencies and the points of the roll peak, wave
//   energy
//               beyond them put back by scaling
//   paper       [Journee1992] §4: motions solved at 0.1, 0.2 ... 1.8 rad/s, two more frequencies in each
//               interval by Theilheimer polynomials (not-a-knot cubic splines) of the complex motions; 52 in
//               all
//   paper-amplitude  the same with splines of amplitude and phase (unwrapped): the paper does not say which
//   18-alone    the paper's frequencies without the polynomials
// Moments by the trapezoidal rule over the set's frequencies but for `default`. Channels of points and of
// relative motion are formed from the motions after interpolation, with the true wave.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/base/angles.hpp"
#include "core/response/watch.hpp"
#include "core/sea/sea_state.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip::hull_tool {

struct FrequencySet {
  std::string_view name;
  std::size_t solutions = 0;          // of the equations of motion
  double seconds = 0.0;               // for solving them, one speed and direction, interpolation included
  double wave_height = 0.0;           // significant, as the set has it [m]
  double added_resistance = 0.0;      // mean, by strip theory [N]
  std::vector<double> significant{};  // by channel of the watch
};

/// `sea`: one system; its direction and spreading are not looked at. mu: a multiple of 5 degrees, where the
/// default set has it solved. Roll damping of `hull` must not depend on the roll. Throws InputError.
std::vector<FrequencySet> compare_frequency_sets(const LoadedHull& hull, const Watch& watch,
                                                 const WaveSystem& sea, EncounterAngle mu, double speed);

}  // namespace quickstrip::hull_tool
