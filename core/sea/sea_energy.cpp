#include "core/sea/sea_energy.hpp"

#include <algorithm>

#include "core/base/constants.hpp"
#include "core/sea/energy_grid.hpp"
#include "core/sea/moments.hpp"
#include "core/sea/spectrum.hpp"
#include "core/sea/spreading.hpp"

namespace quickstrip {
namespace {

using NodeEnergies = std::array<double, kMaxFrequencies>;

// `shares` over direction sum to 1. Returns the energy on the nodes before scaling.
double place_system(const Spectrum& spectrum, const DirectionWeights& shares, std::span<const double> omega,
                    GridOfSystem& grid, SeaEnergy::Densities& densities) {
  NodeEnergies nodes{};
  const std::span<double> energies(nodes.data(), omega.size());
  hat_energies(spectrum, omega, energies);
  double sum = 0.0;
  for (const double e : energies) {
    sum += e;
  }
  const double on_nodes = sum;
  const bool beyond = sum < kLeastShare * spectrum.m0;
  if (beyond) {
    std::fill(energies.begin(), energies.end(), 0.0);
    energies[spectrum.peak_frequency < omega.front() ? 0 : omega.size() - 1] = spectrum.m0;
    sum = spectrum.m0;
  }
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    for (std::size_t f = 0; f < omega.size(); ++f) {
      grid[d][f] = shares[d] * energies[f] * (spectrum.m0 / sum);
    }
  }
  for (std::size_t i = 0; i + 1 < omega.size() && !beyond; ++i) {
    const DensityTerms terms = density_terms(spectrum, omega[i], omega[i + 1]);
    for (std::size_t d = 0; d < kNumDirections; ++d) {
      for (std::size_t l = 0; l < kDensityTerms; ++l) {
        densities[d][i][l] = shares[d] * terms[l] * (spectrum.m0 / sum);
      }
    }
  }
  return on_nodes;
}

}  // namespace

Status place_on_grid(const SeaState& sea, std::span<const double> omega, SeaEnergy& out) {
  out.num_systems = 0;
  if (const Status fit = check_nodes(omega); !fit) {
    return fit;
  }
  if (sea.systems.empty()) {
    return Error::kEmptySpectrum;
  }
  clear_grid(omega.size(), out);
  double m0 = 0.0;
  double on_nodes = 0.0;
  for (std::size_t s = 0; s < sea.systems.size(); ++s) {
    const WaveSystem& system = sea.systems[s];
    const Result<Spectrum> spectrum = spectrum_of(system);
    if (!spectrum) {
      return spectrum.error();
    }
    const Result<DirectionWeights> shares = direction_weights(system.from, system.spreading);
    if (!shares) {
      return shares.error();
    }
    on_nodes += place_system(*spectrum, *shares, omega, out.energy[s], out.density[s]);
    m0 += spectrum->m0;
    out.system[s] = system;
    out.system[s].from.radians = wrap_two_pi(system.from.radians);
    out.system[s].period = kTwoPi / spectrum->peak_frequency;
    out.system[s].period_kind = PeriodKind::kPeak;
  }
  out.num_systems = sea.systems.size();
  sum_up(m0, on_nodes, out);
  return {};
}

}  // namespace quickstrip
