// Transfer functions of a ship from a CSV file, to compare with: amplitudes only.
//
// '#' begins a comment line; then one header line that names the columns, in any order, others ignored:
//   speed_kn, mu_deg or direction_deg (0 following, 90 from starboard, 180 head), omega or omega_rad_s, and
//   either dof and amplitude, one motion a line (dof: surge, sway, heave, roll, pitch or yaw),
//   or surge_amp ... yaw_amp, an empty field where a motion is not known.
// Amplitudes in m/m and rad/m.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace quickstrip::hull_tool {

inline constexpr std::array<std::string_view, 6> kMotionNames = {"surge", "sway",  "heave",
                                                                 "roll",  "pitch", "yaw"};

struct TransferValue {
  double speed_kn = 0.0;
  double mu_deg = 0.0;
  double omega = 0.0;      // of the wave [rad/s]
  std::size_t motion = 0;  // 0 ... 5
  double amplitude = 0.0;  // m/m, rad/m
};

/// In the order of the file. Throws InputError, naming the line.
std::vector<TransferValue> read_transfer_file(const std::string& path);

}  // namespace quickstrip::hull_tool
