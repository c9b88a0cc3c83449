// Synchronous roll, MSC.1/Circ.1228 4.2.3.1: the encounter period is nearly the natural roll period. For any
// period of the band that is known, and any encounter frequency of the band that is met. No state. Source:
// [IMO2007]; "nearly" is ours (zone_parameters.hpp).
#pragma once

#include "core/base/constants.hpp"
#include "core/hazard/encounter_band.hpp"
#include "core/hazard/zone_parameters.hpp"

namespace quickstrip {

/// Roll periods shortest ... longest [s].
struct RollPeriods {
  double shortest = 0.0;
  double longest = 0.0;
};

/// TE / TR in from ... to, for some encounter frequency and some roll period.
inline bool is_tuned(const EncounterBand& met, const RollPeriods& roll, double from, double to) {
  return met.meets(kTwoPi / (to * roll.longest), kTwoPi / (from * roll.shortest));
}

inline bool in_synchronous_zone(const EncounterBand& met, const RollPeriods& roll) {
  return is_tuned(met, roll, zone::kSynchronousFrom, zone::kSynchronousTo);
}

}  // namespace quickstrip
