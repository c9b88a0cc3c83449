#include "core/advice/quality.hpp"

#include <algorithm>
#include <cmath>

namespace quickstrip {
namespace {

constexpr double kDeepDraughts = 3.0;

double energy_mean_peak_period(const SeaEnergy& sea) {
  double energy = 0.0;
  double sum = 0.0;
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    const double share = sea.system[s].hs * sea.system[s].hs;
    energy += share;
    sum += share * sea.system[s].period;
  }
  return energy > 0.0 ? sum / energy : 0.0;
}

}  // namespace

std::uint32_t hull_quality(const LoadedHull& loaded, const Loading& loading) {
  std::uint32_t quality = 0;
  if (loaded.has_replaced_section) {
    quality |= kQualityReplacedSection;
  }
  if (loaded.is_outside_table) {
    quality |= kQualityOutsideHullTable;
  }
  if (loaded.lpp < kLowLengthBreadth * loaded.breadth) {
    quality |= kQualityLowLengthBreadth;
  }
  if (loaded.roll_damping.outside_range != 0) {  // beyond its amplitudes: kQualityExtremeMotion
    quality |= kQualityRollDampingRange;
  }
  if (!loading.free_surface_correction && !loading.gm) {
    quality |= kQualityFreeSurfaceUnknown;
  }
  return quality;
}

std::uint32_t speed_quality(double speed, double lpp, double gravity) {
  return speed > kHighFroude * std::sqrt(gravity * lpp) ? kQualityHighFroude : std::uint32_t{0};
}

std::uint32_t depth_quality(std::optional<double> depth, const SeaEnergy& sea, const Loading& loading) {
  if (!depth) {
    return 0;
  }
  const double period = energy_mean_peak_period(sea);
  const double for_waves = loading.gravity * period * period / (2.0 * kTwoPi);
  const double for_ship = kDeepDraughts * std::max(loading.draught_aft, loading.draught_fwd);
  return *depth >= std::max(for_waves, for_ship) ? std::uint32_t{0}
                                                 : kQualityShallowWater;  // NaN is not deep
}

}  // namespace quickstrip
