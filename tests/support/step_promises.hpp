// What holds of every step of core, whatever went in: no advice, or finite numbers; never a good cell that is
// above a limit. Shared by the evidence and the fuzzing.
#pragma once

#include <cmath>
#include <string_view>

#include "core/advice/step.hpp"

namespace quickstrip::test {

inline bool is_finite(const Cell& cell) {
  bool all = std::isfinite(cell.margin) && std::isfinite(cell.rms_roll) &&
             std::isfinite(cell.rms_bridge_vertical) && std::isfinite(cell.roll_exceedance) &&
             std::isfinite(cell.slam_probability) && std::isfinite(cell.slams_per_hour) &&
             std::isfinite(cell.wetness_probability) && std::isfinite(cell.low_encounter_share) &&
             std::isfinite(cell.speed_loss) && std::isfinite(cell.added_resistance) &&
             std::isfinite(cell.added_resistance_empirical) && std::isfinite(cell.roll_damping_ratio);
  for (const float value : cell.values) {
    all = all && std::isfinite(value);
  }
  return all;
}

inline bool is_finite(const CellResponse& response) {
  bool all = is_finite(response.cell);
  for (const QuantityResponse& quantity : response.quantities) {
    all = all && std::isfinite(quantity.rms) && std::isfinite(quantity.t1) && std::isfinite(quantity.t2) &&
          std::isfinite(quantity.probability) && std::isfinite(quantity.per_hour);
  }
  return all;
}

/// Good, and yet a criterion is above its limit.
inline bool is_wrongly_good(const Cell& cell, const Criteria& criteria) {
  constexpr double kSingle = 1e-6;  // a cell holds floats
  for (std::size_t c = 0; cell.verdict == Verdict::kGood && c < criteria.size(); ++c) {
    if (static_cast<double>(cell.values[c]) > criteria[c].limit * (1.0 + kSingle)) {
      return true;
    }
  }
  return false;
}

/// The first promise that is broken; empty: none.
inline std::string_view broken_promise(const StepOutput& output, const Criteria& criteria) {
  const NoAdvice reason = output.advice.no_advice;
  const bool has_grid = reason == NoAdvice::kNone || reason == NoAdvice::kSpeedOutsideGrid;
  for (std::size_t v = 0; v < output.grid.num_speeds; ++v) {
    for (std::size_t h = 0; h < output.grid.num_headings; ++h) {
      const Cell& cell = output.grid.cells[v][h];
      if (!has_grid && cell.verdict != Verdict::kUnknown) {
        return "a cell is judged without advice";
      }
      if (has_grid && !is_finite(cell)) {
        return "a cell holds a number that is not finite";
      }
      if (is_wrongly_good(cell, criteria)) {
        return "a good cell is above a limit";
      }
    }
  }
  if (reason != NoAdvice::kNone) {
    return {};
  }
  if (!is_finite(output.advice.present) || !is_finite(output.present)) {
    return "the present state holds a number that is not finite";
  }
  if (is_wrongly_good(output.advice.present, criteria)) {
    return "the present state is good above a limit";
  }
  for (const Change& change : output.advice.changes) {
    if (!std::isfinite(change.heading) || !std::isfinite(change.speed)) {
      return "a change to nowhere";
    }
  }
  return {};
}

}  // namespace quickstrip::test
