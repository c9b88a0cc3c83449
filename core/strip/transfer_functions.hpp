// Motion transfer functions of the loaded hull at every speed, relative direction and wave frequency of the
// grid. Filled when the loading changes, read by every cycle. The port side is the mirror of the starboard
// side: sway, roll and yaw change sign with mu, surge, heave and pitch do not.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>

#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/motion_transfer.hpp"

namespace quickstrip {

/// 5 MB at full capacity: static. solved[v][m][f]: mu = pi m / (kNumSolvedDirections - 1), m = 0 following.
struct TransferFunctions {
  std::size_t num_speeds = 0;
  std::size_t num_frequencies = 0;
  std::array<double, kMaxSpeeds> speeds{};      // m/s
  std::array<double, kMaxFrequencies> omega{};  // wave frequency, increasing [rad/s]
  std::array<double, kMaxFrequencies> wave_number{};
  std::array<std::array<std::array<MotionTransfer, kMaxFrequencies>, kNumSolvedDirections>, kMaxSpeeds>
      solved{};
};

/// Fills omega and wave_number: kMaxFrequencies geometric nodes whose range follows the hull's size.
void choose_frequencies(const LoadedHull& hull, TransferFunctions& out);

/// Solves the whole grid: speeds [m/s] >= 0, at most kMaxSpeeds. Errors: kTooMany, kSingular. Cost: 44,400
/// solutions of 24 sections at full capacity, see the benchmark.
Status solve_transfer_functions(const LoadedHull& hull, std::span<const double> speeds,
                                TransferFunctions& out);

}  // namespace quickstrip
