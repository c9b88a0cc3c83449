#include "msgs/files/hull_file_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/check.hpp"
#include "core/hull/hydrostatics.hpp"

namespace quickstrip {
namespace {

constexpr double kBeyondEnds = 0.2;       // [lpp]
constexpr double kDefaultSlamming = 0.9;  // [lpp] from the aft perpendicular
constexpr double kNoEdge = -1.0;
constexpr double kOverhang = 0.05;         // [lpp]
constexpr double kWing = 0.1;              // [breadth]
constexpr double kGreatestHeight = 150.0;  // m

/// Name of a place; refused when a place before has it, because outputs are told apart by name.
template <typename Places>
Name unique_name(const TomlTable& table, const Places& places) {
  const Name name(table.name("name"));
  for (const auto& other : places) {
    if (other.name == name) {
      table.refuse("name", "a name of its own is wanted: one before has the same");
    }
  }
  return name;
}

double foremost_deck_edge(const Hull& hull, double& x) {
  double z = kNoEdge;
  for (const Station& station : hull.stations) {  // increasing x
    if (!station.is_minimal()) {
      x = station.x;
      z = station.offsets.back().z;
    }
  }
  return z;
}

void read_points(const TomlTable& root, Hull& hull) {
  constexpr std::array kRoles{PointRole::kBridge, PointRole::kForwardPerpendicular, PointRole::kDeck,
                              PointRole::kPassengers, PointRole::kOther};
  bool has_fp = false;
  for (const TomlTable& table : root.tables("point", kMaxPoints)) {
    table.allow_only({"name", "role", "x_m", "y_m", "z_m"});
    PointOfInterest point;
    point.name = unique_name(table, hull.points);
    point.role = kRoles[table.choice("role", {"bridge", "fp", "deck", "passengers", "other"})];
    const bool is_fp = point.role == PointRole::kForwardPerpendicular;
    double edge_x = 0.0;
    const double edge_z = foremost_deck_edge(hull, edge_x);
    const bool x_defaults = is_fp && !table.has("x_m");
    const bool z_defaults = is_fp && !table.has("z_m") && edge_z > 0.0;
    point.x = x_defaults ? hull.lpp : table.number("x_m", on_the_ship(hull));
    point.y = table.number_or("y_m", across_the_ship(hull), 0.0);
    point.z = z_defaults ? edge_z : table.number("z_m", above_the_base(hull));
    has_fp = has_fp || is_fp;
    QS_CHECK(hull.points.push_back(point));
  }
  double x = 0.0;
  const double deck_edge = foremost_deck_edge(hull, x);
  if (!has_fp && deck_edge > 0.0) {
    PointOfInterest fp{Name("fp"), PointRole::kForwardPerpendicular, hull.lpp, 0.0, deck_edge};
    if (!hull.points.push_back(fp)) {
      root.refuse_list("point", fmt::format("{} given, none of role \"fp\": {} and the default one fit",
                                            kMaxPoints, kMaxPoints - 1));
    }
  }
}

void read_slamming(const TomlTable& root, Hull& hull) {
  for (const TomlTable& table : root.tables("slamming", kMaxSlammingStations)) {
    table.allow_only({"name", "x_m"});
    SlammingStation station;
    station.name = unique_name(table, hull.slamming);
    // Its keel must be known.
    station.x = table.number("x_m", {hull.stations.front().x, hull.stations.back().x,
                                     "m from the aft perpendicular, between the first and the last station"});
    QS_CHECK(hull.slamming.push_back(station));
  }
  if (hull.slamming.empty()) {
    QS_CHECK(hull.slamming.push_back({Name("bow"), kDefaultSlamming * hull.lpp, std::nullopt}));
  }
}

void read_freeboard(const TomlTable& root, Hull& hull) {
  const double draught = std::max(hull.loading.draught_aft, hull.loading.draught_fwd);
  for (const TomlTable& table : root.tables("freeboard", kMaxFreeboardPoints)) {
    table.allow_only({"name", "x_m", "height_m"});
    FreeboardPoint point;
    point.name = unique_name(table, hull.freeboard);
    point.x = table.number("x_m", on_the_ship(hull));
    point.height = table.number("height_m", above_the_base(hull));
    const double waterline = waterline_height(hull, hull.loading, point.x);
    if (!(point.height > waterline)) {
      table.refuse("height_m",
                   fmt::format("a deck edge above the waterline there, {:g} m, is wanted", waterline));
    }
    QS_CHECK(hull.freeboard.push_back(point));
  }
  double x = 0.0;
  const double deck_edge = foremost_deck_edge(hull, x);
  if (hull.freeboard.empty() && deck_edge > draught) {
    QS_CHECK(hull.freeboard.push_back({Name("bow"), x, deck_edge}));
  }
}

void read_propeller(const TomlTable& root, Hull& hull) {
  if (const auto table = root.optional_table("propeller")) {
    table->allow_only({"x_m", "tip_z_m"});
    const double x = table->number("x_m", on_the_ship(hull));
    const double tip_z = table->number("tip_z_m", {-20.0, 40.0, "m above the base line"});
    const double waterline = waterline_height(hull, hull.loading, x);
    if (!(tip_z < waterline)) {
      table->refuse("tip_z_m", fmt::format("the upper blade tip below the waterline there, {:g} m, is wanted",
                                           waterline));
    }
    hull.propeller = Propeller{x, tip_z};
  }
}

}  // namespace

NumberRange along_the_ship(const Hull& hull) {
  return {-kBeyondEnds * hull.lpp, (1.0 + kBeyondEnds) * hull.lpp, "m from the aft perpendicular"};
}

NumberRange on_the_ship(const Hull& hull) {
  const double overhang = kOverhang * hull.lpp;
  return {std::min(0.0, hull.stations.front().x) - overhang,
          std::max(hull.lpp, hull.stations.back().x) + overhang, "m from the aft perpendicular"};
}

NumberRange across_the_ship(const Hull& hull) {
  const double half = (0.5 + kWing) * hull.breadth;
  return {-half, half, "m to port"};
}

NumberRange above_the_base(const Hull& hull) {
  return {0.0, std::min(hull.lpp, kGreatestHeight), "m above the base line"};
}

void read_places(const TomlTable& root, Hull& hull) {
  read_points(root, hull);
  read_slamming(root, hull);
  read_freeboard(root, hull);
  read_propeller(root, hull);
}

}  // namespace quickstrip
