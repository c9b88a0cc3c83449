// Stochastic linearisation of the roll damping law in the very sea that is simulated:
//   b = b1 + sqrt(8/pi) sigma_phidot b2,
// sigma_phidot that of the linear ship with damping b (the error of the linear moment is least in the mean
// square when roll velocity is Gaussian). Roll at another damping is a rank-one update,
// phi / (1 + i omega (b - b0) G44). Fixed point by bisection: sigma falls with b, so there is one.
// Cost: a pass over the bins for each of 60 halvings. For simulations with a roll law.
#pragma once

#include "core/strip/roll_damping.hpp"
#include "sim/seaway/simulation.hpp"

namespace quickstrip::seaway {

struct EquivalentRoll {
  double damping = 0.0;   // b, beyond potential flow [N m s]
  double roll_rms = 0.0;  // rad
  double rate_rms = 0.0;  // rad/s
};

/// Exactly this law as a model that the advisor takes and linearises by itself.
RollDampingModel law_model(const RollDampingLaw& law, double natural_frequency);

EquivalentRoll equivalent_roll(const Simulation& simulation);

/// b1 and b2 that fit the hull's own damping (its components have more terms) at the frequency of the roll in
/// this sea, over amplitudes up to three times its RMS, and the roll that is linearised with them: found
/// together in a few rounds. Sets the law of `simulation`.
EquivalentRoll fit_roll_law(const RollDampingModel& model, double speed, Simulation& simulation);

}  // namespace quickstrip::seaway
