#include "msgs/files/hull_file_text.hpp"

#include <fmt/format.h>

#include <optional>

#include "msgs/convert/units.hpp"
#include "msgs/files/hull_file_handling.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kLineWidth = 110;

// Always with a dot or an exponent: a TOML float.
std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
    }
    out += c;
  }
  return out + '"';
}

void add(std::string& text, const char* key, double value) {
  text += fmt::format("{} = {}\n", key, toml_number(value));
}

void add(std::string& text, const char* key, std::optional<double> value) {
  if (value) {
    add(text, key, *value);
  }
}

void add_comment(std::string& text, std::string_view comment) {
  while (!comment.empty()) {
    const std::size_t end = std::min(comment.find('\n'), comment.size());
    text += fmt::format("# {}\n", comment.substr(0, end));
    comment.remove_prefix(std::min(end + 1, comment.size()));
  }
}

void add_station(std::string& text, const Station& station) {
  text += "\n[[station]]\n";
  add(text, "x_m", station.x);
  if (station.is_minimal()) {
    add(text, "breadth_m", station.breadth);
    add(text, "draught_m", station.draught);
    add(text, "area_m2", station.area);
    return;
  }
  text += "offsets_m = [";
  std::string line = "\n ";
  for (std::size_t i = 0; i < station.offsets.size(); ++i) {
    const Offset& point = station.offsets[i];
    const std::string pair = fmt::format(" [{}, {}]{}", toml_number(point.y), toml_number(point.z),
                                         i + 1 < station.offsets.size() ? "," : "");
    if (line.size() + pair.size() > kLineWidth) {
      text += line;
      line = "\n ";
    }
    line += pair;
  }
  text += line + "\n]\n";
}

void add_loading(std::string& text, const Loading& loading) {
  text += "\n[loading]\n";
  add(text, "draught_aft_m", loading.draught_aft);
  add(text, "draught_fwd_m", loading.draught_fwd);
  add(text, "kg_m", loading.kg);
  add(text, "free_surface_correction_m", loading.free_surface_correction);
  add(text, "gm_m", loading.gm);
  add(text, "roll_gyradius_m", loading.roll_gyradius);
  add(text, "pitch_gyradius_m", loading.pitch_gyradius);
  add(text, "yaw_gyradius_m", loading.yaw_gyradius);
  add(text, "measured_roll_period_s", loading.measured_roll_period);
  add(text, "water_density_kg_m3", loading.water_density);
  add(text, "viscosity_m2_s", loading.viscosity);
  add(text, "gravity_m_s2", loading.gravity);
}

void add_roll_damping(std::string& text, const RollDamping& damping) {
  text += "\n[roll_damping]\n";
  const bool is_ratio = damping.method == RollDampingMethod::kRatio;
  text += fmt::format("method = \"{}\"\n", is_ratio ? "ratio" : "ikeda");
  if (is_ratio || damping.ratio != 0.0) {
    add(text, "ratio", damping.ratio);
  }
  if (damping.bilge_keel) {
    text += fmt::format("bilge_keel = {{ x_aft_m = {}, x_fwd_m = {}, breadth_m = {} }}\n",
                        toml_number(damping.bilge_keel->x_aft), toml_number(damping.bilge_keel->x_fwd),
                        toml_number(damping.bilge_keel->breadth));
  }
  if (damping.stabiliser) {
    text +=
        fmt::format("stabiliser = {{ ratio = {}, speed_kn = {} }}\n", toml_number(damping.stabiliser->ratio),
                    toml_number(to_knots(damping.stabiliser->speed)));
  }
}

const char* word_of(PointRole role) {
  switch (role) {
    case PointRole::kBridge:
      return "bridge";
    case PointRole::kForwardPerpendicular:
      return "fp";
    case PointRole::kDeck:
      return "deck";
    case PointRole::kPassengers:
      return "passengers";
    case PointRole::kOther:
      break;
  }
  return "other";
}

void add_places(std::string& text, const Hull& hull) {
  for (const PointOfInterest& point : hull.points) {
    text += fmt::format("\n[[point]]\nname = {}\nrole = \"{}\"\n", quoted(point.name.view()),
                        word_of(point.role));
    add(text, "x_m", point.x);
    add(text, "y_m", point.y);
    add(text, "z_m", point.z);
  }
  for (const SlammingStation& station : hull.slamming) {
    text += fmt::format("\n[[slamming]]\nname = {}\n", quoted(station.name.view()));
    add(text, "x_m", station.x);
  }
  for (const FreeboardPoint& point : hull.freeboard) {
    text += fmt::format("\n[[freeboard]]\nname = {}\n", quoted(point.name.view()));
    add(text, "x_m", point.x);
    add(text, "height_m", point.height);
  }
  if (hull.propeller) {
    text += "\n[propeller]\n";
    add(text, "x_m", hull.propeller->x);
    add(text, "tip_z_m", hull.propeller->tip_z);
  }
}

void add_speeds(std::string& text, const Hull& hull) {
  text += handling_text(hull);
  text += fmt::format("\n[grid]\nspeeds_kn = {{ from = {}, to = {}, step = {} }}\n",
                      toml_number(to_knots(hull.grid.speed_from)), toml_number(to_knots(hull.grid.speed_to)),
                      toml_number(to_knots(hull.grid.speed_step)));
  add(text, "heading_step_deg", degrees(hull.grid.heading_step));
}

}  // namespace

std::string toml_number(double value) {
  std::string text = fmt::format("{:.10g}", value == 0.0 ? 0.0 : value);  // no "-0"
  if (text.find_first_of(".e") == std::string::npos) {
    text += ".0";
  }
  return text;
}

std::string hull_file_text(const Hull& hull, std::string_view comment) {
  std::string text;
  add_comment(text, comment);
  text += fmt::format("schema = 1\nname = {}\n\n[particulars]\n", quoted(hull.name.view()));
  add(text, "lpp_m", hull.lpp);
  add(text, "breadth_m", hull.breadth);
  for (const Station& station : hull.stations) {
    add_station(text, station);
  }
  add_loading(text, hull.loading);
  add_roll_damping(text, hull.roll_damping);
  add_places(text, hull);
  add_speeds(text, hull);
  return text;
}

}  // namespace quickstrip
