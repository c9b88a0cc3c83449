#include "core/sea/partition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/sea/directional_spectrum.hpp"
#include "core/sea/moments.hpp"
#include "core/sea/spreading.hpp"

namespace quickstrip {
namespace {

constexpr double kValley = 0.65;            // of the lower peak: above it there is no valley
constexpr double kCloseness = 0.5;          // of the smaller mean square spread
constexpr double kSmallest = 0.02;          // of the energy
constexpr std::size_t kMaxCandidates = 32;  // basins that may become systems, by energy

/// A place in the plane omega (cos, sin) of the direction.
struct Place {
  double x = 0.0;
  double y = 0.0;
};

double distance2(const Place& a, const Place& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// Sums over the cells of a basin; two basins become one by adding their sums.
struct Candidate {
  double energy = 0.0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  double sum_square = 0.0;
  double peak_height = 0.0;
  Place peak;

  [[nodiscard]] Place centre() const { return {sum_x / energy, sum_y / energy}; }
  [[nodiscard]] double mean_square_spread() const {
    const Place c = centre();
    return std::max(0.0, sum_square / energy - c.x * c.x - c.y * c.y);
  }
  void add_cell(double cell_energy, const Place& p) {
    energy += cell_energy;
    sum_x += cell_energy * p.x;
    sum_y += cell_energy * p.y;
    sum_square += cell_energy * (p.x * p.x + p.y * p.y);
  }
  void add(const Candidate& other) {
    energy += other.energy;
    sum_x += other.sum_x;
    sum_y += other.sum_y;
    sum_square += other.sum_square;
    if (other.peak_height > peak_height) {
      peak_height = other.peak_height;
      peak = other.peak;
    }
  }
};

class Division {
 public:
  Division(const DirectionalSpectrum& spectrum, PartitionWorkspace& work)
      : spectrum_(spectrum), work_(work), widths_(band_widths(spectrum.frequencies.span())) {}

  void gather(std::size_t num_basins);
  void merge();
  void assign(WavePartition& out) const;

 private:
  [[nodiscard]] std::size_t num_directions() const { return spectrum_.directions.size(); }
  [[nodiscard]] std::size_t num_cells() const { return spectrum_.frequencies.size() * num_directions(); }
  [[nodiscard]] double cell_energy(std::size_t cell) const {
    const std::size_t f = cell / num_directions();
    return spectrum_.density[f][cell % num_directions()] * widths_[f] * kTwoPi /
           static_cast<double>(num_directions());
  }
  [[nodiscard]] Place place(std::size_t cell) const {
    const double omega = spectrum_.frequencies[cell / num_directions()];
    const double from = spectrum_.directions[cell % num_directions()];
    return {omega * std::cos(from), omega * std::sin(from)};
  }
  void choose_candidates(std::size_t num_basins);
  [[nodiscard]] std::size_t nearest(const Place& p, std::size_t except) const;
  [[nodiscard]] bool merge_close_pair();
  [[nodiscard]] bool merge_smallest();
  void merge_into(std::size_t from, std::size_t into);

  const DirectionalSpectrum& spectrum_;
  PartitionWorkspace& work_;
  BandWidths widths_;
  std::array<Candidate, kMaxCandidates> candidates_{};
  std::size_t num_candidates_ = 0;
};

// work_.parent becomes the candidate of each basin, or kNoBasin.
void Division::choose_candidates(std::size_t num_basins) {
  std::fill(work_.parent.begin(), work_.parent.end(), kNoBasin);
  const auto end = work_.energy.begin() + static_cast<std::ptrdiff_t>(num_basins);
  // bounded: counts to a constant
  for (num_candidates_ = 0; num_candidates_ < kMaxCandidates; ++num_candidates_) {
    const auto best = std::max_element(work_.energy.begin(), end);
    if (best == end || !(*best > 0.0)) {
      break;
    }
    const auto basin = static_cast<std::size_t>(best - work_.energy.begin());
    candidates_[num_candidates_].peak_height = work_.height[work_.peak[basin]];
    candidates_[num_candidates_].peak = place(work_.peak[basin]);
    work_.parent[basin] = static_cast<std::uint16_t>(num_candidates_);
    *best = 0.0;
  }
}

// The basins with most energy; work_.basin becomes the candidate of each cell, or kNoBasin.
void Division::gather(std::size_t num_basins) {
  std::fill(work_.energy.begin(), work_.energy.end(), 0.0);
  for (std::size_t cell = 0; cell < num_cells(); ++cell) {
    if (work_.basin[cell] != kNoBasin) {
      work_.energy[work_.basin[cell]] += cell_energy(cell);
    }
  }
  choose_candidates(num_basins);
  for (std::size_t cell = 0; cell < num_cells(); ++cell) {
    std::uint16_t& basin = work_.basin[cell];
    basin = basin == kNoBasin ? kNoBasin : work_.parent[basin];
    if (basin != kNoBasin) {
      candidates_[basin].add_cell(cell_energy(cell), place(cell));
    }
  }
}

void Division::merge_into(std::size_t from, std::size_t into) {
  candidates_[into].add(candidates_[from]);
  --num_candidates_;
  for (std::size_t i = from; i < num_candidates_; ++i) {
    candidates_[i] = candidates_[i + 1];
  }
  for (std::size_t cell = 0; cell < num_cells(); ++cell) {
    std::uint16_t& basin = work_.basin[cell];
    if (basin == kNoBasin) {
      continue;
    }
    if (basin == from) {
      basin = static_cast<std::uint16_t>(into);
    }
    if (basin > from) {
      --basin;
    }
  }
}

std::size_t Division::nearest(const Place& p, std::size_t except) const {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < num_candidates_; ++i) {
    const double d2 = distance2(p, candidates_[i].centre());
    if (i != except && d2 < least) {
      least = d2;
      best = i;
    }
  }
  return best;
}

bool Division::merge_close_pair() {
  for (std::size_t i = 0; i < num_candidates_; ++i) {
    for (std::size_t j = i + 1; j < num_candidates_; ++j) {
      const Candidate& a = candidates_[i];
      const Candidate& b = candidates_[j];
      if (distance2(a.peak, b.peak) < kCloseness * std::min(a.mean_square_spread(), b.mean_square_spread())) {
        merge_into(j, i);
        return true;
      }
    }
  }
  return false;
}

bool Division::merge_smallest() {
  double total = 0.0;
  std::size_t smallest = 0;
  for (std::size_t i = 0; i < num_candidates_; ++i) {
    total += candidates_[i].energy;
    smallest = candidates_[i].energy < candidates_[smallest].energy ? i : smallest;
  }
  const bool fits = num_candidates_ <= kMaxWaveSystems && !(candidates_[smallest].energy < kSmallest * total);
  if (num_candidates_ < 2 || fits) {
    return false;
  }
  merge_into(smallest, nearest(candidates_[smallest].centre(), smallest));
  return true;
}

// Every merger takes one candidate away: at most kMaxCandidates rounds of either kind.
void Division::merge() {
  for (std::size_t i = 0; i < kMaxCandidates && merge_close_pair(); ++i) {
  }
  for (std::size_t i = 0; i < kMaxCandidates && merge_smallest(); ++i) {
  }
}

// Systems in descending order of energy; cells of forgotten basins to the nearest.
void Division::assign(WavePartition& out) const {
  std::array<std::uint8_t, kMaxCandidates> rank{};
  for (std::size_t i = 0; i < num_candidates_; ++i) {
    for (std::size_t j = 0; j < num_candidates_; ++j) {
      const bool before = candidates_[j].energy > candidates_[i].energy ||
                          (!(candidates_[j].energy < candidates_[i].energy) && j < i);
      rank[i] = static_cast<std::uint8_t>(rank[i] + (before ? 1 : 0));
    }
  }
  out.num_systems = num_candidates_;
  for (std::size_t cell = 0; cell < num_cells(); ++cell) {
    const std::uint16_t basin = work_.basin[cell];
    const std::size_t owner = basin == kNoBasin ? nearest(place(cell), kMaxCandidates) : basin;
    out.system_of[cell / num_directions()][cell % num_directions()] = rank[owner];
  }
}

}  // namespace

Status divide_into_systems(const DirectionalSpectrum& spectrum, PartitionWorkspace& work,
                           WavePartition& out) {
  if (const Status fit = check_spectrum(spectrum); !fit) {
    return fit;
  }
  const std::size_t num_basins = find_basins(spectrum, kValley, work);
  Division division(spectrum, work);
  division.gather(num_basins);
  division.merge();
  division.assign(out);
  describe_systems(spectrum, out);
  return {};
}

}  // namespace quickstrip
