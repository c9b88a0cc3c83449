// One station at one level, as a hull table holds it: the oscillating section, and the restrained one in
// waves, solved at every node.
#pragma once

#include <array>
#include <optional>

#include "core/hull/hull.hpp"
#include "core/hull/hydrostatics.hpp"
#include "core/strip/hull_table.hpp"

namespace quickstrip {

/// K [1/m] of the nodes, as hull_table.hpp says: of oscillations those of a loaded hull's own table, of waves
/// up to the highest of its transfer functions and 5 % beyond.
struct TableNodes {
  std::array<double, kHullTableOscillations> oscillation{};
  std::array<double, kHullTableWaves> wave{};
  double highest_met = 0.0;  // above it a failed check is no flag
};
TableNodes table_nodes(const Hull& hull);

using WaveValues = std::array<double, kNumWaveQuantities>;

struct TableSection {
  // The method's own check of its accuracy failed at a node: of waves, or of oscillation up to 20 sqrt(g/L),
  // beyond which a ship of Fn 0.3 meets waves shorter than L/7 only.
  bool is_flagged = false;
  HullSections method{};  // in use: not the one asked for where that does not fit the section
  std::array<OscillationValues, kHullTableOscillations> oscillation{};
  std::array<std::array<WaveValues, kHullTableDirections>, kHullTableWaves> wave{};
};

/// The station of the hull with the waterline at `level` above base; nothing where it is out of the water. A
/// station of minimal form as it is, whatever the level. Throws std::invalid_argument where the level lies
/// above the deck.
std::optional<ImmersedSection> cut_station(const Hull& hull, std::size_t station, double level);

/// By the method; a contour that has no breadth where it reaches the waterline, or somewhere below it, takes
/// its Lewis form. Throws
/// std::invalid_argument where there is no contour (section_contour.hpp).
TableSection solve_section(const ImmersedSection& section, HullSections method, const TableNodes& nodes);

}  // namespace quickstrip
