// Moments of every channel at one course and speed, by wave system.
//
// m_n = sum over directions and wave frequencies of |H|^2 |omega_e|^n times the wave energy: never by folding
// the sea into encounter frequency, so a following sea needs no special care. Variances of systems add.
// Between the nodes the moments are interpolated bilinearly: in heading between the directions of the wave
// energy, in speed between the solved speeds. Channels that feel roll are summed at the points of the roll
// peak as well (band_weights.hpp).
// Where roll damping depends on roll, moments are summed at each level of it and blended at the damping of
// this course, at each of the two speeds, as the sweep does it (heading_moments.hpp).
// Cost: 2 speeds x 37 directions, both sides of the ship at once, x channels x frequencies x systems of the
// sea, whose bands are merged first (met_energy.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/response/incident_waves.hpp"
#include "core/response/watch.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

inline constexpr double kNoMoment = -std::numeric_limits<double>::infinity();  // not asked for

/// By channel of a watch.
using ChannelSet = std::array<bool, kMaxChannels>;

/// In the unit of the channel squared, times 1/s for each order. m4 rests on the short waves: of a relative
/// motion, which follows them, it grows with the logarithm of the highest wave frequency.
struct ResponseMoments {
  double m0 = 0.0;
  double m1 = 0.0;
  double m2 = 0.0;
  double m4 = kNoMoment;          // of channels for which it is asked
  double m0_low_encounter = 0.0;  // the part of m0 below the encounter-frequency floor
  std::array<double, kMaxWaveSystems> m0_by_system{};
};

/// Roll damping at a course and speed.
struct RollDampingInUse {
  double added = 0.0;     // b44 [N m s]
  double residual = 0.0;  // of its linearisation (roll_linearisation.hpp); 0 where it does not depend on roll
};

struct MomentOptions {
  const ChannelSet* with_fourth = nullptr;  // of which m4 is wanted; null: all
  bool is_stabilised = false;               // stabilisers work
  const IncidentWaves* waves = nullptr;  // of the watch; null: found at each direction, a fifth of the work
};

/// Returns the roll damping that the moments rest on. out: one per channel of the watch. Errors:
/// kSpeedOutOfGrid, kNotFinite; kTooMany when the sea and the transfer functions have different frequencies
/// or `out` another length than the watch.
Result<RollDampingInUse> response_moments(const TransferFunctions& transfer, const Watch& watch,
                                          const SeaEnergy& sea, Heading heading, double speed,
                                          std::span<ResponseMoments> out, const MomentOptions& options = {});

/// The share of the wave energy itself in waves that list_slow_waves() marks (channel_energy.hpp), in [0, 1].
/// Errors: kSpeedOutOfGrid, kNotFinite.
Result<double> slow_wave_share(const TransferFunctions& transfer, const SeaEnergy& sea, Heading heading,
                               double speed);

/// The solved speeds on either side, and how far a speed lies towards the upper one.
struct SpeedBracket {
  std::size_t lower = 0;
  std::size_t upper = 0;
  double part = 0.0;
};

/// Errors: kSpeedOutOfGrid.
Result<SpeedBracket> bracket_speed(const TransferFunctions& transfer, double speed);

}  // namespace quickstrip
