// Moments of the channels of a watch on every heading, at one speed: what the cycle does once a speed.
//
// A channel's |H|^2 is integrated over each band of the sea at every relative direction
// (heading_integrals.hpp); then its variance on all headings is a circular convolution with what each wave
// system takes of the band: a product in the Fourier space of direction (heading_convolution.hpp). Nothing is
// folded into encounter frequency. Half the directions do: of a channel that is not the same from both sides,
// what they have in common and what they have apart (even and odd) come from the same motions.
// Where roll damping depends on roll, channels that feel roll are summed at each level of damping
// (strip/roll_update.hpp); the damping of each heading is found from roll's own moments
// (roll_linearisation.hpp), and every other moment is taken at it.
// Work a channel, speed, level and moment: 37 or 74 sums of (frequencies x bands) + 532 x bands + 1,060 x
// systems (of the variance; of other moments once) multiply-adds at 72 directions. It depends on the sea only
// through the number of its bands and systems: a long-crested sea takes as long as one from all round.
// Expected error: that of single precision in |H|^2 (channel_energy.hpp); of the transforms 1e-15 of the
// largest variance on any heading, and what is below 1e-13 of that is zero. Sums run in a fixed order: same
// bits on every run. Memory: the workspace, 1.4 MB: static.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/capacity.hpp"
#include "core/response/heading_convolution.hpp"
#include "core/response/heading_integrals.hpp"
#include "core/response/incident_waves.hpp"
#include "core/response/roll_linearisation.hpp"
#include "core/response/watch.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

/// What is wanted of each channel: nothing; its variance; also the part below the encounter-frequency floor.
/// The second moment comes with every channel that is wanted and needs it (watch.hpp).
enum class Need : std::uint8_t { kNone, kVariance, kVarianceAndLowEncounter };
using Needs = std::array<Need, kMaxChannels>;

/// Of one channel. Indexed by heading 2 pi h / kNumDirections last.
struct ChannelMoments {
  std::array<ByHeading, kMaxWaveSystems> m0_by_system{};
  ByHeading m0{};
  ByHeading m2{};
  ByHeading m0_low_encounter{};
};

/// Roll damping of one speed on every heading.
struct HeadingDamping {
  ByHeading added{};     // b44 [N m s]
  ByHeading residual{};  // roll_linearisation.hpp
};

struct HeadingMoments {
  std::array<ChannelMoments, kMaxChannels> channel{};
  HeadingDamping roll_damping{};
  ByHeading slow_wave_energy{};  // of the waves that list_slow_waves() marks [m2]
};

/// Scratch.
struct SweepWorkspace {
  // Of one speed: channels in the order of their sums, and those sums.
  DirectionWork direction;
  SweepColumns columns;
  HeadingColumns headings;
  SweepSubjects subjects;
  // Where roll damping depends on roll: moments of a channel at each level, and what each counts for on every
  // heading.
  std::array<ChannelMoments, kRollDampingLevels> at_level{};
  std::array<ByHeading, kRollDampingLevels> level_weight{};
};

struct SweepOptions {
  bool counts_slow_waves = true;  // slow_wave_energy too
  bool is_stabilised = false;     // stabilisers work
  RollShift shift{};              // needs kEnsembleMembers > 0, unless it is none
};

/// Fills what is needed; the rest keeps what it was. `waves`: of these transfer functions and this watch.
void list_heading_moments(const TransferFunctions& transfer, std::size_t speed, const Watch& watch,
                          const IncidentWaves& waves, const Needs& needs, const SeaEnergy& sea,
                          const SweepOptions& options, SweepWorkspace& work, HeadingMoments& out);

}  // namespace quickstrip
