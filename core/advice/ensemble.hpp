// How sure a verdict is: an ensemble of seas and ships within what is uncertain about the inputs, each swept
// over the whole grid; in how many of them is a limit exceeded?
//
// A member has heights, periods and directions of each wave system, a GM and a roll damping of its own, drawn
// from normal distributions about what the advisor takes for true. Draws are a Latin hypercube: each of the
// 20 quantities takes each sixteenth of its distribution once, in an order of its own (fixed: same bits on
// every run), scaled so that their variance is the one asked for. A member's GM and damping enter by the
// rank-one update of roll (response/damped_motions.hpp); a measured spectrum is stretched and turned as a
// whole. What is counted is limits on motions; zones of the IMO guidance have their own bands of period.
//
// What GM does to the waves' own roll moment is left out: a member feels some three fifths of what its GM
// does (tests/advice). Expected error: with 16 members a share of 0.5 is known within 0.1 (standard deviation
// of the sampling). Cost: a sweep of the grid a member. Members may be spread over cycles: each is valid for
// kMemberLife after it was computed, so a sea that changes slowly is never judged on members older than that.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/response/roll_linearisation.hpp"
#include "core/sea/sea_state.hpp"

namespace quickstrip {

/// Standard deviations.
struct Uncertainty {
  std::array<double, kMaxWaveSystems> height_part{};  // of hs, by wave system
  std::array<double, kMaxWaveSystems> period_part{};  // of the period
  std::array<double, kMaxWaveSystems> direction{};    // rad
  double gm = 0.0;                                    // m
  double roll_damping_part = 0.0;                     // of the damping beyond potential theory
};

// Ours, where an input says nothing. GM from a loading computer against an inclining test; Ikeda's method
// against model tests.
inline constexpr double kTypicalGmStd = 0.05;          // of GM ...
inline constexpr double kLeastGmStd = 0.05;            // m, and at least
inline constexpr double kUncorrectedGmStd = 0.10;      // of GM, free surfaces not known
inline constexpr double kTypicalRollDampingStd = 0.2;  // of the damping

/// Relative standard deviation of the height of all systems together, which are uncertain by themselves.
double height_deviation(const Uncertainty& uncertainty, std::span<const WaveSystem> systems);

/// How a member differs from what is taken for true.
struct EnsembleMember {
  std::array<double, kMaxWaveSystems> height_factor{};
  std::array<double, kMaxWaveSystems> period_factor{};
  std::array<double, kMaxWaveSystems> turned{};  // rad, to starboard
  RollShift roll{};
};

/// Member k of kEnsembleMembers of a ship of this GM [m], > 0. A factor is at least 0.2.
EnsembleMember draw_member(std::size_t k, const Uncertainty& uncertainty, double gm);

/// The sea of a member. A spectrum takes the factors of the first system.
void shift_sea(const EnsembleMember& member, const SeaState& sea, SeaState& out);
void shift_sea(const EnsembleMember& member, const DirectionalSpectrum& sea, DirectionalSpectrum& out);

inline constexpr double kMemberLife = 60.0;  // s

/// A bit a member: a limit is exceeded there. Nothing where a profile has no members.
using ExceededMembers =
    std::array<std::array<std::uint16_t, kMaxHeadings>, kEnsembleMembers == 0 ? 0 : kMaxSpeeds>;
static_assert(kEnsembleMembers <= 16);

struct Ensemble {
  std::uint16_t valid = 0;  // bits of the members that count
  ExceededMembers exceeded{};
  Uncertainty uncertainty{};

  [[nodiscard]] int num_members() const { return std::popcount(valid); }
  /// Members in which a limit is exceeded in cell [v][h] of the grid; -1 without any member.
  [[nodiscard]] int num_exceeded(std::size_t v, std::size_t h) const {
    if constexpr (kEnsembleMembers > 0) {
      return valid == 0 ? -1 : std::popcount(static_cast<std::uint16_t>(exceeded[v][h] & valid));
    }
    return -1;
  }
};

}  // namespace quickstrip
