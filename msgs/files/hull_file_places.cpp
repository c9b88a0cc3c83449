#include "msgs/files/hull_file_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

constexpr double kBeyondEnds = 0.2;       // [lpp]
constexpr double kDefaultSlamming = 0.9;  // [lpp] from the aft perpendicular
constexpr double kNoEdge = -1.0;
constexpr NumberRange kHeights{0.0, 150.0, "m above the base line"};

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
    point.x = x_defaults ? hull.lpp : table.number("x_m", along_the_ship(hull));
    point.y = table.number_or("y_m", {-hull.breadth, hull.breadth, "m to port"}, 0.0);
    point.z = z_defaults ? edge_z : table.number("z_m", kHeights);
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
    station.x = table.number("x_m", along_the_ship(hull));
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
    point.x = table.number("x_m", along_the_ship(hull));
    point.height = table.number("height_m", kHeights);
    if (!(point.height > draught)) {
      table.refuse("height_m", fmt::format("a deck edge above the draught, {:g} m, is wanted", draught));
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
    hull.propeller = Propeller{table->number("x_m", along_the_ship(hull)),
                               table->number("tip_z_m", {-20.0, 40.0, "m above the base line"})};
  }
}

}  // namespace

NumberRange along_the_ship(const Hull& hull) {
  return {-kBeyondEnds * hull.lpp, (1.0 + kBeyondEnds) * hull.lpp, "m from the aft perpendicular"};
}

void read_places(const TomlTable& root, Hull& hull) {
  read_points(root, hull);
  read_slamming(root, hull);
  read_freeboard(root, hull);
  read_propeller(root, hull);
}

}  // namespace quickstrip
