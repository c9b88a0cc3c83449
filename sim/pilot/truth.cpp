#include "sim/pilot/truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quickstrip::pilot {
namespace {

constexpr double kExceededCost = 1e8;
constexpr double kNotJudgedCost = 1e4;  // above the deviation of a whole storm's half hour, 36 + 24
constexpr double kForbidden = 1e12;

bool is_same(CellIndex a, CellIndex b) {
  return a.speed == b.speed && a.heading == b.heading;
}

double deviation(const TrueGrid& grid, CellIndex cell, CellIndex intended) {
  const double turned = std::fabs(static_cast<double>(cell.heading) - static_cast<double>(intended.heading));
  const double shorter = std::min(turned, static_cast<double>(grid.num_headings) - turned);
  return shorter * 72.0 / static_cast<double>(grid.num_headings) +
         std::fabs(static_cast<double>(cell.speed) - static_cast<double>(intended.speed));
}

double cost(const TrueGrid& grid, CellIndex cell, CellIndex intended) {
  switch (grid.at(cell)) {
    case Hours::kNoSteerage:
      return kForbidden;
    case Hours::kExceeded:
      return kExceededCost + deviation(grid, cell, intended);
    case Hours::kNotJudged:
      return kNotJudgedCost + deviation(grid, cell, intended);
    case Hours::kInside:
      break;
  }
  return deviation(grid, cell, intended);
}

/// Least cost from a half hour on, by changes used and cell; and the best cell of each number of changes.
struct Stage {
  std::array<std::vector<double>, kChangesPerWatch + 1> from_cell;
  std::array<std::size_t, kChangesPerWatch + 1> best{};
};

/// What follows when after half hour t a watch's `used` changes are spent and the ship is in cell c.
struct Next {
  double cost = 0.0;
  bool is_change = false;
};
Next next(const Stage& stage, std::size_t used, std::size_t c) {
  Next stay{stage.from_cell[used][c], false};
  if (used < kChangesPerWatch) {
    const double changed = stage.from_cell[used + 1][stage.best[used + 1]];
    if (changed < stay.cost) {
      return {changed, true};
    }
  }
  return stay;
}

}  // namespace

TrueGrid true_grid(const Grid& grid) {
  TrueGrid out;
  out.num_speeds = grid.num_speeds;
  out.num_headings = grid.num_headings;
  out.speeds = grid.speeds;
  for (std::size_t v = 0; v < grid.num_speeds; ++v) {
    for (std::size_t h = 0; h < grid.num_headings; ++h) {
      const Cell& cell = grid.cells[v][h];
      out.cells[v][h] = (cell.hazards & kHazardNoSteerage) != 0 ? Hours::kNoSteerage
                        : cell.verdict == Verdict::kExceeded    ? Hours::kExceeded
                        : cell.verdict == Verdict::kUnknown     ? Hours::kNotJudged
                                                                : Hours::kInside;
    }
  }
  return out;
}

std::vector<CellIndex> all_knowing_pilot(const std::vector<TrueGrid>& truth, CellIndex intended) {
  if (truth.empty()) {
    return {};
  }
  const std::size_t num_headings = truth[0].num_headings;
  const std::size_t num_cells = truth[0].num_speeds * num_headings;
  const auto cell_of = [num_headings](std::size_t c) {
    return CellIndex{c / num_headings, c % num_headings};
  };
  const auto used_at = [](std::size_t t, std::size_t used) { return t % kHalfHoursPerWatch == 0 ? 0 : used; };
  std::vector<Stage> stages(truth.size() + 1);
  for (auto& list : stages.back().from_cell) {
    list.assign(num_cells, 0.0);
  }
  for (std::size_t t = truth.size(); t-- > 0;) {
    Stage& stage = stages[t];
    for (std::size_t used = 0; used <= kChangesPerWatch; ++used) {
      stage.from_cell[used].resize(num_cells);
      for (std::size_t c = 0; c < num_cells; ++c) {
        stage.from_cell[used][c] =
            cost(truth[t], cell_of(c), intended) + next(stages[t + 1], used_at(t + 1, used), c).cost;
      }
      const auto& list = stage.from_cell[used];
      stage.best[used] = static_cast<std::size_t>(std::min_element(list.begin(), list.end()) - list.begin());
    }
  }
  std::vector<CellIndex> sailed;
  std::size_t used = 0;
  std::size_t c = intended.speed * num_headings + intended.heading;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    used = used_at(t, used);
    if (next(stages[t], used, c).is_change) {
      ++used;
      c = stages[t].best[used];
    }
    sailed.push_back(cell_of(c));
  }
  return sailed;
}

Tally tally(const std::vector<TrueGrid>& truth, const std::vector<CellIndex>& sailed, CellIndex intended) {
  Tally sum;
  CellIndex before = intended;
  int in_watch = 0;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    in_watch = t % kHalfHoursPerWatch == 0 ? 0 : in_watch;
    const bool is_change = !is_same(before, sailed[t]);
    sum.num_changes += is_change ? 1 : 0;
    in_watch += is_change ? 1 : 0;
    sum.most_changes_in_a_watch = std::max(sum.most_changes_in_a_watch, in_watch);
    before = sailed[t];
    sum.exceeded_h += truth[t].at(sailed[t]) == Hours::kExceeded ? 0.5 : 0.0;
    sum.not_judged_h += truth[t].at(sailed[t]) == Hours::kNotJudged ? 0.5 : 0.0;
  }
  return sum;
}

}  // namespace quickstrip::pilot
