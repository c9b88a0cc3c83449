// Pure loss of stability on a crest that stays with the ship: MSC.1/Circ.1627's speed and waves, and what GM
// is left on the crest of the effective wave. No state. Source: [IMO2020]; constants in zone_parameters.hpp.
#pragma once

#include <cmath>

#include "core/base/angles.hpp"
#include "core/hazard/zone_parameters.hpp"

namespace quickstrip {

/// From following to beam seas, at 0.752 sqrt(L) m/s or more.
inline bool is_pure_loss_speed(double length, double speed, EncounterAngle mu) {
  return std::fabs(mu.radians) <= 0.5 * kPi + zone::kAngleRounding &&
         speed >= zone::kPureLossSpeed * std::sqrt(length);
}

/// GM on the crest [m]; no number: lost.
inline bool is_stability_lost(double gm_on_crest) {
  return !(gm_on_crest >= zone::kLeastGm);
}

}  // namespace quickstrip
