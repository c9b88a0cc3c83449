// A sea of one wave system on the command line: --spectrum, --hs-m, --t1-s, --spreading-deg.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/sea/sea_state.hpp"

namespace quickstrip::hull_tool {

struct SpectrumOptions {
  std::string shape;
  double hs = 0.0;
  double t1 = 0.0;
  double spreading_deg = 0.0;

  [[nodiscard]] bool given() const { return !shape.empty(); }
  /// Waves that come from `from`.
  [[nodiscard]] SeaState sea_from(WaveFrom from) const;
};

/// `required`: all but the spreading must be given; else --spectrum brings the others with it.
void add_spectrum_options(CLI::App& command, SpectrumOptions& options, bool required);

}  // namespace quickstrip::hull_tool
