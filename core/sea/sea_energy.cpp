#include "core/sea/sea_energy.hpp"

#include <algorithm>

#include "core/base/constants.hpp"
#include "core/sea/energy_grid.hpp"
#include "core/sea/moments.hpp"
#include "core/sea/spectrum.hpp"
#include "core/sea/spreading.hpp"

namespace quickstrip {
namespace {

// One band, scaled to the spectrum's m0. Returns the energy on the nodes before scaling.
double place_spectrum(const Spectrum& spectrum, std::span<const double> omega, EnergyBand& band) {
  if (spectrum.m0 < kLeastEnergy) {
    return spectrum.m0;  // flat water: nothing to scale by
  }
  const std::span<double> energies(band.node.data(), omega.size());
  hat_energies(spectrum, omega, energies);
  double on_nodes = 0.0;
  for (const double e : energies) {
    on_nodes += e;
  }
  if (on_nodes < kLeastShare * spectrum.m0) {
    std::fill(energies.begin(), energies.end(), 0.0);
    energies[spectrum.peak_frequency < omega.front() ? 0 : omega.size() - 1] = spectrum.m0;
    return on_nodes;
  }
  const double scale = spectrum.m0 / on_nodes;
  for (double& e : energies) {
    e *= scale;
  }
  for (std::size_t i = 0; i + 1 < omega.size(); ++i) {
    const DensityTerms terms = density_terms(spectrum, omega[i], omega[i + 1]);
    for (std::size_t l = 0; l < kDensityTerms; ++l) {
      band.density[i][l] = scale * terms[l];
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
    on_nodes += place_spectrum(*spectrum, omega, add_band(out));
    out.part[s].first = s;
    out.part[s].count = 1;
    out.part[s].factor[s] = *shares;
    m0 += spectrum->m0;
    out.system[s] = system;
    out.system[s].from.radians = wrap_two_pi(system.from.radians);
    out.system[s].period = kTwoPi / spectrum->peak_frequency;
    out.system[s].period_kind = PeriodKind::kPeak;
  }
  out.num_systems = sea.systems.size();
  complete(m0, on_nodes, out);
  return {};
}

}  // namespace quickstrip
