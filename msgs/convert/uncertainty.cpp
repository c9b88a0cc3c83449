#include "msgs/convert/uncertainty.hpp"

#include <algorithm>

#include "core/base/angles.hpp"
#include "core/sea/moments.hpp"
#include "msgs/convert/field_checks.hpp"

namespace quickstrip {
namespace {

struct Typical {
  double height_part;
  double period_part;
  double direction_deg;
};

// The kinds of source are the same in both messages.
static_assert(sea_state_t::SOURCE_VISUAL == wave_spectrum_t::SOURCE_VISUAL);

Typical typical_of(std::int8_t source_kind) {
  switch (source_kind) {
    case sea_state_t::SOURCE_BUOY:
      return {0.08, 0.05, 8.0};
    case sea_state_t::SOURCE_RADAR:
      return {0.12, 0.06, 10.0};
    case sea_state_t::SOURCE_VISUAL:
    case sea_state_t::SOURCE_MANUAL:
      return {0.20, 0.15, 15.0};
    default:
      return {0.15, 0.10, 15.0};
  }
}

void assume(const Typical& typical, StatedUncertainty& out) {
  out.of.height_part.fill(typical.height_part);
  out.of.period_part.fill(typical.period_part);
  out.of.direction.fill(radians(typical.direction_deg));
  out.assumed |= kAssumedHeightStd | kAssumedPeriodStd | kAssumedDirectionStd;
}

double spectrum_height(const wave_spectrum_t& sea) {
  double m0 = 0.0;
  const double step_deg = 360.0 / sea.num_directions;
  for (int f = 0; f < sea.num_frequencies; ++f) {
    const int below = std::max(0, f - 1);
    const int above = std::min<int>(sea.num_frequencies - 1, f + 1);
    double row = 0.0;
    for (int d = 0; d < sea.num_directions; ++d) {
      row += static_cast<double>(sea.density_m2_hz_deg[f][d]);
    }
    m0 += 0.5 * (sea.frequency_hz[above] - sea.frequency_hz[below]) * row * step_deg;
  }
  return significant_wave_height(m0);
}

}  // namespace

StatedUncertainty uncertainty_of(const sea_state_t& sea) {
  StatedUncertainty out;
  assume(typical_of(sea.source_kind), out);
  if (!has(sea.valid, sea_state_t::VALID_STD)) {
    return out;
  }
  out.assumed = 0;
  const auto count = std::min<std::size_t>(static_cast<std::size_t>(sea.num_systems), kMaxWaveSystems);
  for (std::size_t s = 0; s < count; ++s) {
    out.of.height_part[s] = sea.hs_std_m[s] / sea.hs_m[s];
    out.of.period_part[s] = sea.period_std_s[s] / sea.period_s[s];
    out.of.direction[s] = radians(sea.dir_std_deg[s]);
  }
  return out;
}

StatedUncertainty uncertainty_of(const wave_spectrum_t& sea) {
  StatedUncertainty out;
  assume(typical_of(sea.source_kind), out);
  const double hs = has(sea.valid, wave_spectrum_t::VALID_STD) ? spectrum_height(sea) : 0.0;
  if (hs > 0.0) {
    out.of.height_part.fill(sea.hs_std_m / hs);
    out.assumed &= ~static_cast<std::uint32_t>(kAssumedHeightStd);
  }
  return out;
}

void add_ship_uncertainty(const Loading& loading, double gm, StatedUncertainty& out) {
  const bool has_gm = loading.gm.has_value() || loading.free_surface_correction.has_value();
  out.of.gm = std::max(kLeastGmStd, (has_gm ? kTypicalGmStd : kUncorrectedGmStd) * gm);
  out.of.roll_damping_part = kTypicalRollDampingStd;
  out.assumed |= kAssumedGmStd | kAssumedRollDampingStd;
}

}  // namespace quickstrip
