// One channel in the waves of one relative direction at one speed, integrated over the bands of the sea: the
// step that the sweep of a speed and the response of one cell have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/response/band_weights.hpp"
#include "core/response/channel_energy.hpp"
#include "core/sea/sea_energy.hpp"

namespace quickstrip {

/// What of |H|^2 is integrated: itself, times |omega_e|, omega_e^2 or omega_e^4, or its part below the
/// encounter-frequency floor.
enum class Moment : std::uint8_t { kZeroth, kFirst, kSecond, kFourth, kLowEncounter };

/// What a channel is composed in; one for many channels, for setting it to nothing each time would take as
/// long.
struct ChannelRoom {
  ChannelPart longitudinal;
  ChannelPart lateral;
  ChannelValues even;  // |H|^2: what its two sides have in common
  ChannelValues odd;   // and apart; of a channel that is symmetric, and at the ends, nothing
  ChannelValues weighed;
};

/// Whether `odd` is anything: waves from right ahead or astern have one side.
bool has_sides(const MetWaves& met, const Channel& channel);

/// The part of a channel that roll damping does not touch.
void begin_channel(const MetWaves& met, const Channel& channel, const WaveThere& wave, ChannelRoom& room);

/// Into `even` and, where it has sides, `odd`: at frequencies and, where the channel feels roll, at the
/// points of the peak. After begin_channel(), once for each roll damping. `damped`: sway, roll and yaw at
/// another damping than the transfer functions'; may be null.
void list_values(const MetWaves& met, const Channel& channel, const LateralMotions* damped,
                 ChannelRoom& room);

/// out[b]: integral over bands[b] of a moment of |H|^2, as list_values() left it in `even` or `odd` of
/// `room`.
void integrate_moment(const MetWaves& met, Moment moment, std::span<const BandWeights> bands,
                      const ChannelValues& values, ChannelRoom& room, std::span<double> out);

}  // namespace quickstrip
