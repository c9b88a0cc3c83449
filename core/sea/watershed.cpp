#include "core/sea/watershed.hpp"

#include <algorithm>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

// A buoy's band has some 30 degrees of freedom: 27 % of noise. Two passes average about four bands, 14 %: a
// valley of 0.65 is then two and a half standard deviations.
constexpr int kSmoothingPasses = 2;

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
    copy_density();
    for (int pass = 0; pass < kSmoothingPasses; ++pass) {
      smooth_once();
    }
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
  void copy_density();
  void smooth_once();
  void sort_cells();
  void place_cell(std::uint16_t cell);
  void meet(std::uint16_t cell, std::uint16_t one, std::uint16_t other);
  void found_basin(std::uint16_t cell);

  // Halves the path on its way, so that paths stay short.
  [[nodiscard]] std::uint16_t root(std::uint16_t basin) const {
    for (std::size_t i = 0; i < kMaxBasins && work_.parent[basin] != basin; ++i) {
      work_.parent[basin] = work_.parent[work_.parent[basin]];
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

void Watershed::copy_density() {
  for (std::size_t f = 0; f < num_frequencies_; ++f) {
    for (std::size_t d = 0; d < num_directions_; ++d) {
      work_.height[f * num_directions_ + d] = spectrum_.density[f][d];
    }
  }
}

// 1-2-1 over direction, then over frequency, the end bands repeated. In place, one line at a time.
void Watershed::smooth_once() {
  for (std::size_t f = 0; f < num_frequencies_; ++f) {
    double* row = &work_.height[f * num_directions_];
    const double first = row[0];
    double before = row[num_directions_ - 1];
    for (std::size_t d = 0; d < num_directions_; ++d) {
      const double here = row[d];
      const double after = d + 1 < num_directions_ ? row[d + 1] : first;
      row[d] = 0.25 * (before + 2.0 * here + after);
      before = here;
    }
  }
  for (std::size_t d = 0; d < num_directions_; ++d) {
    double before = work_.height[d];
    for (std::size_t f = 0; f < num_frequencies_; ++f) {
      double& cell = work_.height[f * num_directions_ + d];
      const double here = cell;
      const double after = f + 1 < num_frequencies_ ? work_.height[(f + 1) * num_directions_ + d] : here;
      cell = 0.25 * (before + 2.0 * here + after);
      before = here;
    }
  }
}

void Watershed::sort_cells() {
  for (std::size_t cell = 0; cell < num_cells_; ++cell) {
    work_.order[cell] = static_cast<std::uint16_t>(cell);
    work_.basin[cell] = kNoBasin;
  }
  const auto end = work_.order.begin() + static_cast<std::ptrdiff_t>(num_cells_);
  const auto is_before = [this](std::uint16_t a, std::uint16_t b) {
    return work_.height[a] != work_.height[b] ? work_.height[a] > work_.height[b] : a < b;
  };
  // By heap: std::sort calls itself. The order is total, so any sort gives this one.
  std::make_heap(work_.order.begin(), end, is_before);
  std::sort_heap(work_.order.begin(), end, is_before);
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
