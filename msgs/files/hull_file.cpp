#include "msgs/files/hull_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "core/base/check.hpp"
#include "msgs/convert/ranges.hpp"
#include "msgs/convert/units.hpp"
#include "msgs/files/hull_file_handling.hpp"
#include "msgs/files/hull_file_places.hpp"
#include "msgs/files/text_file.hpp"
#include "msgs/files/toml_table.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kMaxHullFileBytes = 4'000'000;  // 64 stations of 128 points take some 200 kB
constexpr double kLeastBreadth = 0.75;                // [breadth] of the widest station
constexpr double kNearestStations = 1.0e-6;           // [lpp] nearer ones are one station typed twice

void read_particulars(const TomlTable& root, Hull& hull) {
  const TomlTable table = root.table("particulars");
  table.allow_only({"lpp_m", "breadth_m"});
  hull.lpp = table.number("lpp_m", {1.0, 500.0, "m"});  // 1 m: models of the towing tank
  hull.breadth = table.number("breadth_m", {0.1, 100.0, "m"});
  if (!(hull.breadth < hull.lpp)) {
    table.refuse("breadth_m", fmt::format("less than lpp_m = {:g} is wanted (swapped?)", hull.lpp));
  }
}

void read_offsets(const TomlTable& table, const Hull& hull, Station& station) {
  // Half-breadths above half the breadth are flare; above 0.75 of it full breadths were given.
  const auto pairs = table.pairs("offsets_m", kMaxOffsets, {0.0, 0.75 * hull.breadth, "m (half-breadth)"},
                                 {-20.0, 100.0, "m (height)"});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i > 0 && !(pairs[i][1] >= pairs[i - 1][1])) {
      table.refuse_item(
          "offsets_m", i,
          fmt::format("a height of at least {:g}, that of the point before, is wanted: pairs are "
                      "[half-breadth, height] from keel to deck",
                      pairs[i - 1][1]));
    }
    QS_CHECK(station.offsets.push_back({pairs[i][0], pairs[i][1]}));
  }
  if (pairs.size() < 2 || !(pairs.back()[1] > pairs.front()[1])) {
    table.refuse("offsets_m", "at least two points of different height are wanted");
  }
}

Station read_station(const TomlTable& table, const Hull& hull) {
  table.allow_only({"x_m", "offsets_m", "breadth_m", "draught_m", "area_m2"});
  Station station;
  station.x = table.number("x_m", along_the_ship(hull));
  if (table.has("offsets_m")) {
    for (const char* key : {"breadth_m", "draught_m", "area_m2"}) {
      if (table.has(key)) {
        table.refuse(key, "either offsets_m or breadth_m, draught_m and area_m2 are wanted, not both");
      }
    }
    read_offsets(table, hull, station);
    return station;
  }
  if (!table.has("breadth_m") && !table.has("draught_m") && !table.has("area_m2")) {
    table.refuse("offsets_m", "offsets, or breadth_m, draught_m and area_m2, are wanted");
  }
  station.breadth = table.number("breadth_m", {0.0, hull.breadth, "m (full breadth at the waterline)"});
  station.draught = table.number("draught_m", {0.001, 40.0, "m"});
  station.area = table.number("area_m2", {0.0, hull.breadth * station.draught, "m2 (both sides)"});
  return station;
}

/// The stations reach along the ship, and the widest is as wide as the particulars say. To within what
/// bulbous bows, overhangs and flare do; what is less than that `check` remarks upon.
void check_extent(const TomlTable& root, const Hull& hull) {
  const TomlTable particulars = root.table("particulars");
  const double span = hull.stations.back().x - hull.stations.front().x;
  if (!(span >= kLeastSpan * hull.lpp)) {
    particulars.refuse("lpp_m",
                       fmt::format("stations over at least four fifths of it are wanted: they reach from "
                                   "x_m = {:g} to {:g}",
                                   hull.stations.front().x, hull.stations.back().x));
  }
  double widest = 0.0;
  for (const Station& station : hull.stations) {
    widest = std::max(widest, station.breadth);
    for (const Offset& point : station.offsets) {
      widest = std::max(widest, 2.0 * point.y);
    }
  }
  if (!(widest >= kLeastBreadth * hull.breadth)) {
    particulars.refuse(
        "breadth_m",
        fmt::format("the breadth of the stations is wanted: the widest has {:g} m (half-breadths are "
                    "half of it)",
                    widest));
  }
}

