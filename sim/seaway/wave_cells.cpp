#include "sim/seaway/wave_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quickstrip::seaway {
namespace {

// omega_e = omega - bend omega^2.
double bend_of(const Beam& beam, const CellGrid& grid) {
  return grid.speed * std::cos(encounter_angle(grid.heading, beam.from).radians) / grid.gravity;
}

// Wave frequency at which omega_e has this value, on the branch before or behind the turn; infinity when
// there is none.
double frequency_at(double bend, bool is_behind_turn, double met) {
  const double root2 = 1.0 - 4.0 * bend * met;
  if (root2 < 0.0) {
    return std::numeric_limits<double>::infinity();
  }
  const double root = std::sqrt(root2);
  return is_behind_turn ? (1.0 + root) / (2.0 * bend) : 2.0 * met / (1.0 + root);
}

// A stretch on which omega_e only rises or only falls.
struct Stretch {
  double from = 0.0;
  double to = 0.0;
  bool is_behind_turn = false;
};

void cut_stretch(const Beam& beam, std::uint32_t index, double bend, const Stretch& stretch,
                 const CellGrid& grid, double least_density, std::vector<WaveCell>& out) {
  const double start = stretch.from - bend * stretch.from * stretch.from;
  auto bin = static_cast<std::int32_t>(std::lround(start / grid.step));
  const std::int32_t direction = stretch.is_behind_turn ? -1 : 1;
  double at = stretch.from;
  while (at < stretch.to) {
    const double edge = (static_cast<double>(bin) + 0.5 * static_cast<double>(direction)) * grid.step;
    const double crossing = frequency_at(bend, stretch.is_behind_turn, edge);
    if (crossing <= at) {  // the start lies on an edge, to rounding
      bin += direction;
      continue;
    }
    const double next = std::min({crossing, at + grid.widest_cell, stretch.to});
    const double middle = 0.5 * (at + next);
    const double density =
        (beam.density(at) + 4.0 * beam.density(middle) + beam.density(next)) / 6.0;  // Simpson's rule
    if (density > least_density) {
      out.push_back({middle, density * (next - at), index, bin});
    }
    if (next >= crossing) {
      bin += direction;
    }
    at = next;
  }
}

}  // namespace

std::vector<WaveCell> wave_cells(const Beams& sea, const CellGrid& grid) {
  constexpr double kNegligible = 1e-7;  // of the largest density
  constexpr int kLooks = 200;
  double largest = 0.0;
  for (const Beam& beam : sea.beams) {
    for (int i = 0; i <= kLooks; ++i) {
      const double part = static_cast<double>(i) / kLooks;
      largest =
          std::max(largest, beam.density(sea.range.lowest + part * (sea.range.highest - sea.range.lowest)));
    }
  }
  std::vector<WaveCell> out;
  for (std::uint32_t b = 0; b < sea.beams.size(); ++b) {
    const double bend = bend_of(sea.beams[b], grid);
    const double turn = bend > 0.0 ? 0.5 / bend : std::numeric_limits<double>::infinity();
    const double lowest = sea.range.lowest;
    const double highest = sea.range.highest;
    if (turn > lowest) {
      cut_stretch(sea.beams[b], b, bend, {lowest, std::min(turn, highest), false}, grid,
                  kNegligible * largest, out);
    }
    if (turn < highest) {
      cut_stretch(sea.beams[b], b, bend, {std::max(turn, lowest), highest, true}, grid, kNegligible * largest,
                  out);
    }
  }
  return out;
}

double highest_encounter(const Beams& sea, const CellGrid& grid) {
  double highest = 0.0;
  for (const Beam& beam : sea.beams) {
    const double bend = bend_of(beam, grid);
    for (const double omega : {sea.range.lowest, sea.range.highest}) {
      highest = std::max(highest, std::fabs(omega - bend * omega * omega));
    }
    if (bend > 0.0) {
      const double turn = std::clamp(0.5 / bend, sea.range.lowest, sea.range.highest);
      highest = std::max(highest, std::fabs(turn - bend * turn * turn));
    }
  }
  return highest;
}

}  // namespace quickstrip::seaway
