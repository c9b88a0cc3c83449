#include "sim/picture/governing_regions.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>

#include "sim/picture/polar_geometry.hpp"

namespace quickstrip {
namespace {

// Of response_t's quantity: surge sway heave roll pitch yaw, acceleration along x y z, slamming, wetness,
// emergence of the propeller, sickness, interruptions.
constexpr std::string_view kQuantityLetters = "ZYHRPQXLVSWEKI";

struct CellIndex {
  int speed = 0;
  int heading = 0;
};

/// Fills one region from a seed; `seen` marks its cells.
std::vector<CellIndex> flood(const grid_t& grid, CellIndex seed, std::vector<char>& seen) {
  const int criterion = shown_criterion(grid, seed.speed, seed.heading);
  const auto place = [&grid](CellIndex c) {
    return static_cast<std::size_t>(c.speed) * static_cast<std::size_t>(grid.num_headings) +
           static_cast<std::size_t>(c.heading);
  };
  std::vector<CellIndex> cells{seed};
  seen[place(seed)] = 1;
  for (std::size_t i = 0; i < cells.size(); ++i) {  // grows to at most the whole grid
    const CellIndex at = cells[i];
    const std::array<CellIndex, 4> neighbours{
        CellIndex{at.speed - 1, at.heading}, CellIndex{at.speed + 1, at.heading},
        CellIndex{at.speed, (at.heading + 1) % grid.num_headings},
        CellIndex{at.speed, (at.heading + grid.num_headings - 1) % grid.num_headings}};
    for (const CellIndex next : neighbours) {
      if (next.speed < 0 || next.speed >= grid.num_speeds || seen[place(next)] != 0 ||
          shown_criterion(grid, next.speed, next.heading) != criterion) {
        continue;
      }
      seen[place(next)] = 1;
      cells.push_back(next);
    }
  }
  return cells;
}

GoverningRegion summary(const grid_t& grid, const std::vector<CellIndex>& cells) {
  GoverningRegion region;
  region.criterion = shown_criterion(grid, cells.front().speed, cells.front().heading);
  double sum_x = 0.0;
  double sum_y = 0.0;
  for (const CellIndex c : cells) {
    const double area = cell_area(grid, c.speed);
    const PlanePoint p = cell_centre(grid, c.speed, c.heading);
    region.area += area;
    sum_x += area * p.x;
    sum_y += area * p.y;
  }
  const auto distance2 = [&](CellIndex c) {
    const PlanePoint p = cell_centre(grid, c.speed, c.heading);
    const double dx = p.x - sum_x / region.area;
    const double dy = p.y - sum_y / region.area;
    return dx * dx + dy * dy;
  };
  const auto nearest = std::min_element(
      cells.begin(), cells.end(), [&](CellIndex a, CellIndex b) { return distance2(a) < distance2(b); });
  region.speed = nearest->speed;
  region.heading = nearest->heading;
  return region;
}

}  // namespace

int shown_criterion(const grid_t& grid, int speed, int heading) {
  const int verdict = grid.verdict[speed][heading];
  const bool needs_a_reason = verdict == grid_t::VERDICT_CAUTION || verdict == grid_t::VERDICT_EXCEEDED;
  return needs_a_reason ? grid.governing[speed][heading] : -1;
}

std::vector<std::string> criterion_letters(const limits_t& limits) {
  std::map<int, int> num_of_quantity;
  for (int i = 0; i < limits.num_criteria; ++i) {
    ++num_of_quantity[limits.quantity[i]];
  }
  std::map<int, int> number;
  std::vector<std::string> letters;
  for (int i = 0; i < limits.num_criteria; ++i) {
    const int quantity = limits.quantity[i];
    const bool is_known = quantity >= 0 && static_cast<std::size_t>(quantity) < kQuantityLetters.size();
    std::string letter(1, is_known ? kQuantityLetters[static_cast<std::size_t>(quantity)] : '?');
    if (num_of_quantity[quantity] > 1) {
      letter += std::to_string(++number[quantity]);
    }
    letters.push_back(letter);
  }
  return letters;
}

std::vector<GoverningRegion> governing_regions(const grid_t& grid) {
  std::vector<char> seen(static_cast<std::size_t>(grid.num_speeds) *
                         static_cast<std::size_t>(grid.num_headings));
  std::vector<GoverningRegion> regions;
  for (int s = 0; s < grid.num_speeds; ++s) {
    for (int h = 0; h < grid.num_headings; ++h) {
      const auto place = static_cast<std::size_t>(s) * static_cast<std::size_t>(grid.num_headings) +
                         static_cast<std::size_t>(h);
      if (seen[place] == 0 && shown_criterion(grid, s, h) >= 0) {
        regions.push_back(summary(grid, flood(grid, {s, h}, seen)));
      }
    }
  }
  return regions;
}

}  // namespace quickstrip
