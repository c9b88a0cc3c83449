// A hull loaded for strip theory on the command line: what hydrodynamics, motions and responses begin with.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/strip/loaded_hull.hpp"
#include "msgs/cli/method_options.hpp"
#include "sim/hull_tool/floating_hull.hpp"
#include "sim/hull_tool/loaded_table.hpp"

namespace quickstrip::hull_tool {

struct StripOptions {
  std::string file;
  LoadingOptions loading;
  MethodOptions method;
  std::optional<double> roll_damping_ratio;
};

struct StripShip {
  std::unique_ptr<FloatingHull> floating;
  std::unique_ptr<LoadedTable> table;  // that `loaded` looks at; null: Lewis forms
  std::unique_ptr<LoadedHull> loaded;
  std::uint32_t quality = 0;  // of the hull and its loading
};

/// HULL, loading, METHOD (--table among it) and --roll-damping-ratio.
void add_strip_options(CLI::App& command, StripOptions& options);

/// Throws InputError. Draughts that the table does not cover: said on standard error, Lewis forms stand in.
StripShip load_strip_ship(const StripOptions& options);

}  // namespace quickstrip::hull_tool
