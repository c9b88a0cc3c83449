#include "core/sea/watershed.hpp"

#include <algorithm>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

class Watershed {
 public:
  Watershed(const DirectionalSpectrum& spectrum, double valley, PartitionWorkspace& work)
      : spectrum_(spectrum),
        work_(work),
        valley_(valley),
        num_frequencies_(spectrum.frequencies.size()),
        num_directions_(spectrum.directions.size()),
        num_cells_(num_frequencies_ * num_directions_) {}

  std::size_t find() {
    smooth();
    sort_cells();
    for (std::size_t i = 0; i < num_cells_ && work_.height[work_.order[i]] > 0.0; ++i) {
      place_cell(work_.order[i]);
    }
    for (std::size_t cell = 0; cell < num_cells_; ++cell) {
      if (work_.basin[cell] != kNoBasin) {
        work_.basin[cell] = root(work_.basin[cell]);
      }
    }
    return num_basins_;
  }

 private:
  void smooth();
  void sort_cells();
  void place_cell(std::uint16_t cell);
  void meet(std::uint16_t cell, std::uint16_t one, std::uint16_t other);
  void found_basin(std::uint16_t cell);

  [[nodiscard]] std::uint16_t root(std::uint16_t basin) const {
    for (std::size_t i = 0; i < kMaxBasins && work_.parent[basin] != basin; ++i) {
      basin = work_.parent[basin];
    }
    return basin;
  }

  /// Calls visit(neighbour) for the cells around that have been placed (the cell itself has not).
  template <typename Visit>
  void for_each_placed_neighbour(std::size_t cell, Visit visit) const {
    const std::size_t f = cell / num_directions_;
    const std::size_t d = cell % num_directions_;
    for (std::size_t g = f == 0 ? 0 : f - 1; g <= std::min(f + 1, num_frequencies_ - 1); ++g) {
      for (std::size_t turn = 0; turn < 3; ++turn) {
        const std::size_t neighbour =
            g * num_directions_ + (d + num_directions_ + turn - 1) % num_directions_;
        if (work_.basin[neighbour] != kNoBasin) {
          visit(static_cast<std::uint16_t>(neighbour));
        }
      }
    }
  }

  const DirectionalSpectrum& spectrum_;
  PartitionWorkspace& work_;
  double valley_;
  std::size_t num_frequencies_;
  std::size_t num_directions_;
  std::size_t num_cells_;
  std::size_t num_basins_ = 0;
};

// 1-2-1 over frequency and direction: noise between neighbouring bands makes no peaks.
void Watershed::smooth() {
  for (std::size_t f = 0; f < num_frequencies_; ++f) {
    const auto& here = spectrum_.density[f];
    const auto& below = spectrum_.density[f == 0 ? 0 : f - 1];
    const auto& above = spectrum_.density[f + 1 == num_frequencies_ ? f : f + 1];
    const auto column = [&](std::size_t d) { return below[d] + 2.0 * here[d] + above[d]; };
    for (std::size_t d = 0; d < num_directions_; ++d) {
      const double left = column((d + num_directions_ - 1) % num_directions_);
      const double right = column((d + 1) % num_directions_);
      work_.height[f * num_directions_ + d] = (left + 2.0 * column(d) + right) / 16.0;
    }
  }
}

void Watershed::sort_cells() {
  for (std::size_t cell = 0; cell < num_cells_; ++cell) {
    work_.order[cell] = static_cast<std::uint16_t>(cell);
    work_.basin[cell] = kNoBasin;
  }
  const auto end = work_.order.begin() + static_cast<std::ptrdiff_t>(num_cells_);
  std::sort(work_.order.begin(), end, [this](std::uint16_t a, std::uint16_t b) {
    return work_.height[a] != work_.height[b] ? work_.height[a] > work_.height[b] : a < b;
  });
}

// All placed cells are higher: the cell joins the basin of the highest around it, or founds one.
void Watershed::place_cell(std::uint16_t cell) {
  std::uint16_t highest = kNoBasin;
  for_each_placed_neighbour(cell, [&](std::uint16_t neighbour) {
    if (highest == kNoBasin || work_.height[neighbour] > work_.height[highest]) {
      highest = neighbour;
    }
  });
  if (highest == kNoBasin) {
    found_basin(cell);
    return;
  }
  for_each_placed_neighbour(cell, [&](std::uint16_t neighbour) {
    meet(cell, root(work_.basin[highest]), root(work_.basin[neighbour]));
  });
  work_.basin[cell] = work_.basin[highest];
}

// The cell is the highest pass between the two basins: cells come in descending order.
void Watershed::meet(std::uint16_t cell, std::uint16_t one, std::uint16_t other) {
  if (one == other) {
    return;
  }
  const bool one_is_higher = work_.height[work_.peak[one]] >= work_.height[work_.peak[other]];
  const std::uint16_t upper = one_is_higher ? one : other;
  const std::uint16_t lower = one_is_higher ? other : one;
  if (work_.height[cell] > valley_ * work_.height[work_.peak[lower]]) {
    work_.parent[lower] = upper;
  }
}

void Watershed::found_basin(std::uint16_t cell) {
  QS_CHECK(num_basins_ < kMaxBasins);
  const auto basin = static_cast<std::uint16_t>(num_basins_);
  work_.parent[basin] = basin;
  work_.peak[basin] = cell;
  work_.basin[cell] = basin;
  ++num_basins_;
}

}  // namespace

std::size_t find_basins(const DirectionalSpectrum& spectrum, double valley, PartitionWorkspace& work) {
  return Watershed(spectrum, valley, work).find();
}

}  // namespace quickstrip
