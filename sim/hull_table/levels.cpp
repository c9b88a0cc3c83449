#include "sim/hull_table/levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/strip/hull_table.hpp"

namespace quickstrip {
namespace {

constexpr double kOneLevel = 1e-3;  // of a level: nearer ones are one (as HullTable::covers)
constexpr double kFarthest = 0.05;  // of the draught: between a lone draught and what trim adds

void check_numbers(const char* what, const std::vector<double>& values, bool positive) {
  for (const double value : values) {
    if (!std::isfinite(value) || (positive && !(value > 0.0))) {
      throw std::invalid_argument(
          fmt::format("{} = {:g} m: a number{} is wanted", what, value, positive ? " above 0" : ""));
    }
  }
}

// As immerse() would at sea, in words.
void check_minimal(const Hull& hull, const CompiledLoadings& loadings) {
  const CompiledLoadings own = own_loadings(hull);
  const bool any_minimal = std::any_of(hull.stations.begin(), hull.stations.end(),
                                       [](const Station& station) { return station.is_minimal(); });
  const auto only = [](const std::vector<double>& values, double wanted) {
    return std::all_of(values.begin(), values.end(),
                       [wanted](double value) { return std::fabs(value - wanted) <= 1e-9; });
  };
  if (any_minimal && !(only(loadings.draughts, own.draughts[0]) && only(loadings.trims, own.trims[0]))) {
    throw std::invalid_argument(fmt::format(
        "stations of breadth, draught and area hold at the file's draught {:g} m and trim {:g} m alone; "
        "offsets are wanted",
        own.draughts[0], own.trims[0]));
  }
}

struct Range {
  double lowest = 0.0;
  double highest = 0.0;
};

// Of every station's waterline.
Range waterlines(const Hull& hull, const CompiledLoadings& loadings) {
  Range range{loadings.draughts.front(), loadings.draughts.front()};
  for (const double draught : loadings.draughts) {
    for (const double trim : loadings.trims) {
      for (const Station& station : {hull.stations.front(), hull.stations.back()}) {
        const double z = draught + trim * (0.5 - station.x / hull.lpp);
        range.lowest = std::min(range.lowest, z);
        range.highest = std::max(range.highest, z);
      }
    }
  }
  return range;
}

double greatest_step(const std::vector<double>& levels) {
  double step = 0.0;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    step = std::max(step, levels[i] - levels[i - 1]);
  }
  return step > 0.0 ? step : kFarthest * levels.front();
}

void sort_out(std::vector<double>& levels) {
  std::sort(levels.begin(), levels.end());
  const auto same = [](double a, double b) { return b - a <= kOneLevel * a; };
  levels.erase(std::unique(levels.begin(), levels.end(), same), levels.end());
}

// From `edge` to `end`, in steps of at most `step`.
void add_steps(double edge, double end, double step, std::vector<double>& levels) {
  const double whole = std::ceil(std::fabs(end - edge) / step - 1e-6);
  for (int i = 1; i <= static_cast<int>(std::min(whole, 1000.0)); ++i) {
    levels.push_back(edge + (end - edge) * i / whole);
  }
}

}  // namespace

CompiledLoadings own_loadings(const Hull& hull) {
  const Loading& own = hull.loading;
  return {{0.5 * (own.draught_aft + own.draught_fwd)}, {own.draught_aft - own.draught_fwd}};
}

std::vector<double> table_levels(const Hull& hull, const CompiledLoadings& loadings) {
  if (loadings.draughts.empty()) {
    throw std::invalid_argument("no draught: one at least is wanted");
  }
  CompiledLoadings all = loadings;
  if (all.trims.empty()) {
    all.trims.push_back(0.0);
  }
  check_numbers("draught", all.draughts, true);
  check_numbers("trim", all.trims, false);
  check_minimal(hull, all);
  std::vector<double> levels = all.draughts;
  sort_out(levels);
  const Range range = waterlines(hull, all);
  if (!(range.lowest > 0.0)) {
    throw std::invalid_argument(
        fmt::format("these trims bring a waterline to {:g} m above base: above 0 is wanted", range.lowest));
  }
  const double step = greatest_step(levels);
  const double lowest = levels.front();
  const double highest = levels.back();
  add_steps(lowest, range.lowest, step, levels);
  add_steps(highest, range.highest, step, levels);
  sort_out(levels);
  if (levels.size() > kMaxHullTableLevels) {
    throw std::invalid_argument(
        fmt::format("{} levels: at most {} are possible", levels.size(), kMaxHullTableLevels));
  }
  return levels;
}

}  // namespace quickstrip
