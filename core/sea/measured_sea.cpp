// place_on_grid for a measured directional spectrum.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/constants.hpp"
#include "core/base/legendre.hpp"
#include "core/sea/directional_spectrum.hpp"
#include "core/sea/energy_grid.hpp"
#include "core/sea/partition.hpp"
#include "core/sea/quadrature.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/sea/spreading.hpp"

namespace quickstrip {
namespace {

/// Integrals of the product of a band's hat function and a node's, [band][node].
using HatProducts = std::array<std::array<double, kMaxFrequencies>, kMaxSpectrumFrequencies>;

double hat(std::span<const double> x, std::size_t i, double at) {
  if (i > 0 && at < x[i]) {
    return std::max(0.0, (at - x[i - 1]) / (x[i] - x[i - 1]));
  }
  if (i + 1 < x.size() && at > x[i]) {
    return std::max(0.0, (x[i + 1] - at) / (x[i + 1] - x[i]));
  }
  return at < x[i] || at > x[i] ? 0.0 : 1.0;
}

// On a piece without a kink the product is a parabola: Simpson's rule is exact.
void add_piece(std::span<const double> bands, std::span<const double> omega, std::size_t b, std::size_t n,
               HatProducts& products) {
  const double from = std::max(bands[b], omega[n]);
  const double to = std::min(bands[b + 1], omega[n + 1]);
  if (!(from < to)) {
    return;
  }
  const double middle = 0.5 * (from + to);
  for (std::size_t i = b; i <= b + 1; ++i) {
    for (std::size_t j = n; j <= n + 1; ++j) {
      products[i][j] +=
          (to - from) / 6.0 *
          (hat(bands, i, from) * hat(omega, j, from) + 4.0 * hat(bands, i, middle) * hat(omega, j, middle) +
           hat(bands, i, to) * hat(omega, j, to));
    }
  }
}

HatProducts hat_products(std::span<const double> bands, std::span<const double> omega) {
  HatProducts products{};
  for (std::size_t b = 0; b + 1 < bands.size(); ++b) {
    for (std::size_t n = 0; n + 1 < omega.size(); ++n) {
      add_piece(bands, omega, b, n, products);
    }
  }
  return products;
}

// Legendre terms over the interval from node n of the hat function of band b, b or b + 1 being the band whose
// hat is taken: on [bands[b], bands[b + 1]] only. Degree 4, hence exact.
DensityTerms piece_terms(std::span<const double> bands, std::span<const double> omega, std::size_t b,
                         std::size_t n, std::size_t hat_of) {
  DensityTerms terms{};
  const double from = std::max(bands[b], omega[n]);
  const double to = std::min(bands[b + 1], omega[n + 1]);
  const double width = omega[n + 1] - omega[n];
  for_each_gauss_point(from, to, 1, [&](double w, double weight) {
    const auto p = legendre((w - omega[n]) / width);
    const double part = weight * hat(bands, hat_of, w);
    for (std::size_t l = 0; l < kDensityTerms; ++l) {
      terms[l] += part * p[l] * static_cast<double>(2 * l + 1) / width;
    }
  });
  return terms;
}

// What the hat function of one band holds: energy on the nodes, density between them, for a density of 1 at
// the band.
void place_band(std::span<const double> bands, std::span<const double> omega, std::size_t band,
                const HatProducts& products, EnergyBand& out) {
  std::copy(products[band].begin(), products[band].end(), out.node.begin());
  const std::size_t first = band > 0 ? band - 1 : 0;
  const std::size_t last = std::min(band + 1, bands.size() - 1);
  for (std::size_t b = first; b < last; ++b) {
    for (std::size_t n = 0; n + 1 < omega.size(); ++n) {
      if (!(std::max(bands[b], omega[n]) < std::min(bands[b + 1], omega[n + 1]))) {
        continue;
      }
      const DensityTerms terms = piece_terms(bands, omega, b, n, band);
      for (std::size_t l = 0; l < kDensityTerms; ++l) {
        out.density[n][l] += terms[l];
      }
    }
  }
}

/// For each grid direction: the two source directions around it and the share of the second.
struct DirectionMap {
  std::array<std::size_t, kNumDirections> first{};
  std::array<std::size_t, kNumDirections> second{};
  std::array<double, kNumDirections> share{};
};

DirectionMap direction_map(std::span<const double> directions) {
  const std::size_t n = directions.size();
  const double step = wrap_pi(directions[1] - directions[0]) > 0.0 ? kTwoPi / static_cast<double>(n)
                                                                   : -kTwoPi / static_cast<double>(n);
  DirectionMap map;
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    const double direction = kTwoPi * static_cast<double>(d) / static_cast<double>(kNumDirections);
    // Rounded to 2^-20 of a step: directions that lie on the grid but for rounding are taken as they are.
    const double place = (direction - directions[0]) / step;
    const double steps = std::ldexp(std::round(std::ldexp(place, 20)), -20);
    const double turned = steps - static_cast<double>(n) * std::floor(steps / static_cast<double>(n));
    map.first[d] = static_cast<std::size_t>(turned) % n;
    map.second[d] = (map.first[d] + 1) % n;
    map.share[d] = turned - std::floor(turned);
  }
  return map;
}

// One band of one system onto the 72 directions: energy per rad/s of band width, the band's energy kept.
DirectionWeights mapped_row(const DirectionalSpectrum& spectrum, const WavePartition& partition,
                            const DirectionMap& map, std::size_t band, std::size_t system) {
  const auto value = [&](std::size_t d) {
    return partition.system_of[band][d] == system ? spectrum.density[band][d] : 0.0;
  };
  double row = 0.0;
  for (std::size_t d = 0; d < spectrum.directions.size(); ++d) {
    row += value(d);
  }
  DirectionWeights mapped{};
  double sum = 0.0;
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    mapped[d] = (1.0 - map.share[d]) * value(map.first[d]) + map.share[d] * value(map.second[d]);
    sum += mapped[d];
  }
  const double energy = row * kTwoPi / static_cast<double>(spectrum.directions.size());
  const double scale = sum > 0.0 ? energy / sum : 0.0;
  for (double& m : mapped) {
    m *= scale;
  }
  return mapped;
}

