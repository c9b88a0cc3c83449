// Motion transfer functions of the loaded hull at every speed, relative direction and wave frequency of the
// grid. Filled when the loading changes, read by every cycle. The port side is the mirror of the starboard
// side: sway, roll and yaw change sign with mu, surge, heave and pitch do not.
#pragma once

#include <array>
#include <complex>
#include <cstddef>

#include "core/base/capacity.hpp"
#include "core/strip/motion_transfer.hpp"

namespace quickstrip {

/// 4.3 MB at full capacity: static. solved[v][m][f]: mu = pi m / (kNumSolvedDirections - 1), m = 0 following.
struct TransferFunctions {
  std::size_t num_speeds = 0;
  std::size_t num_frequencies = 0;
  std::array<double, kMaxSpeeds> speeds{};      // m/s
  std::array<double, kMaxFrequencies> omega{};  // wave frequency, increasing [rad/s]
  std::array<double, kMaxFrequencies> wave_number{};
  std::array<std::array<std::array<MotionTransfer, kMaxFrequencies>, kNumSolvedDirections>, kMaxSpeeds>
      solved{};
};

}  // namespace quickstrip
