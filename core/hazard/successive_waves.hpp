// Successive high-wave attack, MSC.1/Circ.1228 4.2.2: the ship runs with a group of high waves. The zone
// follows from sector, length, height and encounter period; the circular asks for "signs of dangerous
// behaviour" besides, and that is what measured motion tells. No state. Source: [IMO2007]; constants in
// zone_parameters.hpp.
#pragma once

#include <optional>

#include "core/base/angles.hpp"
#include "core/hazard/encounter_band.hpp"

namespace quickstrip {

/// What was measured lately, RMS and zero-crossing periods.
struct MeasuredSigns {
  std::optional<double> roll_rms{};      // rad
  std::optional<double> roll_period{};   // s
  std::optional<double> pitch_rms{};     // rad
  std::optional<double> pitch_period{};  // s
};

/// Waves within 45 degrees of the stern, higher than 0.04 L, and any frequency of the band whose waves are
/// longer than 0.8 L and are met with 1.8 <= TE/TW <= 3.0. TE/TW = 1 / (1 - omega V cos(mu) / g).
bool in_successive_wave_zone(const WaveBand& waves, double hs, double length, double speed, EncounterAngle mu,
                             double gravity);

/// Roll or pitch is large and slow: at the encounter period of these waves.
bool shows_successive_waves(const MeasuredSigns& measured, const EncounterBand& met);

}  // namespace quickstrip
