// Sway, roll and yaw of one speed in the waves of one direction, at another roll damping than the one that
// the transfer functions were solved with: at the wave frequencies and at the points of the roll peak.
//
// Exact but for the tabulated admittance (strip/roll_update.hpp) and single precision. Cost: some 50 flops a
// frequency or point for the table, 40 more for each damping. Memory: 2.3 kB a direction and damping.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/capacity.hpp"
#include "core/response/channel_energy.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

/// The dampings of a speed beyond the first, at one solved direction: out[l] for level l + 1. Not for a
/// speed of one level. `encounters`: of that speed and direction.
void damp_motions(const TransferFunctions& transfer, std::size_t speed, std::size_t solved_m,
                  const Encounters& encounters, std::span<LateralMotions, kRollDampingLevels - 1> out);

}  // namespace quickstrip
