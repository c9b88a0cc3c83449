#include "core/response/met_energy.hpp"

#include <cmath>

#include "core/base/constants.hpp"
#include "core/sea/energy_grid.hpp"

namespace quickstrip {
namespace {

void clear(EnergyBand& out) {
  out.node.fill(0.0);
  out.density.fill(DensityTerms{});
  out.first = kMaxFrequencies - 1;
  out.last = 0;
}

void add_band(const EnergyBand& band, double factor, EnergyBand& out) {
  for (std::size_t f = band.first; f <= band.last; ++f) {
    out.node[f] += factor * band.node[f];
  }
  for (std::size_t f = band.first; f < band.last; ++f) {
    for (std::size_t l = 0; l < kDensityTerms; ++l) {
      out.density[f][l] += factor * band.density[f][l];
    }
  }
  out.first = std::min(out.first, band.first);
  out.last = std::max(out.last, band.last);
}

/// What a system takes of a band from one relative direction.
double share(const DirectionWeights& factor, const HeadingBracket& heading, std::size_t m) {
  return (1.0 - heading.part) * factor[wave_direction(heading.below, m)] +
         heading.part * factor[wave_direction(heading.above, m)];
}

// As on the grid itself: products of what is there may be too small to be quick.
void close(EnergyBand& out) {
  out.first = std::min(out.first, out.last);
  for (double& energy : out.node) {
    energy = std::fabs(energy) < kLeastEnergy ? 0.0 : energy;
  }
}

}  // namespace

HeadingBracket bracket_heading(Heading heading) {
  const double turned = wrap_two_pi(heading.radians) / kTwoPi * static_cast<double>(kNumDirections);
  const double below = std::floor(turned);
  const std::size_t h = static_cast<std::size_t>(below) % kNumDirections;
  return {h, (h + 1) % kNumDirections, turned - below};
}

std::size_t wave_direction(std::size_t h, std::size_t m) {
  return (h + kNumDirections / 2 + kNumDirections - m) % kNumDirections;
}

bool meet_energy(const SeaEnergy& sea, std::size_t s, const HeadingBracket& heading, std::size_t solved_m,
                 MetEnergy& out) {
  clear(out.even);
  clear(out.odd);
  const SystemEnergy& system = sea.part[s];
  const bool has_port = has_two_sides(solved_m);
  bool is_empty = true;
  for (std::size_t b = system.first; b < system.first + system.count; ++b) {
    const double starboard = share(system.factor[b], heading, solved_m);
    const double port = has_port ? share(system.factor[b], heading, kNumDirections - solved_m) : 0.0;
    if (starboard != 0.0 || port != 0.0) {
      add_band(sea.band[b], starboard + port, out.even);
      add_band(sea.band[b], starboard - port, out.odd);
      is_empty = false;
    }
  }
  close(out.even);
  close(out.odd);
  return !is_empty;
}

}  // namespace quickstrip
