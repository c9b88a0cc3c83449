// One channel in the waves of one relative direction at one speed, integrated over the bands of the sea: the
// step that the sweep of a speed and the response of one cell have in common.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/response/band_weights.hpp"
#include "core/response/channel_energy.hpp"
#include "core/sea/sea_energy.hpp"

namespace quickstrip {

/// What of |H|^2 is integrated: itself, times |omega_e|, omega_e^2 or omega_e^4, or its part below the
/// encounter-frequency floor.
enum class Moment : std::uint8_t { kZeroth, kFirst, kSecond, kFourth, kLowEncounter };

/// `damped`: sway, roll and yaw at another roll damping; may be null. |H|^2 at frequencies and, where the
/// channel feels roll, at the points of the peak; `is_from_port`: of waves from that side.
void list_values(const MetWaves& met, bool is_from_port, const Channel& channel, const LateralMotions* damped,
                 const IncidentWave& wave, ChannelValues& out);

/// What is to be integrated, kLowEncounter apart: `values` or, after another moment, `room`.
const ChannelValues& weigh(const MetWaves& met, Moment moment, const ChannelValues& values,
                           ChannelValues& room);

/// Integral over a band of a response as weigh() or, of kLowEncounter, list_values() leaves it.
double integrate(const MetWaves& met, Moment moment, const EnergyNodes& band, const BandWeights& weights,
                 const ChannelValues& values);

}  // namespace quickstrip