// The bands that a system has energy in.
void set_range(std::size_t num_bands, SystemEnergy& part) {
  const auto is_empty = [&part](std::size_t b) {
    return std::all_of(part.factor[b].begin(), part.factor[b].end(), [](double x) { return x == 0.0; });
  };
  std::size_t end = num_bands;
  part.first = 0;
  while (part.first < num_bands && is_empty(part.first)) {
    ++part.first;
  }
  while (end > part.first && is_empty(end - 1)) {
    --end;
  }
  part.count = end - part.first;
}

// One system's directions, scaled to its m0; the two bands behind the spectrum's own are the end nodes.
// Returns the energy on the nodes before.
double place_system(const DirectionalSpectrum& spectrum, const DirectionMap& map,
                    std::span<const double> omega, std::size_t system, SeaEnergy& out) {
  const BandWidths widths = band_widths(spectrum.frequencies.span());
  const std::size_t num_bands = spectrum.frequencies.size();
  SystemEnergy& part = out.part[system];
  DirectionWeights whole{};  // over all frequencies, on the nodes or not
  double on_nodes = 0.0;
  for (std::size_t b = 0; b < num_bands; ++b) {
    part.factor[b] = mapped_row(spectrum, out.partition, map, b, system);
    const auto& node = out.band[b].node;
    const double of_band = std::accumulate(node.begin(), node.end(), 0.0);
    for (std::size_t d = 0; d < kNumDirections; ++d) {
      whole[d] += part.factor[b][d] * widths[b];
      on_nodes += part.factor[b][d] * of_band;
    }
  }
  const double m0 = out.partition.m0[system];
  const bool beyond = on_nodes < kLeastShare * m0;
  const double scale = beyond ? 0.0 : m0 / on_nodes;
  for (std::size_t b = 0; b < num_bands; ++b) {
    for (double& factor : part.factor[b]) {
      factor *= scale;
    }
  }
  const double peak = kTwoPi / out.partition.system[system].period;
  const bool below = peak < omega.front();
  part.factor[num_bands] = beyond && below ? whole : DirectionWeights{};
  part.factor[num_bands + 1] = beyond && !below ? whole : DirectionWeights{};
  set_range(num_bands + 2, part);
  return on_nodes;
}

}  // namespace

Status place_on_grid(const DirectionalSpectrum& spectrum, std::span<const double> omega, SeaEnergy& out) {
  out.num_systems = 0;
  if (const Status fit = check_nodes(omega); !fit) {
    return fit;
  }
  if (const Status fit = divide_into_systems(spectrum, out.workspace, out.partition); !fit) {
    return fit;
  }
  clear_grid(omega.size(), out);
  const HatProducts products = hat_products(spectrum.frequencies.span(), omega);
  for (std::size_t b = 0; b < spectrum.frequencies.size(); ++b) {
    place_band(spectrum.frequencies.span(), omega, b, products, add_band(out));
  }
  add_band(out).node[0] = 1.0;
  add_band(out).node[omega.size() - 1] = 1.0;
  const DirectionMap map = direction_map(spectrum.directions.span());
  double m0 = 0.0;
  double on_nodes = 0.0;
  for (std::size_t s = 0; s < out.partition.num_systems; ++s) {
    on_nodes += place_system(spectrum, map, omega, s, out);
    m0 += out.partition.m0[s];
    out.system[s] = out.partition.system[s];
  }
  out.num_systems = out.partition.num_systems;
  complete(m0, on_nodes, out);
  return {};
}

}  // namespace quickstrip
