// The six complex motion amplitudes per metre of wave amplitude: what strip theory hands to every response.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstdint>

namespace quickstrip {

/// At G, in m/m and rad/m, times e^{i omega_e t}; index 0 ... 5: surge, sway, heave, roll, pitch, yaw
/// (NOTATION.md).
struct MotionTransfer {
  std::array<std::complex<double>, 6> motion{};
  double encounter_frequency = 0.0;  // signed, true (not floored) [rad/s]
  bool low_encounter = false;        // |omega_e| below the floor of formulas §6
};

/// All six motions.
inline bool is_finite(const MotionTransfer& transfer) {
  for (const std::complex<double>& motion : transfer.motion) {
    if (!std::isfinite(motion.real()) || !std::isfinite(motion.imag())) {
      return false;
    }
  }
  return true;
}

/// How a wave is met.
struct Encounter {
  double frequency = 0.0;  // omega_e: signed, true (not floored) [rad/s]
  bool is_low = false;     // |omega_e| below the floor
};

}  // namespace quickstrip
