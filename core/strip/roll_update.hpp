// Motions at other roll dampings than the one they were solved with, at one speed.
//
// Damping enters one element of the lateral matrix, so motions at another are a rank-one update of those in
// hand (roll_admittance.hpp). The admittance depends on omega_e and the speed alone and is smooth, but for
// the ship's own inertia and stiffness, which are taken out before it is tabulated: straight lines between
// kNumRollUpdateNodes up to 6 times the natural frequency (parabolas give the same to four digits). Above, b
// omega_e is below 10 % of the inertia even at 0.3 of critical, in quadrature: less than 0.5 % of a motion,
// left out.
// Levels: dampings at which the cycle sums variances, from that of a ship that hardly rolls to that of one
// which rolls far beyond linear theory; between them response/roll_linearisation.hpp interpolates.
// Expected error of an update: 1e-3 of roll at resonance (tests/strip). Memory: 3 kB a speed.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/capacity.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

/// Added dampings b44 [N m s], increasing; the motions are solved with the first.
struct RollDampingLevels {
  std::size_t count = 1;  // 1: there is one damping, whatever the roll
  std::array<double, kRollDampingLevels> added{};
  double stabiliser = 0.0;  // b44 more while stabilisers work [N m s]
  double own = 0.0;         // b44 of potential theory at roll resonance, sway and yaw eliminated [N m s]
};

/// What the ship answers to a roll moment: what belongs to one frequency lies together.
enum RollAnswer : std::uint8_t {
  kImpedanceRe,  // of D beyond stiffness - omega_e^2 inertia
  kImpedanceIm,
  kSwayRe,  // per roll
  kSwayIm,
  kYawRe,
  kYawIm,
  kNumRollAnswers
};
using RollAnswers = std::array<float, kNumRollAnswers>;

/// By |omega_e|: first + n step.
struct RollUpdateTable {
  double highest = 0.0;   // |omega_e| that the table goes to [rad/s]
  double first = 0.0;     // rad/s
  double per_step = 0.0;  // s
  double stiffness = 0.0;
  double inertia = 0.0;
  std::array<RollAnswers, kNumRollUpdateNodes> node{};
};

struct RollUpdate {
  RollDampingLevels levels;
  RollUpdateTable table;
};

/// `lowest`: the least |omega_e| that will be asked for [rad/s].
RollUpdate roll_update(const LoadedHull& hull, double speed, double lowest);

/// Beyond the table more damping does nothing worth counting.
inline bool is_tabulated(const RollUpdateTable& table, double omega_e) {
  return omega_e < table.highest;
}

/// The ship's own stiffness and inertia included: kImpedanceRe is Re D. omega_e > 0, at least the lowest of
/// the table and within it [rad/s]. For negative encounter frequencies take the conjugates.
inline RollAnswers roll_answers(const RollUpdateTable& table, double omega_e) {
  const double place = std::max(0.0, (omega_e - table.first) * table.per_step);
  // As an int: a conversion to an unsigned 64-bit number is several instructions.
  const auto whole = static_cast<int>(std::min(place, static_cast<double>(kNumRollUpdateNodes - 2)));
  const auto n = static_cast<std::size_t>(whole);
  const auto t = static_cast<float>(place - static_cast<double>(whole));
  RollAnswers out;
  for (std::size_t i = 0; i < kNumRollAnswers; ++i) {
    out[i] = table.node[n][i] + t * (table.node[n + 1][i] - table.node[n][i]);
  }
  out[kImpedanceRe] += static_cast<float>(table.stiffness - omega_e * omega_e * table.inertia);
  return out;
}

}  // namespace quickstrip
