// The sea on the command line: one wave system from a direction (--spectrum ..., --dir-from-deg), or an hour
// of a sea file (--sea, --at). What grid and simulate have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <string>

#include "core/sea/sea_state.hpp"
#include "sim/hull_tool/spectrum_options.hpp"

namespace quickstrip::hull_tool {

struct SeaOptions {
  SpectrumOptions spectrum;
  double dir_from_deg = 0.0;
  std::string sea_file;
  std::string at;
};

/// Where they can be asked for; --sea excludes --spectrum.
struct SeaOptionHandles {
  CLI::Option* shape = nullptr;
  CLI::Option* dir_from = nullptr;
  CLI::Option* sea = nullptr;
  /// In the callback: throws CLI::RequiredError when there is no sea.
  void require_one() const;
};
SeaOptionHandles add_sea_options(CLI::App& command, SeaOptions& options);

struct ChosenSea {
  bool is_measured = false;
  SeaState systems;              // of --spectrum
  DirectionalSpectrum measured;  // of --sea
  std::int64_t utime_us = 0;     // of the measurement
  double hs = 0.0;               // m
};

/// The sea of --spectrum, or of the file the hour asked for, or the one with the highest sea. Throws
/// InputError.
std::unique_ptr<ChosenSea> choose_sea(const SeaOptions& options);

}  // namespace quickstrip::hull_tool
