// The cycle: the verdict on every speed and heading of the grid.
//
// Variance of a cell = sum over wave directions and wave frequencies of |H|^2 times the wave energy, all
// systems together; m2 with omega_e^2, for relative motion only. The sea is never folded into encounter
// frequency. For one speed at a time the energies |H|^2 of the channels that criteria and columns need are
// laid out by relative direction in the workspace and then applied to every heading:
// wave direction = heading + pi - mu. Sums run in double, in a fixed order (eight partial sums): same bits
// on every run.
//
// Cost: speeds x headings x directions with energy x 48 frequencies x rows multiply-adds; rows = needed
// channels, those with m2 and, for the governing system, one a system. S-175, default criteria, 25 speeds x
// 72 headings, two systems with energy from all 72 directions: 82 ms of processor time on one x86-64 core
// with SSE2, the response of the present state included (bench_advisor); 63 ms of it without the points of
// the roll peak, which rows that feel roll sum beside the frequencies (response/peak_terms.hpp).
//
// Memory: the workspace, 3.8 MB; static.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "core/advice/verdict.hpp"
#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/base/static_vector.hpp"
#include "core/response/peak_terms.hpp"
#include "core/response/watch.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

/// What the verdicts rest on; references live as long as the call.
struct GridInputs {
  const TransferFunctions& transfer;
  const Watch& watch;
  const Criteria& criteria;
  const CriteriaChannels& channels;
  const SeaEnergy& sea;
  std::size_t num_headings = kMaxHeadings;  // divides kNumDirections
  double lpp = 0.0;                         // m, for the Froude number
  double min_steerage_speed = 0.0;          // m/s
  std::uint32_t quality = 0;                // bits of the hull and its loading
  bool suppresses_low_encounter = false;    // LowEncounterRule::kPaper: loads forced to zero there
};

inline constexpr std::size_t kNoPeak = kMaxChannels;

/// One energy per relative direction and frequency: |H|^2 of a channel, or |H|^2 omega_e^2.
struct EnergyRow {
  std::size_t channel = 0;
  bool is_velocity = false;
  std::size_t peak = kNoPeak;  // its place among the rows that feel the roll peak
};
// Roll, sway, yaw and the accelerations: relative motion is watched on the centre line.
inline constexpr std::size_t kMaxPeakRows = 3 + 3 * kMaxPoints;
inline constexpr std::size_t kMaxEnergyRows = kMaxChannels + kMaxSlammingStations + kMaxFreeboardPoints;

/// Scratch of sweep_grid; its contents mean nothing between calls. 3.8 MB: static.
struct GridWorkspace {
  using ByFrequency = std::array<double, kMaxFrequencies>;
  using ByDirection = std::array<ByFrequency, kNumDirections>;
  StaticVector<EnergyRow, kMaxEnergyRows> rows;
  std::array<ByDirection, kMaxEnergyRows> energy{};  // of one speed, by relative direction
  std::array<std::array<PeakTerms, kNumDirections>, kMaxPeakRows> peak{};
  std::array<const RollPeak*, kNumDirections> peak_of{};  // of this speed, by relative direction
  ByDirection low_encounter{};                            // 1 below the encounter-frequency floor, else 0
  std::array<bool, kNumDirections> has_low_encounter{};   // by relative direction
  StaticVector<std::size_t, kNumDirections> directions;   // compass directions with wave energy
};

/// Speeds of the grid are those of the transfer functions. Errors: kEmptySpectrum (no energy anywhere),
/// kOutOfRange (num_headings), kTooMany (sea and transfer functions have different frequencies).
Status sweep_grid(const GridInputs& inputs, GridWorkspace& workspace, Grid& out);

/// What is known of a cell before its moments are. speed within the solved speeds.
CellCircumstances circumstances(const GridInputs& inputs, Heading heading, double speed);

}  // namespace quickstrip
