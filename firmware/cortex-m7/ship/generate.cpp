// quickstrip-ship-in-flash HULL LIMITS OUT.cpp: hull file and limits (or "-": NORDFORSK 1987 for merchant
// ships) as constants of a C++ source, for a machine that reads no files (ship.hpp). Runs on the machine that
// builds. Numbers are written in hexadecimal: nothing is rounded.
//
// The grid is made coarse enough for the board: its own range of speeds in 8, headings every 10 degrees.
// A ship of more stations or points than the profile m7 takes is refused by the board at its start.
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>

#include "core/base/constants.hpp"
#include "msgs/files/file_status.hpp"
#include "msgs/files/ship_files.hpp"

namespace {

using namespace quickstrip;

constexpr int kSpeeds = 8;
constexpr double kHeadingStep = kPi / 18.0;

class Source {
 public:
  template <typename... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    text_ += fmt::format(format, std::forward<Args>(args)...) + "\n";
  }
  void set(std::string_view what, double value) { line("  {} = {:a};", what, value); }
  void set(std::string_view what, const std::optional<double>& value) {
    if (value) {
      set(what, *value);
    }
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Bytes beyond letters and digits in octal, three digits each: no other character can join them.
std::string quoted(const Name& name) {
  std::string text = "Name(\"";
  for (const char c : name.view()) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          c == ' ' || c == '-' || c == '.';
    text += is_plain ? std::string(1, c) : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  }
  return text + "\")";
}

template <typename Enumeration>
std::string cast(std::string_view type, Enumeration value) {
  return fmt::format("{}{{{}}}", type, static_cast<std::underlying_type_t<Enumeration>>(value));
}

void write_stations(const Hull& hull, Source& out) {
  for (const Station& station : hull.stations) {
    out.line("  {{");
    out.line("    static constexpr double kOffsets[][2] = {{");
    for (const Offset& offset : station.offsets) {
      out.line("        {{{:a}, {:a}}},", offset.y, offset.z);
    }
    out.line("        {{0.0, 0.0}}}};");  // an array of none is none
    out.line("    add_station(hull, {{{:a}, {:a}, {:a}, {:a}}}, std::span(kOffsets).first({}));", station.x,
             station.breadth, station.draught, station.area, station.offsets.size());
    out.line("  }}");
  }
}

void write_loading(const Loading& loading, Source& out) {
  out.set("hull.loading.draught_aft", loading.draught_aft);
  out.set("hull.loading.draught_fwd", loading.draught_fwd);
  out.set("hull.loading.kg", loading.kg);
  out.set("hull.loading.free_surface_correction", loading.free_surface_correction);
  out.set("hull.loading.gm", loading.gm);
  out.set("hull.loading.roll_gyradius", loading.roll_gyradius);
  out.set("hull.loading.pitch_gyradius", loading.pitch_gyradius);
  out.set("hull.loading.yaw_gyradius", loading.yaw_gyradius);
  out.set("hull.loading.measured_roll_period", loading.measured_roll_period);
  out.set("hull.loading.water_density", loading.water_density);
  out.set("hull.loading.viscosity", loading.viscosity);
  out.set("hull.loading.gravity", loading.gravity);
}

void write_roll_damping(const RollDamping& damping, Source& out) {
  out.line("  hull.roll_damping.method = {};", cast("RollDampingMethod", damping.method));
  out.set("hull.roll_damping.ratio", damping.ratio);
  if (damping.bilge_keel) {
    const BilgeKeel& keel = *damping.bilge_keel;
    out.line("  hull.roll_damping.bilge_keel = BilgeKeel{{{:a}, {:a}, {:a}}};", keel.x_aft, keel.x_fwd,
             keel.breadth);
  }
  if (damping.stabiliser) {
    out.line("  hull.roll_damping.stabiliser = Stabiliser{{{:a}, {:a}}};", damping.stabiliser->ratio,
             damping.stabiliser->speed);
  }
}

void write_places(const Hull& hull, Source& out) {
  for (const PointOfInterest& point : hull.points) {
    out.line("  add(hull.points, {{{}, {}, {:a}, {:a}, {:a}}});", quoted(point.name),
             cast("PointRole", point.role), point.x, point.y, point.z);
  }
  for (const SlammingStation& station : hull.slamming) {
    out.line("  add(hull.slamming, {{{}, {:a}, {}}});", quoted(station.name), station.x,
             station.threshold_velocity ? fmt::format("{:a}", *station.threshold_velocity) : "std::nullopt");
  }
  for (const FreeboardPoint& point : hull.freeboard) {
    out.line("  add(hull.freeboard, {{{}, {:a}, {:a}}});", quoted(point.name), point.x, point.height);
  }
  if (hull.propeller) {
    out.line("  hull.propeller = Propeller{{{:a}, {:a}}};", hull.propeller->x, hull.propeller->tip_z);
  }
  for (const CalmWaterResistance& at : hull.resistance) {
    out.line("  add(hull.resistance, {{{:a}, {:a}}});", at.speed, at.force);
  }
}

void write_grid(const Hull& hull, Source& out) {
  const GridDefinition& grid = hull.grid;
  const double coarse = (grid.speed_to - grid.speed_from) / (kSpeeds - 1);
  out.set("hull.grid.speed_from", grid.speed_from);
  out.set("hull.grid.speed_to", grid.speed_to);
  out.set("hull.grid.speed_step", std::max(grid.speed_step, coarse));
  out.set("hull.grid.heading_step", std::max(grid.heading_step, kHeadingStep));
}

void write_hull(const Hull& hull, Source& out) {
  out.line("void fill(Hull& hull) {{");
  out.line("  hull.name = {};", quoted(hull.name));
  out.set("hull.lpp", hull.lpp);
  out.set("hull.breadth", hull.breadth);
  write_stations(hull, out);
  write_loading(hull.loading, out);
  write_roll_damping(hull.roll_damping, out);
  write_places(hull, out);
  out.set("hull.min_steerage_speed", hull.min_steerage_speed);
  out.set("hull.handling.turn_rate", hull.handling.turn_rate);
  out.set("hull.handling.slowing", hull.handling.slowing);
  out.set("hull.handling.speeding_up", hull.handling.speeding_up);
  write_grid(hull, out);
  out.line("}}\n");
}

void write_criteria(const Criteria& criteria, Source& out) {
  out.line("void fill(Criteria& criteria) {{");
  for (const Criterion& c : criteria) {
    out.line("  add(criteria, {{{}, {}, {}, {}, {:a}, {:a}, {:a}, {{{:a}, {:a}}}}});", quoted(c.name),
             cast("Quantity", c.quantity), c.place, cast("Statistic", c.statistic), c.limit,
             c.caution_fraction, c.exposure, c.stance.height, c.stance.half_width_ratio);
  }
  out.line("}}\n");
}

std::string source_of(const ShipFiles& files, const std::string& hull_file) {
  Source out;
  out.line("// Generated by quickstrip-ship-in-flash from {}; do not edit.", hull_file);
  out.line("#include \"firmware/cortex-m7/ship/ship.hpp\"\n");
  out.line("namespace quickstrip::ship {{");
  write_hull(files.hull, out);
  write_criteria(files.criteria, out);
  out.line("Name profile() {{\n  return {};\n}}\n", quoted(files.profile));
  out.line("}}  // namespace quickstrip::ship");
  return out.text();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: quickstrip-ship-in-flash HULL LIMITS|- OUT.cpp\n");
    return 2;
  }
  const std::string limits = argv[2];
  const auto files = std::make_unique<ShipFiles>();
  if (const FileStatus status = read_ship_files(argv[1], limits == "-" ? "" : limits, *files); !status.ok()) {
    fmt::print(stderr, "{}\n", status.line());
    return 1;
  }
  std::ofstream out(argv[3]);
  out << source_of(*files, argv[1]);
  out.close();
  if (!out) {
    fmt::print(stderr, "{}: cannot be written\n", argv[3]);
    return 1;
  }
  return 0;
}
