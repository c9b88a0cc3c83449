#include "sim/hull_tool/floating_hull.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/files/hull_file.hpp"

namespace quickstrip::hull_tool {
namespace {

Loading loading_of(const FloatingHull& ship, const LoadingOptions& options) {
  Loading loading = ship.hull.loading;
  loading.draught_aft = options.draught_aft.value_or(loading.draught_aft);
  loading.draught_fwd = options.draught_fwd.value_or(loading.draught_fwd);
  loading.kg = options.kg.value_or(loading.kg);
  if (options.any() && loading.gm) {
    fmt::print(stderr, "note: {}: loading.gm_m = {:g} belongs to the file's loading; left out\n", ship.file,
               *loading.gm);
    loading.gm.reset();
  }
  return loading;
}

// Cuts and floats the hull that was read.
void settle(FloatingHull& ship, const LoadingOptions& options) {
  ship.loading = loading_of(ship, options);
  if (const Status status = immerse(ship.hull, ship.loading, ship.sections); !status) {
    throw InputError{explain(status.error(), ship, options)};
  }
  const auto result = hydrostatics(ship.hull, ship.loading, ship.sections);
  if (!result) {
    throw InputError{explain(result.error(), ship, options)};
  }
  ship.hydrostatics = *result;
}

}  // namespace

void add_hull_argument(CLI::App& command, std::string& file) {
  command.add_option("HULL", file, "hull file (*.hull.toml)")->required()->type_name("");
}

void add_loading_options(CLI::App& command, LoadingOptions& options) {
  add_number(command, "--draught-aft-m", options.draught_aft, {0.001, 100.0},
             "draught at the aft perpendicular above base [m]; default: the file's");
  add_number(command, "--draught-fwd-m", options.draught_fwd, {0.001, 100.0},
             "draught at the forward perpendicular above base [m]; default: the file's");
  add_number(command, "--kg-m", options.kg, {0.001, 200.0},
             "height of the centre of gravity above base, solid [m]; default: the file's");
}

std::unique_ptr<FloatingHull> float_hull(const std::string& file, const LoadingOptions& options) {
  auto ship = std::make_unique<FloatingHull>();  // 300 kB: not on the stack
  ship->file = file;
  if (const FileStatus status = read_hull_file(file, ship->hull); !status) {
    throw InputError{status.line()};
  }
  settle(*ship, options);
  return ship;
}

std::unique_ptr<FloatingHull> float_hull_text(std::string_view text, const std::string& file) {
  auto ship = std::make_unique<FloatingHull>();
  ship->file = file;
  require(parse_hull(text, file, ship->hull));
  settle(*ship, {});
  return ship;
}

}  // namespace quickstrip::hull_tool
