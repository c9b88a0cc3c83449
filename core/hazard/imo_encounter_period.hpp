// The encounter period as MSC.1/Circ.1228 draws it: TE = 3 TW^2 / (3 TW + V cos alpha), V in knots, alpha = 0
// in a head sea and 90 degrees with the sea from starboard. For drawing the circular's own diagram: 3 stands
// for g / (2 pi kn) = 3.035, 1.2 % of it. Everything else in this room uses g V / omega.
// Source: [IMO2007] 4.2.
#pragma once

#include <cmath>

#include "core/base/angles.hpp"
#include "core/hazard/zone_parameters.hpp"

namespace quickstrip {

/// IMO's wave angle [rad], [0, 2 pi): 0 head, pi/2 from starboard, pi following.
struct ImoAngle {
  double radians = 0.0;
};

inline ImoAngle imo_angle(EncounterAngle mu) {
  return {wrap_two_pi(kPi - mu.radians)};
}

/// Wave period > 0 [s], speed [m/s] -> s; negative when the ship overtakes the waves, infinite in between.
inline double imo_encounter_period(double wave_period, double speed, ImoAngle alpha) {
  const double knots = speed / zone::kKnot;
  return 3.0 * wave_period * wave_period / (3.0 * wave_period + knots * std::cos(alpha.radians));
}

}  // namespace quickstrip
