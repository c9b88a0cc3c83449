#include "core/sea/energy_grid.hpp"

#include <algorithm>
#include <cmath>

#include "core/sea/moments.hpp"

namespace quickstrip {

Status check_nodes(std::span<const double> omega) {
  if (omega.size() < 3 || omega.size() > kMaxFrequencies) {
    return Error::kOutOfRange;
  }
  double last = 0.0;
  for (const double w : omega) {
    if (!std::isfinite(w)) {
      return Error::kNotFinite;
    }
    if (!(w > last)) {
      return Error::kOutOfRange;
    }
    last = w;
  }
  return {};
}

void clear_grid(std::size_t num_frequencies, SeaEnergy& out) {
  out.num_systems = 0;
  out.num_frequencies = num_frequencies;
  for (auto& system : out.energy) {
    for (auto& direction : system) {
      direction.fill(0.0);
    }
  }
  for (auto& direction : out.total) {
    direction.fill(0.0);
  }
  for (auto& system : out.density) {
    for (auto& direction : system) {
      direction.fill(DensityTerms{});
    }
  }
  for (auto& direction : out.total_density) {
    direction.fill(DensityTerms{});
  }
  out.system.fill(WaveSystem{});
  out.lost_tail = 0.0;
  out.hs = 0.0;
}

void sum_up(double m0, double on_nodes, SeaEnergy& out) {
  for (std::size_t s = 0; s < out.num_systems; ++s) {
    for (std::size_t d = 0; d < kNumDirections; ++d) {
      for (std::size_t f = 0; f < out.num_frequencies; ++f) {
        out.total[d][f] += out.energy[s][d][f];
      }
      for (std::size_t i = 0; i + 1 < out.num_frequencies; ++i) {
        for (std::size_t l = 0; l < kDensityTerms; ++l) {
          out.total_density[d][i][l] += out.density[s][d][i][l];
        }
      }
    }
  }
  out.hs = significant_wave_height(m0);
  out.lost_tail = std::clamp(1.0 - on_nodes / m0, 0.0, 1.0);
}

}  // namespace quickstrip
