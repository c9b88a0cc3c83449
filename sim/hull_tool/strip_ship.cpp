#include "sim/hull_tool/strip_ship.hpp"

#include "core/advice/quality.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"

namespace quickstrip::hull_tool {

void add_strip_options(CLI::App& command, StripOptions& options) {
  add_hull_argument(command, options.file);
  add_loading_options(command, options.loading);
  add_method_options(command, options.method);
  add_number(command, "--roll-damping-ratio", options.roll_damping_ratio, {0.0, 1.0},
             "added roll damping as a ratio of critical, instead of the file's");
}

StripShip load_strip_ship(const StripOptions& options) {
  StripShip ship;
  ship.floating = float_hull(options.file, options.loading);
  ship.table = load_table(options.method.table, ship.floating->hull);
  ship.loaded = std::make_unique<LoadedHull>();
  const Status status = load(ship.floating->hull, ship.floating->loading, options.method.method(),
                             *ship.loaded, view_of(ship.table));
  if (!status) {
    throw InputError{explain(status.error(), *ship.floating, options.loading)};
  }
  if (ship.loaded->is_outside_table) {
    say_outside(options.method.table, ship.table->view, ship.floating->loading);
  }
  if (options.roll_damping_ratio) {
    set_roll_damping_ratio(*ship.loaded, *options.roll_damping_ratio);
  }
  ship.quality = hull_quality(*ship.loaded, ship.floating->loading);
  return ship;
}

}  // namespace quickstrip::hull_tool
