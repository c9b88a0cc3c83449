// Sway, roll and yaw of one speed in the waves of one direction, at another roll damping or roll stiffness
// than the transfer functions were solved with: at the wave frequencies and at the points of the roll peak.
//
// Exact but for the tabulated admittance (strip/roll_update.hpp) and single precision; of a changed
// stiffness, what the points of the peak lose when it moves off them (tests/response). Cost: some 50 flops a
// frequency or point for the table, 50 more for each addition. Memory: 2.3 kB a direction and addition.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/capacity.hpp"
#include "core/response/channel_energy.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

/// What roll has beyond what the transfer functions were solved with.
struct RollAddition {
  double damping = 0.0;    // b44 [N m s]
  double stiffness = 0.0;  // c44 [N m]
};

/// At one solved direction: out[i] with additions[i], as many as there are. `encounters`: of that speed and
/// direction.
void damp_motions(const TransferFunctions& transfer, std::size_t speed, std::size_t solved_m,
                  const Encounters& encounters, std::span<const RollAddition> additions,
                  std::span<LateralMotions> out);

}  // namespace quickstrip
