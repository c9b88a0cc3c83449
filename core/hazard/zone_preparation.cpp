// What of the zones does not depend on course and speed: the ship's part and the sea's part of zones.hpp.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/check.hpp"
#include "core/hazard/effective_wave.hpp"
#include "core/hazard/zone_parameters.hpp"
#include "core/hazard/zones.hpp"
#include "core/sea/dispersion.hpp"
#include "core/sea/spectrum.hpp"
#include "core/strip/roll_damping.hpp"

namespace quickstrip {
namespace {

using NodeEnergies = std::array<double, kMaxFrequencies>;

/// Energy of a system by frequency, all directions together [m2].
NodeEnergies energies_of(const SeaEnergy& sea, std::size_t s) {
  NodeEnergies out{};
  const SystemEnergy& part = sea.part[s];
  for (std::size_t b = part.first; b < part.first + part.count; ++b) {
    double factor = 0.0;
    for (const double by_direction : part.factor[b]) {
      factor += by_direction;
    }
    const EnergyBand& band = sea.band[b];
    for (std::size_t i = band.first; factor > 0.0 && i <= band.last; ++i) {
      out[i] += factor * band.node[i];
    }
  }
  return out;
}

EffectiveStability effective_stability(const ZoneShip& ship, std::span<const double> omega,
                                       const NodeEnergies& energy, double cosine) {
  double m0 = 0.0;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    if (energy[i] > 0.0) {
      const double x = 0.5 * wave_number(omega[i], ship.gravity) * cosine * ship.lpp;
      m0 += energy[i] * effective_wave_filter(x);
    }
  }
  const GmChange change = gm_change(ship.gm_in_waves, effective_height(m0));
  const double mean = ship.gm + static_cast<double>(change.mean);
  const double half_range = 0.5 * static_cast<double>(change.greatest - change.least);
  EffectiveStability out{.least = static_cast<float>(ship.gm) + change.least};
  // Without stiffness in the mean there is nothing that damping could hold.
  out.variation = mean > 0.0 ? static_cast<float>(half_range / mean) : std::numeric_limits<float>::max();
  out.stiffening = mean > 0.0 ? static_cast<float>(std::sqrt(mean / ship.gm)) : 1.0F;
  return out;
}

/// Tm02 over all of a measured system's energy; the spectrum's own of a system given by height and period,
/// tail to infinity included, for the nodes end before it.
double zero_crossing_frequency(const WaveSystem& system, bool is_measured, std::span<const double> omega,
                               const NodeEnergies& energy) {
  const double peak = kTwoPi / system.period;
  if (!is_measured) {
    const auto ratio = period_over_peak_period(system.shape, system.peakedness, PeriodKind::kZeroCrossing);
    return ratio ? peak / *ratio : peak;
  }
  double m0 = 0.0;
  double m2 = 0.0;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    m0 += energy[i];
    m2 += energy[i] * omega[i] * omega[i];
  }
  return m0 > 0.0 ? std::sqrt(m2 / m0) : peak;
}

/// Tp ... Tm02; a measured system may have them the other way round.
WaveBand band_of(const WaveSystem& system, bool is_measured, std::span<const double> omega,
                 const NodeEnergies& energy) {
  const double peak = kTwoPi / system.period;
  const double crossing = zero_crossing_frequency(system, is_measured, omega, energy);
  return {std::min(peak, crossing), std::max(peak, crossing)};
}

}  // namespace

void list_zone_ship(const Hull& hull, const Loading& loading, const LoadedHull& loaded,
                    std::span<const double> speeds, ZoneShip& out) {
  QS_CHECK(!speeds.empty() && speeds.size() <= kMaxSpeeds);
  out = ZoneShip{.lpp = hull.lpp,
                 .gravity = loaded.gravity,
                 .gm = loaded.hydrostatics.gm,
                 .roll = roll_period_band(hull, loading, loaded),
                 .gm_in_waves = gm_in_waves(hull, loading),
                 .num_speeds = speeds.size()};
  LengthIntegrals potential;
  length_integrals(loaded, loaded.roll_natural_frequency, potential);
  const double own = potential.plain[kB44][0];
  const double critical = 2.0 * loaded.restoring.c44 / loaded.roll_natural_frequency;
  for (std::size_t v = 0; v < speeds.size(); ++v) {
    out.speeds[v] = speeds[v];
    const double damping = own + small_roll_damping(loaded.roll_damping, speeds[v]);
    out.roll_damping_ratio[v] = static_cast<float>(std::max(0.0, damping / critical));
  }
}

void prepare_zones(const ZoneShip& ship, const SeaEnergy& sea, std::span<const double> omega, Zones& out) {
  QS_CHECK(omega.size() == sea.num_frequencies);
  out.num_systems = sea.num_systems;
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    const NodeEnergies energy = energies_of(sea, s);
    const bool is_measured = sea.part[s].count > 1;  // a system by height and period is one band
    ZoneSystem& system = out.system[s];
    system = ZoneSystem{.is_high_enough = sea.system[s].hs >= zone::kLowWave * ship.lpp,
                        .from = sea.system[s].from,
                        .hs = sea.system[s].hs,
                        .waves = band_of(sea.system[s], is_measured, omega, energy)};
    if (!system.is_high_enough || !ship.gm_in_waves.is_known) {
      continue;
    }
    for (std::size_t n = 0; n < ZoneSystem::kNumAngles; ++n) {
      const double cosine = static_cast<double>(n) / static_cast<double>(ZoneSystem::kNumAngles - 1);
      system.stability[n] = effective_stability(ship, omega, energy, cosine);
    }
  }
}

}  // namespace quickstrip
