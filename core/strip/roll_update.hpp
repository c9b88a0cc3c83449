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
#include <complex>
#include <cstddef>

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

/// By |omega_e|: first + n step.
struct RollUpdateTable {
  using Values = std::array<float, kNumRollUpdateNodes>;
  double highest = 0.0;   // |omega_e| that the table goes to [rad/s]
  double first = 0.0;     // rad/s
  double per_step = 0.0;  // s
  double stiffness = 0.0;
  double inertia = 0.0;
  Values impedance_re{};  // of D beyond stiffness - omega_e^2 inertia
  Values impedance_im{};
  Values sway_re{};  // per roll
  Values sway_im{};
  Values yaw_re{};
  Values yaw_im{};
};

struct RollUpdate {
  RollDampingLevels levels;
  RollUpdateTable table;
};

/// `lowest`: the least |omega_e| that will be asked for [rad/s].
RollUpdate roll_update(const LoadedHull& hull, double speed, double lowest);

/// What more damping does to roll, and what sway and yaw change with it.
struct RollChange {
  std::complex<double> impedance;  // D at |omega_e|
  std::complex<double> sway_per_roll;
  std::complex<double> yaw_per_roll;
  bool is_negligible = false;  // |omega_e| beyond the table
};

/// omega_e > 0, at least the lowest of the table [rad/s]. For negative encounter frequencies take the
/// conjugates.
inline RollChange roll_change(const RollUpdateTable& table, double omega_e) {
  if (!(omega_e < table.highest)) {
    return {.impedance = {}, .sway_per_roll = {}, .yaw_per_roll = {}, .is_negligible = true};
  }
  const double place = std::max(0.0, (omega_e - table.first) * table.per_step);
  const std::size_t n = std::min(static_cast<std::size_t>(place), kNumRollUpdateNodes - 2);
  const double t = place - static_cast<double>(n);
  const auto between = [n, t](const RollUpdateTable::Values& values) {
    return (1.0 - t) * static_cast<double>(values[n]) + t * static_cast<double>(values[n + 1]);
  };
  return {.impedance = {table.stiffness - omega_e * omega_e * table.inertia + between(table.impedance_re),
                        between(table.impedance_im)},
          .sway_per_roll = {between(table.sway_re), between(table.sway_im)},
          .yaw_per_roll = {between(table.yaw_re), between(table.yaw_im)}};
}

}  // namespace quickstrip
