// A band of wave frequencies, and the band of encounter frequencies that it is met in. Exact, deep water;
// no state.
//
// omega_e = omega - omega^2 V cos(mu) / g is a parabola: |omega_e| over a band has its extremes at the ends,
// at the top omega = g / (2 V cos mu), and is zero where the parabola crosses zero.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/constants.hpp"

namespace quickstrip {

/// Wave frequencies [rad/s], 0 < from <= to.
struct WaveBand {
  double from = 0.0;
  double to = 0.0;
  [[nodiscard]] bool is_empty() const { return !(from <= to); }
};

/// |omega_e| [rad/s], 0 <= low <= high.
struct EncounterBand {
  double low = 0.0;
  double high = 0.0;
  [[nodiscard]] bool meets(double from, double to) const { return low <= to && high >= from; }
};

/// `along`: V cos(mu), the ship's speed along the waves [m/s].
inline EncounterBand encounter_band(const WaveBand& waves, double along, double gravity) {
  const auto met = [&](double omega) { return omega - omega * omega * along / gravity; };
  const double first = met(waves.from);
  const double last = met(waves.to);
  EncounterBand out{.low = std::min(std::fabs(first), std::fabs(last)),
                    .high = std::max(std::fabs(first), std::fabs(last))};
  if ((first < 0.0) != (last < 0.0)) {
    out.low = 0.0;
  }
  const double top = along > 0.0 ? 0.5 * gravity / along : 0.0;
  if (top > waves.from && top < waves.to) {
    out.high = std::max(out.high, met(top));
  }
  return out;
}

}  // namespace quickstrip
