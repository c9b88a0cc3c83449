// Roll in a seaway damps itself: eddies and bilge keels take more, the more she rolls. The linear damping
// that takes as much energy as the nonlinear one from *this* roll, in *this* sea, on this course at this
// speed.
//
// Stochastic linearisation of a Gaussian roll [ITTC2011]: quadratic damping b2 counts as sqrt(8/pi)
// sigma_phidot b2; what the components take in the mean of such a roll, at its own RMS and its own frequency
// omega = sigma_phidot / sigma_phi, is strip/roll_damping.hpp's. Damping and roll answer each other:
// variances are known at a few dampings (strip/roll_update.hpp), between them they go with
// 1 / (b + own) as the variance of a resonant roll does; then ln b is found by secants, at most kMostSteps,
// in a sweep from where that of the heading beside was found.
// The equation falls with ln b, so it has one root. Expected error of the interpolation:
// tests/response. Cost: some 0.1 us a step, four or five steps, from nearby two or three; no state.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/capacity.hpp"
#include "core/strip/roll_damping.hpp"
#include "core/strip/roll_update.hpp"

namespace quickstrip {

using ByLevel = std::array<double, kRollDampingLevels>;

/// Of the equation |ln(damping of the roll / damping)|: what is left above it is "not converged".
inline constexpr double kRollResidualLimit = 1e-3;

/// Variances of roll and of its velocity at the dampings of RollDampingLevels.
struct RollVariances {
  ByLevel roll{};      // rad2
  ByLevel velocity{};  // rad2/s2
};

struct LinearisedRoll {
  double damping = 0.0;   // added b44 [N m s]
  double residual = 0.0;  // |damping that this roll calls for / damping - 1|
  double slope = 0.0;     // of ln(damping called for) - ln(damping), where it was found
  ByLevel weight{};       // of a variance at each level, their sum is one
};

/// How another ship of the same lines differs in roll: one whose GM or damping is not what it was taken for.
struct RollShift {
  double stiffness_part = 0.0;  // of c44, that there is more of it
  double damping_factor = 1.0;  // on every damping beyond potential theory but the stabilisers'
  [[nodiscard]] bool is_none() const { return stiffness_part == 0.0 && damping_factor == 1.0; }
};

/// Weights for an added damping >= 0.
ByLevel level_weights(const RollDampingLevels& levels, double damping);

/// What roll is damped by besides the ship's motion through the water itself.
struct RollDampers {
  const RollDampingModel& model;
  const RollDampingLevels& levels;
  double speed = 0.0;  // m/s
  bool is_stabilised = false;
  double factor = 1.0;  // RollShift::damping_factor
};

/// With one level that level times the factor, no residual; without roll the first, and what stabilisers add.
/// `near`: what was found of a roll much like this one, to begin with; may be null.
LinearisedRoll linearise_roll(const RollDampers& dampers, const RollVariances& at,
                              const LinearisedRoll* near = nullptr);

}  // namespace quickstrip
