// What a sea holds at one direction and node, whatever the bands it is kept in.
#pragma once

#include <cstddef>

#include "core/sea/sea_energy.hpp"

namespace quickstrip {

/// Energy of one system from compass direction d on node f [m2].
inline double energy_at(const SeaEnergy& sea, std::size_t system, std::size_t d, std::size_t f) {
  const SystemEnergy& part = sea.part[system];
  double sum = 0.0;
  for (std::size_t b = part.first; b < part.first + part.count; ++b) {
    sum += part.factor[b][d] * sea.band[b].node[f];
  }
  return sum;
}

/// Of all systems together.
inline double total_energy_at(const SeaEnergy& sea, std::size_t d, std::size_t f) {
  double sum = 0.0;
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    sum += energy_at(sea, s, d, f);
  }
  return sum;
}

/// Density of the interval from node i [m2 s].
inline DensityTerms density_at(const SeaEnergy& sea, std::size_t system, std::size_t d, std::size_t i) {
  const SystemEnergy& part = sea.part[system];
  DensityTerms sum{};
  for (std::size_t b = part.first; b < part.first + part.count; ++b) {
    for (std::size_t l = 0; l < kDensityTerms; ++l) {
      sum[l] += part.factor[b][d] * sea.band[b].density[i][l];
    }
  }
  return sum;
}

}  // namespace quickstrip
