// What the true sea does on every course and speed, half hour by half hour: the advisor's own verdicts,
// without waiting, for the sea without noise. And what the best pilot makes of it who knows all of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/advice/advice.hpp"
#include "core/advice/steadiness.hpp"
#include "core/base/capacity.hpp"

namespace quickstrip::pilot {

/// Of a cell in half an hour.
enum class Hours : std::uint8_t { kInside = 0, kNotJudged = 1, kExceeded = 2, kNoSteerage = 3 };

struct TrueGrid {
  std::size_t num_speeds = 0;
  std::size_t num_headings = 0;
  std::array<double, kMaxSpeeds> speeds{};
  std::array<std::array<Hours, kMaxHeadings>, kMaxSpeeds> cells{};

  [[nodiscard]] Hours at(CellIndex cell) const { return cells[cell.speed][cell.heading]; }
};

TrueGrid true_grid(const Grid& grid);

inline constexpr int kChangesPerWatch = 4;
inline constexpr std::size_t kHalfHoursPerWatch = 8;

/// Cells by half hours. Least time above a limit; of equal ones least time that is not judged; of equal ones
/// least deviation from the intended cell (a step of 5 degrees counts as a knot); at most four changes a
/// watch. By dynamic programming over (half hour, changes used in the watch, cell).
std::vector<CellIndex> all_knowing_pilot(const std::vector<TrueGrid>& truth, CellIndex intended);

struct Tally {
  double exceeded_h = 0.0;
  double not_judged_h = 0.0;
  int num_changes = 0;
  int most_changes_in_a_watch = 0;
};

/// Of a voyage whose cells by half hours are given; changes from `intended` on.
Tally tally(const std::vector<TrueGrid>& truth, const std::vector<CellIndex>& sailed, CellIndex intended);

}  // namespace quickstrip::pilot