void read_stations(const TomlTable& root, Hull& hull) {
  const std::vector<TomlTable> tables = root.tables("station", kMaxStations);
  if (tables.size() < 3) {
    root.refuse_list("station",
                     fmt::format("{} given: at least three tables [[station]] are wanted", tables.size()));
  }
  std::vector<Station> stations;
  for (const TomlTable& table : tables) {
    stations.push_back(read_station(table, hull));
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
      if (!(std::abs(stations[i].x - stations.back().x) >= kNearestStations * hull.lpp)) {
        table.refuse("x_m", fmt::format("an x of its own is wanted: station[{}] has {} {:g}", i + 1,
                                        stations[i].x == stations.back().x ? "the same," : "almost the same,",
                                        stations[i].x));
      }
    }
  }
  std::vector<std::size_t> order(stations.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return stations[a].x < stations[b].x; });
  for (const std::size_t i : order) {
    QS_CHECK(hull.stations.push_back(stations[i]));
  }
  check_extent(root, hull);
}

NumberRange with_unit(Range range, std::string_view unit) {
  return {range.from, range.to, unit};
}

void read_draughts(const TomlTable& table, const Hull& hull, Loading& loading) {
  const NumberRange draughts = with_unit(draught_range_m(hull), "m above the base line");
  loading.draught_aft = table.number("draught_aft_m", draughts);
  loading.draught_fwd = table.number("draught_fwd_m", draughts);
  const double deck = highest_deck(hull);
  for (const char* key : {"draught_aft_m", "draught_fwd_m"}) {
    const double draught = table.number(key, draughts);
    if (deck > 0.0 && !(draught < deck)) {
      table.refuse(key, fmt::format("less than the height of the highest offset, {:g} m, is wanted", deck));
    }
    if (!(draught < hull.breadth)) {
      table.refuse(key, fmt::format("less than the breadth, {:g} m, is wanted", hull.breadth));
    }
  }
  if (!is_trim(loading.draught_aft, loading.draught_fwd, hull)) {
    table.refuse("draught_fwd_m",
                 fmt::format("within {:g} m of draught_aft_m = {:g} is wanted, a trim of 5 % of lpp",
                             kMaxTrim * hull.lpp, loading.draught_aft));
  }
}

void read_loading(const TomlTable& root, Hull& hull) {
  const TomlTable table = root.table("loading");
  table.allow_only({"draught_aft_m", "draught_fwd_m", "kg_m", "free_surface_correction_m", "gm_m",
                    "roll_gyradius_m", "pitch_gyradius_m", "yaw_gyradius_m", "measured_roll_period_s",
                    "water_density_kg_m3", "viscosity_m2_s", "gravity_m_s2"});
  Loading& loading = hull.loading;
  read_draughts(table, hull, loading);
  loading.kg = table.number("kg_m", with_unit(kg_range_m(hull), "m above the base line"));
  loading.free_surface_correction =
      table.optional_number("free_surface_correction_m", with_unit(free_surface_range_m(hull), "m"));
  loading.gm = table.optional_number("gm_m", with_unit(gm_range_m(hull), "m (GM must be positive)"));
  loading.roll_gyradius = table.number("roll_gyradius_m", with_unit(roll_gyradius_range_m(hull), "m"));
  loading.pitch_gyradius = table.number("pitch_gyradius_m", with_unit(long_gyradius_range_m(hull), "m"));
  loading.yaw_gyradius = table.number("yaw_gyradius_m", with_unit(long_gyradius_range_m(hull), "m"));
  loading.measured_roll_period =
      table.optional_number("measured_roll_period_s", with_unit(kRollPeriod_s, "s"));
  loading.water_density =
      table.number_or("water_density_kg_m3", with_unit(kWaterDensity_kg_m3, "kg/m3"), kSeaWaterDensity);
  loading.viscosity =
      table.number_or("viscosity_m2_s", with_unit(kViscosity_m2_s, "m2/s"), kSeaWaterKinematicViscosity);
  loading.gravity = table.number_or("gravity_m_s2", with_unit(kGravity_m_s2, "m/s2"), kStandardGravity);
}

/// Inside the stations, and no broader than a plate on the bilge can be.
BilgeKeel read_bilge_keel(const TomlTable& table, const Hull& hull) {
  table.allow_only({"x_aft_m", "x_fwd_m", "breadth_m"});
  const NumberRange along{hull.stations.front().x, hull.stations.back().x,
                          "m from the aft perpendicular, where the ship has stations,"};
  const double draught = std::min(hull.loading.draught_aft, hull.loading.draught_fwd);
  const NumberRange breadths{0.0001, std::min(0.1 * hull.breadth, 0.2 * draught),
                             "m, at most a tenth of the breadth and a fifth of the draught,"};
  const BilgeKeel out{table.number("x_aft_m", along), table.number("x_fwd_m", along),
                      table.number("breadth_m", breadths)};
  if (!(out.x_aft < out.x_fwd)) {
    table.refuse("x_fwd_m", fmt::format("more than x_aft_m = {:g} is wanted (swapped?)", out.x_aft));
  }
  return out;
}

