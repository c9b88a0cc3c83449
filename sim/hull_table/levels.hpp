// The heights of the waterline at which a hull table holds each station: the draughts, and what trims add at
// the stations' ends. Stations stay upright, so that a trimmed ship is one whose stations float at different
// levels.
#pragma once

#include <vector>

#include "core/hull/hull.hpp"

namespace quickstrip {

/// Draughts amidships above base [m], trims (draught aft - draught forward) [m]; no trim given: level. In any
/// order, twice as well as once.
struct CompiledLoadings {
  std::vector<double> draughts;
  std::vector<double> trims;
};

/// Of the hull file's own loading.
CompiledLoadings own_loadings(const Hull& hull);

/// Increasing. The draughts, and where a station's waterline lies beyond them by trim, levels as far apart
/// as the draughts at most (a twentieth of a lone draught). Throws std::invalid_argument in one sentence:
/// none, not finite, not positive, more than kMaxHullTableLevels.
std::vector<double> table_levels(const Hull& hull, const CompiledLoadings& loadings);

}  // namespace quickstrip
