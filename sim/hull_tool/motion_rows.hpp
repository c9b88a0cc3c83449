// The waves that `motions` and `parent` are asked for, and their rows: one wave each.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/strip/motion_transfer.hpp"
#include "sim/hull_tool/csv.hpp"

namespace quickstrip::hull_tool {

inline constexpr const char* kMotionHeader =
    "speed_kn,mu_deg,omega_rad_s,omega_e_rad_s,surge_amp,surge_phase_rad,sway_amp,sway_phase_rad,heave_amp,"
    "heave_phase_rad,roll_amp,roll_phase_rad,pitch_amp,pitch_phase_rad,yaw_amp,yaw_phase_rad,"
    "added_resistance_n_m2,quality";

/// A wave as the command line gives it.
struct GivenWave {
  double speed_kn = 0.0;
  double mu_deg = 0.0;
  double omega = 0.0;  // rad/s
};

struct WaveOptions {
  std::vector<double> speeds_kn;
  std::vector<double> mus_deg;
  std::vector<double> omegas;
  std::optional<double> amplitude;  // m
};

/// --speed-kn, --mu-deg, --omega, all required, and --wave-amplitude-m.
void add_wave_options(CLI::App& command, WaveOptions& options);

/// Every wave asked for, frequencies fastest; refuses more than can be printed.
std::vector<GivenWave> given_waves(const WaveOptions& options);

void add_motion_row(const GivenWave& wave, const MotionTransfer& transfer, double added_resistance,
                    std::uint32_t quality, Csv& csv);

}  // namespace quickstrip::hull_tool
