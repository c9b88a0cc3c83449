// Surf-riding and broaching-to: too fast with the sea from astern. By length, speed and direction alone
// (MSC.1/Circ.1228 4.2.1); and whether the waves are long and high enough to carry her (MSC.1/Circ.1627
// 4.5.6). No state, a few operations. Sources: [IMO2007], [IMO2020]; constants in zone_parameters.hpp.
#pragma once

#include <cmath>

#include "core/base/angles.hpp"
#include "core/hazard/zone_parameters.hpp"

namespace quickstrip {

/// Of lpp [m], speed [m/s]. 135 < alpha < 225 degrees and V > 1.8 sqrt(L) / cos(180 - alpha) kn: boundaries
/// excluded.
inline bool in_surf_riding_zone(double length, double speed, EncounterAngle mu) {
  return std::fabs(mu.radians) < zone::kSurfRidingSector - zone::kAngleRounding &&
         speed * std::cos(mu.radians) > zone::kSurfRidingSpeed * std::sqrt(length);
}

/// The grey band below it: 1.4 sqrt(L) < V cos(180 - alpha) <= 1.8 sqrt(L).
inline bool in_marginal_band(double length, double speed, EncounterAngle mu) {
  return std::fabs(mu.radians) < zone::kSurfRidingSector - zone::kAngleRounding &&
         speed * std::cos(mu.radians) > zone::kMarginalSpeed * std::sqrt(length) &&
         !in_surf_riding_zone(length, speed, mu);
}

/// Speed of the simplified operational guidance: V >= 0.94 sqrt(L) m/s within 45 degrees of the stern.
inline bool is_surf_riding_speed(double length, double speed, EncounterAngle mu) {
  return std::fabs(mu.radians) <= zone::kSurfRidingSector + zone::kAngleRounding &&
         speed >= zone::kSurfRidingSpeedOf1627 * std::sqrt(length);
}

/// Its waves: longer than 0.8 L, significant height above 0.04 L.
inline bool are_long_and_high(double length, double wave_length, double hs) {
  return wave_length > zone::kLongWave * length && hs > zone::kHighWave * length;
}

}  // namespace quickstrip