void read_roll_damping(const TomlTable& root, Hull& hull) {
  constexpr NumberRange kRatios{0.0, 0.5, "of critical"};
  constexpr NumberRange kFullSpeeds{1.0, 60.0, "kn"};
  const TomlTable table = root.table("roll_damping");
  table.allow_only({"method", "ratio", "bilge_keel", "stabiliser"});
  const bool is_ikeda = table.choice("method", {"ratio", "ikeda"}) == 1;
  hull.roll_damping.method = is_ikeda ? RollDampingMethod::kIkeda : RollDampingMethod::kRatio;
  hull.roll_damping.ratio =
      is_ikeda ? table.number_or("ratio", kRatios, 0.0) : table.number("ratio", kRatios);
  if (const auto keel = table.optional_table("bilge_keel")) {
    hull.roll_damping.bilge_keel = read_bilge_keel(*keel, hull);
  }
  if (const auto stabiliser = table.optional_table("stabiliser")) {
    stabiliser->allow_only({"ratio", "speed_kn"});
    hull.roll_damping.stabiliser =
        Stabiliser{.ratio = stabiliser->number("ratio", kRatios),
                   .speed = from_knots(stabiliser->number("speed_kn", kFullSpeeds))};
  }
}

void read_speeds(const TomlTable& speeds, GridDefinition& grid) {
  speeds.allow_only({"from", "to", "step"});
  constexpr NumberRange kSpeeds{0.0, 60.0, "kn"};
  const double from = speeds.number("from", kSpeeds);
  const double to = speeds.number("to", kSpeeds);
  const double step = speeds.number("step", {0.1, 60.0, "kn"});
  if (!(to >= from)) {
    speeds.refuse("to", fmt::format("at least from = {:g} is wanted (swapped?)", from));
  }
  const double steps = (to - from) / step;
  if (!(std::abs(steps - std::round(steps)) < 1e-6)) {  // rounding of decimals such as 0.1
    speeds.refuse("step", fmt::format("a step that divides {:g} is wanted", to - from));
  }
  if (!(std::round(steps) + 1.0 <= static_cast<double>(kMaxSpeeds))) {
    speeds.refuse("step", fmt::format("at most {} speeds fit; this gives {:.0f}", kMaxSpeeds, steps + 1.0));
  }
  grid.speed_from = from_knots(from);
  grid.speed_to = from_knots(to);
  grid.speed_step = from_knots(step);
}

void read_grid(const TomlTable& root, Hull& hull) {
  hull.grid = {from_knots(0.0), from_knots(24.0), from_knots(1.0), radians(5.0)};
  const auto table = root.optional_table("grid");
  if (!table) {
    return;
  }
  table->allow_only({"speeds_kn", "heading_step_deg"});
  if (const auto speeds = table->optional_table("speeds_kn")) {
    read_speeds(*speeds, hull.grid);
  }
  const double step = table->number_or("heading_step_deg", {5.0, 90.0, "degrees"}, 5.0);
  if (std::fmod(step, 5.0) != 0.0 || std::fmod(360.0, step) != 0.0) {
    table->refuse("heading_step_deg", "a multiple of 5 that divides 360 is wanted");
  }
  hull.grid.heading_step = radians(step);
}

void read_all(const TomlTable& root, Hull& hull) {
  root.allow_only({"schema", "name", "particulars", "station", "loading", "roll_damping", "point", "slamming",
                   "freeboard", "propeller", "handling", "resistance", "grid"});
  root.require_schema_1();
  hull.name = Name(root.name("name"));
  read_particulars(root, hull);
  read_stations(root, hull);
  read_loading(root, hull);
  read_roll_damping(root, hull);
  read_places(root, hull);
  read_handling(root, hull);
  read_resistance(root, hull);
  read_grid(root, hull);
}

}  // namespace

FileStatus parse_hull(std::string_view text, std::string_view file, Hull& out) {
  try {
    auto hull = std::make_unique<Hull>();  // 140 kB: not on the stack
    read_all(TomlTable::parse(text, file), *hull);
    out = *hull;
    return {};
  } catch (const FileError& error) {
    return error;
  }
}

FileStatus read_hull_file(const std::filesystem::path& path, Hull& out) {
  try {
    return parse_hull(read_text_file(path, kMaxHullFileBytes), path.string(), out);
  } catch (const FileError& error) {
    return error;
  }
}

}  // namespace quickstrip
