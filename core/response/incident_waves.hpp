// The incident wave where relative motion is watched, from every solved direction: it depends on neither
// speed nor sea, so it is listed once a loading. Memory: 0.4 MB in profile host: in a workspace.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/capacity.hpp"
#include "core/response/channel_energy.hpp"
#include "core/response/watch.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

/// One channel's, by direction of 0 ... 90 degrees: on the centre line the wave of the supplementary angle is
/// the complex conjugate.
using WavesOfQuarter = std::array<IncidentWave, kNumDirections / 4 + 1>;

/// `solved_m`: 0 ... 180 degrees.
WaveThere wave_from(const WavesOfQuarter& waves, std::size_t solved_m);

struct IncidentWaves {
  std::array<WavesOfQuarter, kMaxRelativeChannels> wave{};
  std::array<std::size_t, kMaxChannels> place{};  // in `wave`, by channel; of relative motion only

  [[nodiscard]] const WavesOfQuarter& of(std::size_t channel) const { return wave[place[channel]]; }
};

/// `position`: on the centre line.
void list_incident_wave(const TransferFunctions& transfer, std::size_t solved_m, const Position& position,
                        IncidentWave& out);
/// Of every channel of the watch that has one.
void list_incident_waves(const TransferFunctions& transfer, const Watch& watch, IncidentWaves& out);

}  // namespace quickstrip
