// The six complex motion amplitudes per metre of wave amplitude: what strip theory hands to every response.
#pragma once

#include <array>
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

/// How a wave is met.
struct Encounter {
  double frequency = 0.0;  // omega_e: signed, true (not floored) [rad/s]
  bool is_low = false;     // |omega_e| below the floor
};

}  // namespace quickstrip
