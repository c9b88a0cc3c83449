#include "sim/picture/polar_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/hazard/hazard_bits.hpp"
#include "sim/picture/governing_regions.hpp"
#include "sim/picture/message_text.hpp"
#include "sim/picture/polar_geometry.hpp"
#include "sim/picture/polar_side_panel.hpp"

namespace quickstrip {
namespace {

constexpr double kFullScale = 26.0;      // the polar's radius in the plane, whatever its speeds [units]
constexpr int kFarMargin = 67;           // grid_t's margin in steps of 0.01
constexpr double kRingStepKn = 5.0;      // labelled rings
constexpr double kSmallestLetter = 7.0;  // a region below this area carries no letter [units squared]

/// The script as it grows: commands and data first, the plot's elements collected for one plot command.
struct Script {
  std::string text;
  std::vector<std::string> elements;

  void add(const PlotData& data, const std::string& style) {
    if (data.empty()) {
      return;
    }
    const std::string name = fmt::format("$d{}", elements.size());
    text += name + " << EOD\n" + data.text() + "EOD\n";
    elements.push_back(name + " using 1:2 " + style + " notitle");
  }
  void label(PlanePoint at, std::string_view what, std::string_view style) {
    text +=
        fmt::format("set label {} at {:.3f},{:.3f} noenhanced front {}\n", quoted(what), at.x, at.y, style);
  }
};

/// Scale of the plane: knots to units, so that every hull fills the same circle.
struct Scale {
  double units_per_kn = 1.0;
  double outer = kFullScale;
};

grid_t scaled(const grid_t& grid, Scale& scale) {
  grid_t out = grid;
  if (grid.num_speeds > 0) {
    scale.units_per_kn = kFullScale / ring_outside(grid, grid.num_speeds - 1);
  }
  for (int s = 0; s < grid.num_speeds; ++s) {
    out.speed_kn[s] = static_cast<float>(static_cast<double>(grid.speed_kn[s]) * scale.units_per_kn);
  }
  return out;
}

void add_cells(Script& script, const grid_t& grid) {
  std::array<PlotData, 4> by_verdict;
  PlotData far_exceeded;
  PlotData no_steerage;
  PlotData zone_only;
  PlotData zone_and_motions;
  for (int s = 0; s < grid.num_speeds; ++s) {
    for (int h = 0; h < grid.num_headings; ++h) {
      const int verdict = std::clamp<int>(grid.verdict[s][h], 0, 3);
      const bool is_far =
          verdict == grid_t::VERDICT_EXCEEDED && grid.margin[s][h] >= 0 && grid.margin[s][h] < kFarMargin;
      PlotData& cells = is_far ? far_exceeded : by_verdict[static_cast<std::size_t>(verdict)];
      cells.polygon(cell_sector(grid, s, h));
      const int hazards = grid.hazards[s][h];
      if ((hazards & kHazardNoSteerage) != 0) {
        no_steerage.polygon(cell_sector(grid, s, h));
      } else if ((hazards & kZoneBits) != 0) {
        const bool both = (hazards & kHazardMotions) != 0;
        (both ? zone_and_motions : zone_only).polygon(cell_sector(grid, s, h));
      }
    }
  }
  for (std::size_t v = 0; v < by_verdict.size(); ++v) {
    script.add(by_verdict[v],
               fmt::format("with filledcurves closed fs solid noborder fc rgb '{}'", kVerdictColours[v]));
  }
  script.add(far_exceeded,
             fmt::format("with filledcurves closed fs solid noborder fc rgb '{}'", kFarExceededColour));
  script.add(by_verdict[0], "with filledcurves closed fs transparent pattern 5 noborder fc rgb '#777777'");
  // Motion only: no hatch.
  script.add(zone_only, fmt::format("with filledcurves closed fs transparent pattern {} noborder fc rgb '{}'",
                                    kZoneOnlyPattern, kZoneOnlyColour));
  script.add(zone_and_motions,
             fmt::format("with filledcurves closed fs transparent pattern {} noborder fc rgb '{}'",
                         kZoneAndMotionsPattern, kZoneAndMotionsColour));
  script.add(no_steerage, "with filledcurves closed fs transparent pattern 4 noborder fc rgb '#8A8A8A'");
}

/// Where the letter of a region stands: at its middle, or some columns aside when the ship lies there.
PlanePoint letter_place(const grid_t& grid, const GoverningRegion& region, PlanePoint ship) {
  constexpr double kClearance = 3.2;  // half a ship and half a letter
  constexpr std::array<int, 7> kAside{0, 3, -3, 5, -5, 8, -8};
  for (const int columns : kAside) {
    const int h = (region.heading + columns + grid.num_headings) % grid.num_headings;
    const PlanePoint at = cell_centre(grid, region.speed, h);
    const bool is_clear = std::hypot(at.x - ship.x, at.y - ship.y) > kClearance;
    if (is_clear && shown_criterion(grid, region.speed, h) == region.criterion) {
      return at;
    }
  }
  return cell_centre(grid, region.speed, region.heading);
}

void add_governing(Script& script, const grid_t& grid, const limits_t& limits, PlanePoint ship) {
  PlotData borders;
  for (int s = 0; s < grid.num_speeds; ++s) {
    for (int h = 0; h < grid.num_headings; ++h) {
      const double middle = column_heading_deg(grid, h);
      const double half = 0.5 * column_width_deg(grid);
      const int here = shown_criterion(grid, s, h);
      if (here != shown_criterion(grid, s, (h + 1) % grid.num_headings)) {
        borders.line({at_bearing(middle + half, ring_inside(grid, s)),
                      at_bearing(middle + half, ring_outside(grid, s))});
      }
      if (s + 1 < grid.num_speeds && here != shown_criterion(grid, s + 1, h)) {
        borders.line(arc(ring_outside(grid, s), middle - half, middle + half));
      }
    }
  }
  script.add(borders, "with lines lw 1.4 lc rgb '#3A2A1A'");
  const std::vector<std::string> letters = criterion_letters(limits);
  for (const GoverningRegion& region : governing_regions(grid)) {
    if (region.area < kSmallestLetter || static_cast<std::size_t>(region.criterion) >= letters.size()) {
      continue;
    }
    const bool on_red = grid.verdict[region.speed][region.heading] == grid_t::VERDICT_EXCEEDED;
    script.label(letter_place(grid, region, ship), letters[static_cast<std::size_t>(region.criterion)],
                 fmt::format("center font ',22' tc rgb '{}'", on_red ? "#FFFFFF" : "#3A2A1A"));
  }
}

void add_rings(Script& script, const Scale& scale) {
  PlotData rings;
  PlotData spokes;
  const double fastest = scale.outer / scale.units_per_kn;
  for (double kn = kRingStepKn; kn < fastest; kn += kRingStepKn) {
    rings.line(arc(kn * scale.units_per_kn, 0.0, 360.0));
    const PlanePoint at = at_bearing(90.0, kn * scale.units_per_kn);
    script.label({at.x, at.y}, fmt::format("{:.0f} kn", kn), "center font ',13' tc rgb '#222222' boxed");
  }
  for (int bearing = 0; bearing < 360; bearing += 30) {
    spokes.line({at_bearing(bearing, 0.0), at_bearing(bearing, scale.outer)});
  }
  script.add(spokes, "with lines lw 0.7 lc rgb '#66444444'");
  script.add(rings, "with lines lw 1.0 lc rgb '#55333333'");
  PlotData rim;
  rim.line(arc(scale.outer, 0.0, 360.0));
  script.add(rim, "with lines lw 2.2 lc rgb '#222222'");
  constexpr std::array<const char*, 12> kCompass{"N", "030", "060", "E", "120", "150",
                                                 "S", "210", "240", "W", "300", "330"};
  for (std::size_t i = 0; i < kCompass.size(); ++i) {
    const bool is_cardinal = i % 3 == 0;
    script.label(
        at_bearing(30.0 * static_cast<double>(i), scale.outer + 1.7), kCompass[i],
        is_cardinal ? "center font ':Bold,20' tc rgb '#222222'" : "center font ',13' tc rgb '#555555'");
  }
}

void add_waves(Script& script, const std::vector<PictureWave>& waves) {
  constexpr double kTip = kFullScale + 2.9;  // outside the compass labels
  constexpr double kTail = kFullScale + 7.2;
  PlotData arrows;
  for (const PictureWave& wave : waves) {
    const double width = 0.35 * std::clamp(wave.hs_m, 0.3, 12.0);  // area tells height
    arrows.polygon(inward_arrow(wave.dir_from_deg, kTail, kTip, width));
    const PlanePoint at = at_bearing(wave.dir_from_deg, kTail + 2.7);
    script.label({at.x, at.y + 0.6}, fmt::format("{:.1f} m", wave.hs_m),
                 "center font ':Bold,16' tc rgb '#12436D'");
    script.label({at.x, at.y - 0.9}, fmt::format("Tp {:.1f} s", wave.tp_s),
                 "center font ',13' tc rgb '#12436D'");
  }
  script.add(arrows, "with filledcurves closed fs solid border lc rgb '#12436D' fc rgb '#2E6FA7'");
}

void add_ship_and_changes(Script& script, const advice_t& advice, const Scale& scale) {
  if (advice.no_advice != 0) {
    return;
  }
  const PlanePoint ship = at_bearing(advice.heading_deg, advice.speed_kn * scale.units_per_kn);
  PlotData course;
  course.line({{0.0, 0.0}, ship});
  script.add(course, "with lines lw 2.2 dt (8,5) lc rgb '#000000'");
  const int num = std::min<int>(advice.num_changes, kNumShownChanges);
  for (int i = num - 1; i >= 0; --i) {
    const PlanePoint to =
        at_bearing(advice.change_to_heading_deg[i], advice.change_to_speed_kn[i] * scale.units_per_kn);
    PlotData moved;
    std::vector<PlanePoint> circle = arc(1.0, 0.0, 358.0);
    for (PlanePoint& p : circle) {
      p = {p.x + to.x, p.y + to.y};
    }
    moved.polygon(circle);
    if (i == 0) {
      PlotData way;
      way.line({ship, to});
      script.add(way, "with lines lw 2.6 lc rgb '#1B3FAB'");
    }
    script.add(moved, fmt::format("with filledcurves closed fs solid border lc rgb '#FFFFFF' fc rgb '{}'",
                                  i == 0 ? "#1B3FAB" : "#6E86CF"));
    script.label({to.x, to.y}, std::to_string(i + 1), "center font ':Bold,14' tc rgb '#FFFFFF'");
  }
  PlotData outline;
  outline.polygon(ship_outline(ship, advice.heading_deg, 3.4));
  script.add(outline, "with filledcurves closed fs solid border lc rgb '#000000' lw 2.5 fc rgb '#FFFFFF'");
}

}  // namespace

std::string polar_script(const PolarPicture& picture, const std::string& png) {
  Scale scale;
  const grid_t grid = scaled(picture.grid, scale);
  Script script;
  script.text = fmt::format(
      "set terminal pngcairo size 1600,1186 font 'DejaVu Sans,14' enhanced background rgb '#FBFAF7'\n"
      "set output {}\n"
      "unset key; unset border; unset tics\n"
      "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0\n"
      "set size ratio -1\nset xrange [-36.3:62.2]\nset yrange [-36.5:36.5]\n"
      "set style textbox opaque noborder fillcolor rgb '#38FFFFFF' margins 0.6,0.4\n",
      quoted(png));
  add_cells(script, grid);
  add_rings(script, scale);
  add_governing(script, grid, picture.limits,
                at_bearing(picture.advice.heading_deg, picture.advice.speed_kn * scale.units_per_kn));
  add_waves(script, picture.waves);
  add_ship_and_changes(script, picture.advice, scale);
  script.text += side_panel(picture);
  script.text += "plot ";
  for (std::size_t i = 0; i < script.elements.size(); ++i) {
    script.text += (i == 0 ? "" : ", \\\n     ") + script.elements[i];
  }
  script.text += "\nunset output\n";
  return script.text;
}

}  // namespace quickstrip
