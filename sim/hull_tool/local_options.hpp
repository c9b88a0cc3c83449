// Options of `responses` on points and levels of the user's own: --point, --level.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/hull/hull.hpp"
#include "core/response/quantity.hpp"

namespace quickstrip::hull_tool {

struct GivenPoint {
  std::string name;  // as given: "30,0,35"
  double x = 0.0;    // as in the hull file [m]
  double y = 0.0;
  double z = 0.0;
};

struct GivenLevel {
  Quantity quantity = Quantity::kRoll;
  double level = 0.0;  // in the unit of the quantity's rows
};

struct LocalOptions {
  std::vector<GivenPoint> points;
  std::vector<GivenLevel> levels;

  [[nodiscard]] std::optional<double> level_of(Quantity quantity) const;
};

/// --point x,y,z (at most 16) and --level QUANTITY=VALUE, repeatable. Wrong text is wrong use.
void add_local_options(CLI::App& command, LocalOptions& options);

/// Throws InputError, which names the point and the box that it should lie in: the ship's length and breadth
/// as for a [[point]] of the hull file.
void check_points(const LocalOptions& options, const Hull& hull);

}  // namespace quickstrip::hull_tool
