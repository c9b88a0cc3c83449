// The wave energy that a course meets from one relative direction and from its mirror image on the other side
// of the ship, by wave system: its bands merged, each with what the system takes of it, linearly between two
// compass directions of the energy grid.
//
// What the two sides bring together goes with what a response has in common from both sides (even), their
// difference with what it has apart (odd): variance = even even + odd odd. Cost: 5 multiply-adds a node and
// band of the system. No state.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/sea/sea_energy.hpp"

namespace quickstrip {

/// Direction indices on either side of a heading, and how far it lies towards the upper one.
struct HeadingBracket {
  std::size_t below = 0;
  std::size_t above = 0;
  double part = 0.0;
};
HeadingBracket bracket_heading(Heading heading);

/// The compass direction index from which waves come that travel at relative direction m when the ship heads
/// for direction index h (2 pi h / kNumDirections): from = heading + pi - mu.
std::size_t wave_direction(std::size_t h, std::size_t m);

/// Bands of one system together; densities and energies of `odd` may be negative.
struct MetEnergy {
  EnergyBand even;
  EnergyBand odd;
};

/// Waves from right ahead or astern have one side.
constexpr bool has_two_sides(std::size_t solved_m) {
  return solved_m > 0 && solved_m < kNumDirections / 2;
}

/// Of system s at solved direction m; false, and `out` nothing, when no wave of it comes from there.
bool meet_energy(const SeaEnergy& sea, std::size_t s, const HeadingBracket& heading, std::size_t solved_m,
                 MetEnergy& out);

}  // namespace quickstrip
