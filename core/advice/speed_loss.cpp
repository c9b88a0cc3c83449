#include "core/advice/speed_loss.hpp"

#include <algorithm>
#include <cstddef>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

constexpr int kBisections = 24;  // of 0 ... V0: to 1e-6 m/s

/// In a column of the grid, between its speeds.
double added_between(const Grid& grid, std::size_t heading, double speed) {
  std::size_t upper = 0;
  while (upper + 1 < grid.num_speeds && grid.speeds[upper] < speed) {
    ++upper;
  }
  const double at_upper = added_resistance(grid.cells[upper][heading]);
  if (upper == 0 || grid.speeds[upper] <= speed) {
    return at_upper;
  }
  const double at_lower = added_resistance(grid.cells[upper - 1][heading]);
  const double step = grid.speeds[upper] - grid.speeds[upper - 1];
  return at_lower + (at_upper - at_lower) * (speed - grid.speeds[upper - 1]) / step;
}

}  // namespace

double calm_water_resistance(const ResistanceTable& table, double speed) {
  QS_CHECK(!table.empty());
  const auto beyond = [speed](const CalmWaterResistance& end) {
    const double ratio = speed / end.speed;
    return end.force * ratio * ratio;
  };
  if (speed <= table[0].speed) {
    return beyond(table[0]);
  }
  for (std::size_t i = 1; i < table.size(); ++i) {
    if (speed <= table[i].speed) {
      const double part = (speed - table[i - 1].speed) / (table[i].speed - table[i - 1].speed);
      return table[i - 1].force + part * (table[i].force - table[i - 1].force);
    }
  }
  return beyond(table[table.size() - 1]);
}

double added_resistance(const Cell& cell) {
  // kNoResistance is far below zero: the larger one that is at hand.
  const float larger = std::max(cell.added_resistance, cell.added_resistance_empirical);
  return std::max(0.0, static_cast<double>(larger));
}

double speed_kept(const ResistanceTable& table, const Grid& grid, std::size_t heading, double ordered) {
  const double power = calm_water_resistance(table, ordered) * ordered;
  const auto is_too_fast = [&](double speed) {
    return (calm_water_resistance(table, speed) + added_between(grid, heading, speed)) * speed > power;
  };
  if (!is_too_fast(ordered)) {
    return ordered;
  }
  double low = 0.0;
  double high = ordered;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (is_too_fast(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

void fill_speed_loss(const ResistanceTable& table, Grid& grid) {
  if (table.empty()) {
    return;
  }
  const CalmWaterResistance& full = table[table.size() - 1];
  for (std::size_t v = 0; v < grid.num_speeds; ++v) {
    for (std::size_t h = 0; h < grid.num_headings; ++h) {
      Cell& cell = grid.cells[v][h];
      const double speed = grid.speeds[v];
      cell.speed_loss = static_cast<float>(speed - speed_kept(table, grid, h, speed));
      const double wanted = (calm_water_resistance(table, speed) + added_resistance(cell)) * speed;
      if (wanted > full.force * full.speed) {
        cell.quality |= kQualitySpeedNotKept;
      }
    }
  }
}

}  // namespace quickstrip
