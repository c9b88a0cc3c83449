#include "msgs/files/hull_file_handling.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "core/base/angles.hpp"
#include "core/base/check.hpp"
#include "msgs/convert/units.hpp"
#include "msgs/files/hull_file_text.hpp"

namespace quickstrip {
namespace {

constexpr double kDefaultSteerage_kn = 3.0;
constexpr double kMinute_s = 60.0;
constexpr double kKilowatt_W = 1000.0;
constexpr NumberRange kPoweredSpeeds{0.5, 60.0, "kn"};
const char* const kForces = "speed_kn_force_n";
const char* const kPowers = "speed_kn_brake_power_kw";

void add_points(const TomlTable& table, const char* key, const std::vector<std::array<double, 2>>& points,
                double force_per_power, Hull& hull) {
  if (points.size() < 2) {
    table.refuse_list(key, "at least two speeds are wanted");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double speed = from_knots(points[i][0]);
    const double force = force_per_power > 0.0 ? force_per_power * points[i][1] / speed : points[i][1];
    if (i > 0 && !(speed > hull.resistance[i - 1].speed && force > hull.resistance[i - 1].force)) {
      table.refuse_item(key, i, "a higher speed of more resistance than the one before is wanted");
    }
    QS_CHECK(hull.resistance.push_back({speed, force}));
  }
}

}  // namespace

void read_handling(const TomlTable& root, Hull& hull) {
  hull.min_steerage_speed = from_knots(kDefaultSteerage_kn);
  hull.handling = Handling{};
  if (const auto table = root.optional_table("handling")) {
    table->allow_only({"min_steerage_kn", "turn_rate_deg_min", "slow_down_kn_min", "speed_up_kn_min"});
    hull.min_steerage_speed = from_knots(table->number("min_steerage_kn", {0.0, 15.0, "kn"}));
    if (const auto rate = table->optional_number("turn_rate_deg_min", {1.0, 600.0, "degrees a minute"})) {
      hull.handling.turn_rate = radians(*rate) / kMinute_s;
    }
    if (const auto slower = table->optional_number("slow_down_kn_min", {0.05, 60.0, "kn a minute"})) {
      hull.handling.slowing = from_knots(*slower) / kMinute_s;
    }
    if (const auto faster = table->optional_number("speed_up_kn_min", {0.05, 60.0, "kn a minute"})) {
      hull.handling.speeding_up = from_knots(*faster) / kMinute_s;
    }
  }
}

void read_resistance(const TomlTable& root, Hull& hull) {
  hull.resistance.clear();
  const auto table = root.optional_table("resistance");
  if (!table) {
    return;
  }
  table->allow_only({kForces, kPowers, "total_efficiency"});
  if (table->has(kForces)) {
    if (table->has(kPowers) || table->has("total_efficiency")) {
      table->refuse_list(kForces,
                         "either forces, or brake power with total_efficiency, are wanted, not both");
    }
    add_points(*table, kForces,
               table->pairs(kForces, kMaxResistancePoints, kPoweredSpeeds, {1.0, 1.0e8, "N"}), 0.0, hull);
    return;
  }
  const auto powers = table->pairs(kPowers, kMaxResistancePoints, kPoweredSpeeds, {0.1, 2.0e5, "kW"});
  const double efficiency = table->number("total_efficiency", {0.1, 1.0, "of brake power"});
  add_points(*table, kPowers, powers, efficiency * kKilowatt_W, hull);
}

std::string handling_text(const Hull& hull) {
  std::string text = "\n[handling]\n";
  text += fmt::format("min_steerage_kn = {}\n", toml_number(to_knots(hull.min_steerage_speed)));
  text += fmt::format("turn_rate_deg_min = {}\n", toml_number(degrees(hull.handling.turn_rate) * kMinute_s));
  text += fmt::format("slow_down_kn_min = {}\n", toml_number(to_knots(hull.handling.slowing) * kMinute_s));
  text += fmt::format("speed_up_kn_min = {}\n", toml_number(to_knots(hull.handling.speeding_up) * kMinute_s));
  if (hull.resistance.empty()) {
    return text;
  }
  text += fmt::format("\n[resistance]\n{} = [\n", kForces);
  for (const CalmWaterResistance& point : hull.resistance) {
    text += fmt::format("  [{}, {}],\n", toml_number(to_knots(point.speed)), toml_number(point.force));
  }
  return text + "]\n";
}

}  // namespace quickstrip
