// |H|^2 of a channel in the waves of one relative direction at one speed: at the wave frequencies, and at the
// points of the roll peak between them. What the cycle spends its time on: structure of arrays over
// frequency, a few multiply-adds a motion, no branches inside.
//
// Relative direction m = 0 ... kNumDirections - 1 is mu = 2 pi m / kNumDirections; beyond half a turn it is
// the mirror image of the other side of the ship. Relative motion is watched on the centre line, where both
// sides see the same incident wave.
// At the points of the peak, surge, heave and pitch lie on a straight line between the frequencies: they do
// not resound there.
// In single precision, in which the motions are kept: 6e-8 of the largest motion in the form.
// Cost: (motions in the form) x 6 + 3 flops a frequency, for both sides 7 more.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/base/lanes.hpp"
#include "core/response/watch.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

/// mu of direction index m of the full circle, in (-pi, pi]: 2 pi m / kNumDirections.
EncounterAngle relative_direction(std::size_t m);

/// Index into the solved directions for m; the other side of the ship is the mirror image.
std::size_t solved_direction(std::size_t m);
bool is_mirrored(std::size_t m);

/// Moved by sway, roll or yaw, so by the roll peak; for the others the frequencies are enough.
constexpr bool feels_roll(const Channel& channel) {
  return channel.form.has(1) || channel.form.has(3) || channel.form.has(5);
}

/// Moved by surge, heave or pitch.
constexpr bool moves_lengthwise(const Channel& channel) {
  return channel.form.has(0) || channel.form.has(2) || channel.form.has(4);
}

/// |H|^2 the same from both sides of the ship: sway, roll and yaw move it, or the rest, not both.
constexpr bool is_symmetric(const Channel& channel) {
  return !feels_roll(channel) || !(moves_lengthwise(channel) || channel.form.wave != 0.0);
}

using NodeValues = std::array<float, kMaxFrequencies>;
using PointValues = std::array<float, kMaxPeakPoints>;

/// How the waves of one direction are met, by frequency.
struct Encounters {
  std::array<double, kMaxFrequencies> frequency{};  // omega_e, signed [rad/s]
  std::array<double, kMaxPeakPoints> at_points{};   // at the points of the roll peak
  NodeValues squared{};                             // omega_e^2
  NodeValues magnitude{};                           // |omega_e|
  PointValues squared_at_points{};                  // the same
  LaneRange low{};                                  // holds every frequency whose wave is met below the floor
  NodeValues is_low{};                              // 1 below the floor, else 0
};
void list_encounters(const TransferFunctions& transfer, std::size_t speed, std::size_t solved_m,
                     Encounters& out);

/// Whether any wave of any direction is met below the floor, or is one that list_slow_waves() marks.
struct SlowEncounters {
  bool has_low = false;
  bool has_slow = false;
};
SlowEncounters find_slow_encounters(const TransferFunctions& transfer, std::size_t speed);

/// Waves that linear motions say nothing about: they are met below the floor, or more slowly than a third of
/// their own frequency, TE > 3 TW. There the ship runs along with the wave, surges and yaws on it, and what
/// is left of the encounter shows in no variance; MSC.1/Circ.1228's zone of high waves ends there too
/// [IMO2007].
inline constexpr double kSlowEncounter = 1.0 / 3.0;

/// 1 where the wave is slow, else 0, by frequency.
void list_slow_waves(const TransferFunctions& transfer, const Encounters& encounters, NodeValues& out);

/// The incident wave at a position on the centre line, by frequency, times e^{i omega_e t}.
struct alignas(kCacheLine) IncidentWave {
  NodeValues re{};
  NodeValues im{};
};

/// Sway, roll and yaw of one speed and direction at another roll damping (damped_motions.hpp).
struct alignas(kCacheLine) LateralMotions {
  std::array<std::array<float, kMaxFrequencies>, 3> re{};
  std::array<std::array<float, kMaxFrequencies>, 3> im{};
  std::array<std::array<float, kMaxPeakPoints>, 3> point_re{};
  std::array<std::array<float, kMaxPeakPoints>, 3> point_im{};
};

/// Surge, heave and pitch at the points of the roll peak; `place`: of each in its interval, 0 ... 1.
struct alignas(kCacheLine) LongitudinalMotions {
  std::array<PointValues, 3> re{};
  std::array<PointValues, 3> im{};
};
void list_longitudinal(const TransferFunctions& transfer, std::size_t speed, std::size_t solved_m,
                       const std::array<double, kMaxPeakPoints>& place, LongitudinalMotions& out);

/// What some of the motions make of a channel: at the wave frequencies and, where the channel feels roll, at
/// the points of its peak.
struct alignas(kCacheLine) ChannelPart {
  NodeValues re{};
  NodeValues im{};
  PointValues point_re{};
  PointValues point_im{};
};

/// Of one speed and solved direction.
struct MetWaves {
  const TransferFunctions& transfer;
  std::size_t speed;
  std::size_t solved_m;
  const Encounters& encounters;
  const LongitudinalMotions& longitudinal;

  [[nodiscard]] const MotionRow& row() const { return transfer.row[speed][solved_m]; }
  [[nodiscard]] const RollPeak& peak() const { return transfer.peak[speed][solved_m]; }
};

/// The wave at a channel's position, or its complex conjugate.
struct WaveThere {
  const IncidentWave& wave;
  bool is_conjugate = false;
};

/// Surge, heave, pitch and the wave: the same from both sides of the ship. `wave` is read only where the form
/// has a wave, which a channel that feels roll has not.
void longitudinal_part(const MetWaves& met, const Channel& channel, const WaveThere& wave, ChannelPart& out);

/// Sway, roll and yaw: of the other sign from the port side. `damped`: in place of those of the transfer
/// functions; may be null.
void lateral_part(const MetWaves& met, const Channel& channel, const LateralMotions* damped,
                  ChannelPart& out);

/// |H|^2 of a channel, or what its two sides have in common or apart.
struct alignas(kCacheLine) ChannelValues {
  NodeValues nodes{};
  PointValues points{};
  bool has_points = false;
};

/// Of one part alone.
void list_square(const MetWaves& met, const Channel& channel, const ChannelPart& part, ChannelValues& out);

/// Of both parts, a and b: even |a|^2 + |b|^2, odd 2 Re a b*; from starboard |H|^2 is even + odd, from port
/// even - odd.
void list_even_odd(const MetWaves& met, const Channel& channel, const ChannelPart& longitudinal,
                   const ChannelPart& lateral, ChannelValues& even, ChannelValues& odd);

}  // namespace quickstrip
