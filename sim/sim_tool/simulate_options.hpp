// Options of quickstrip-sim simulate.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quickstrip/wave_spectrum_t.hpp"
#include "sim/hull_tool/sea_options.hpp"
#include "sim/hull_tool/strip_ship.hpp"
#include "sim/seaway/motion_log.hpp"

namespace quickstrip::sim_tool {

inline constexpr std::int64_t kDefaultStart = 1'577'836'800'000'000;  // 2020-01-01T00:00:00Z

struct SimulateOptions {
  hull_tool::StripOptions strip;
  hull_tool::SeaOptions sea;
  double speed_kn = 0.0;
  std::optional<double> mu_deg;
  std::optional<double> heading_deg;
  double hours = 0.0;
  std::uint64_t seed = 0;
  double runs = 1.0;
  std::vector<double> roll_deg;
  std::vector<double> accelerations;
  std::vector<double> probabilities;
  bool steps_roll = false;
  std::optional<double> roll_linear;
  std::optional<double> roll_quadratic;
  std::string format = "text";
  std::string log;
  seaway::MotionLogOptions log_options{.start_utime = kDefaultStart,
                                       .spectrum_source = wave_spectrum_t::SOURCE_BUOY};
};

/// All of them, with what they need and exclude; `check` is for the callback: throws CLI::ParseError.
struct SimulateHandles {
  hull_tool::SeaOptionHandles sea;
  CLI::Option* mu = nullptr;
  CLI::Option* heading = nullptr;
  void check() const;
};
SimulateHandles add_simulate_options(CLI::App& command, const std::shared_ptr<SimulateOptions>& options);

}  // namespace quickstrip::sim_tool
