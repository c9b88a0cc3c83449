// What every band of the sea makes of the channels of a watch, by relative direction, at one speed: the first
// of the two steps of heading_moments.hpp. One direction after the other and every channel at each, so that
// what a direction's sums rest on, some 10 kB, stays in the processor's nearest memory.
//
// Integrals are kept as columns: functions of direction, side by side in blocks of four as the transforms
// take them (base/direction_transform.hpp). A channel takes a column a level of roll damping, moment and
// band, twice where its two sides differ: even columns from the front, odd ones from the back. Channels that
// find no room wait for the next round.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/capacity.hpp"
#include "core/base/direction_transform.hpp"
#include "core/base/static_vector.hpp"
#include "core/response/band_weights.hpp"
#include "core/response/damped_motions.hpp"
#include "core/response/direction_response.hpp"
#include "core/response/incident_waves.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

/// A channel, or the slow waves themselves (null), and what is wanted of it.
struct SweepSubject {
  const Channel* channel = nullptr;
  std::size_t place = 0;                  // of the channel in the watch
  const WavesOfQuarter* waves = nullptr;  // of relative motion only
  std::size_t num_levels = 1;             // of roll damping, 1 ... kRollDampingLevels
  StaticVector<Moment, 3> moments{};
  std::size_t first_even = 0;  // of its columns
  std::size_t first_odd = 0;

  [[nodiscard]] bool has_sides() const { return channel != nullptr && !is_symmetric(*channel); }
  /// The columns of a level and moment are as many as the bands, from here.
  [[nodiscard]] std::size_t offset(std::size_t level, std::size_t moment, std::size_t num_bands) const {
    return (level * moments.size() + moment) * num_bands;
  }
  [[nodiscard]] std::size_t num_columns(std::size_t num_bands) const {
    return num_levels * moments.size() * num_bands;
  }
};
using SweepSubjects = StaticVector<SweepSubject, kMaxChannels + 1>;

inline constexpr std::size_t kSweepBlocks = kSweepColumns / kTransformBlock;
using ColumnBlock = HalfCircle<kTransformBlock>;

constexpr std::size_t blocks_of(std::size_t num_columns) {
  return (num_columns + kTransformBlock - 1) / kTransformBlock;
}

/// Even columns in blocks 0 ... num_even - 1, odd ones in the last num_odd blocks.
struct SweepColumns {
  std::array<ColumnBlock, kSweepBlocks> block{};
  std::size_t num_even = 0;
  std::size_t num_odd = 0;

  [[nodiscard]] std::size_t first_odd() const { return kSweepBlocks - num_odd; }
};

/// One speed's sweep of directions; everything lives as long as the call.
struct SpeedSweep {
  const TransferFunctions& transfer;
  std::size_t speed;
  const SeaEnergy& sea;
  std::span<const RollAddition> additions{};  // dampings at which lateral motions are found anew
  std::size_t first_damped = 1;               // the level of additions[0]
};

/// What one direction's sums rest on.
struct DirectionWork {
  Encounters encounters;
  LongitudinalMotions longitudinal;
  PeakShapes shapes;
  std::array<BandWeights, kMaxEnergyBands> weights{};
  std::array<LateralMotions, kMaxDampedLevels> damped{};
};

/// Gives columns to subjects first ... end - 1, as many as there is room for, at least one; returns end.
std::size_t take_columns(std::size_t num_bands, std::size_t first, SweepSubjects& subjects,
                         SweepColumns& columns);

/// Fills the columns of subjects first ... end - 1.
void list_integrals(const SpeedSweep& sweep, std::span<const SweepSubject> subjects, DirectionWork& work,
                    SweepColumns& columns);

}  // namespace quickstrip
