// quickstrip-hull check: everything an architect wants to know about a hull file before it goes on board.
// A file that passes is one that the advisor will load.
#include <fmt/format.h>

#include <memory>

#include "core/hull/imo_roll_period.hpp"
#include "core/hull/lewis_section.hpp"
#include "core/response/swell_up.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/advisor_check.hpp"
#include "sim/hull_tool/check_remarks.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/limits_option.hpp"
#include "sim/hull_tool/quality_text.hpp"
#include "sim/hull_tool/quantity_name.hpp"

namespace quickstrip::hull_tool {
namespace {

void line(std::string& text, const char* label, const std::string& value) {
  text += fmt::format("{:<22}{}\n", label, value);
}

void report_stations(const FloatingHull& ship, std::string& text) {
  const Hull& hull = ship.hull;
  std::size_t minimal = 0;
  for (const Station& station : hull.stations) {
    minimal += station.is_minimal() ? 1U : 0U;
  }
  line(text, "hull", fmt::format("{} ({})", hull.name.view(), ship.file));
  line(text, "lpp, breadth", fmt::format("{:g} m, {:g} m", hull.lpp, hull.breadth));
  line(text, "stations",
       fmt::format("{}, x {:g} ... {:g} m; {} by offsets, {} by breadth, draught and area",
                   hull.stations.size(), hull.stations.front().x, hull.stations.back().x,
                   hull.stations.size() - minimal, minimal));
  line(text, "in the water",
       fmt::format("{}, x {:g} ... {:g} m", ship.sections.size(), ship.sections.front().x,
                   ship.sections.back().x));
  std::size_t submerged = 0;
  for (const ImmersedSection& section : ship.sections) {
    submerged += section.breadth > 0.0 ? 0U : 1U;
  }
  if (submerged > 0) {
    line(text, "wholly submerged", fmt::format("{} (bulb)", submerged));
  }
}

// Sections whose added mass and damping are those of another form (lewis_section.hpp); all else is their own.
void report_replaced(const FloatingHull& ship, std::string& text) {
  for (const ImmersedSection& section : ship.sections) {
    const auto lewis = hydrodynamic_lewis_section(section.breadth, section.draught, section.area);
    if (lewis && lewis->replaced) {
      const double rectangle = section.breadth * section.draught;
      line(text, "replaced",
           fmt::format(
               "x {:g} m: B {:.3g} m, T {:.3g} m, A {:.4g} m2{}; added mass and damping of H0 {:.3f}, sigma "
               "{:.3f}{}",
               section.x, section.breadth, section.draught, section.area,
               rectangle > 0.0 ? fmt::format(" (sigma {:.3g})", section.area / rectangle) : "", lewis->h0,
               lewis->sigma, lewis->extrapolated ? " (beyond the table)" : ""));
    }
  }
}

void report_hydrostatics(const FloatingHull& ship, std::string& text) {
  const Hydrostatics& h = ship.hydrostatics;
  const Loading& loading = ship.loading;
  line(text, "draught", fmt::format("{:g} m aft, {:g} m fwd", loading.draught_aft, loading.draught_fwd));
  line(text, "displacement",
       fmt::format("{:.6g} t ({:.6g} m3 at {:g} kg/m3)", h.displacement / 1000.0, h.volume,
                   loading.water_density));
  line(text, "LCB, LCF", fmt::format("{:.3f} m, {:.3f} m from the aft perpendicular", h.lcb, h.lcf));
  line(text, "KB, BM, KG", fmt::format("{:.3f} m, {:.3f} m, {:.3f} m", h.kb, h.bm, h.kg));
  line(text, "GM", fmt::format("{:.3f} m, longitudinal {:.3f} m", h.gm, h.gml));
  line(text, "CB, CM, CWP", fmt::format("{:.4f}, {:.4f}, {:.4f}", h.cb, h.cm, h.cwp));
  const double draught = 0.5 * (loading.draught_aft + loading.draught_fwd);
  constexpr double kShortestShip = 24.0;  // m: the IS Code's formula is not for models
  if (ship.hull.lpp < kShortestShip) {
    return;
  }
  if (const auto period = imo_roll_period(ship.hull.lpp, ship.hull.breadth, draught, h.gm)) {
    line(text, "roll period", fmt::format("about {:.3g} s by the IS Code's formula", *period));
  }
}

void report_grid(const FloatingHull& ship, std::string& text) {
  const GridDefinition& grid = ship.hull.grid;
  line(text, "grid",
       fmt::format("{:.3g} ... {:.3g} kn by {:.3g}, headings by {:.3g} degrees", to_knots(grid.speed_from),
                   to_knots(grid.speed_to), to_knots(grid.speed_step), degrees(grid.heading_step)));
}

// What --swell-up onboard does for this hull.
void report_swell_up(const FloatingHull& ship, std::string& text) {
  const Result<SwellUpModel> model =
      swell_up_model(SwellUp::kOnboard, ship.hull, ship.loading, ship.hydrostatics);
  if (!model) {
    throw InputError{explain(model.error(), ship, {})};
  }
  const DynamicSwellUp& dynamic = model->at_entrance;
  const bool is_in_range = dynamic.speeds.holds(dynamic.speeds.from);
  line(text, "swell-up, dynamic",
       is_in_range
           ? fmt::format("Tasaki's factor at {:.1f} ... {:.1f} kn, {:.2f} elsewhere",
                         to_knots(dynamic.speeds.from), to_knots(dynamic.speeds.to), dynamic.elsewhere)
           : fmt::format("{:.2f}: CB {:.3f} is outside 0.60 ... 0.80", dynamic.elsewhere,
                         ship.hydrostatics.cb));
  const double fastest = ship.hull.grid.speed_to;
  line(text, "swell-up, static",
       fmt::format("entrance {:.1f} m; bow wave {:.2f} m at {:.3g} kn", model->entrance_length,
                   static_swell_up(*model, ship.hull.lpp).rise(fastest), to_knots(fastest)));
}

// What of a profile this hull file gives no place for.
void report_limits(const LimitsProfile& profile, std::string& text) {
  std::size_t unwatched = 0;
  for (const Criterion& criterion : profile.criteria) {
    unwatched += criterion.is_watched() ? 0U : 1U;
  }
  line(text, "limits",
       fmt::format("\"{}\": {} criteria, {}", profile.name.view(), profile.criteria.size(),
                   unwatched == 0 ? "all watched"
                                  : fmt::format("{} of them not watched: no cell will be good", unwatched)));
  for (const Criterion& criterion : profile.criteria) {
    if (!criterion.is_watched()) {
      line(text, "not watched",
           fmt::format("\"{}\" ({}): the hull file gives no place for it", criterion.name.view(),
                       name_of(criterion.quantity).name));
    }
  }
}

void run(const std::string& file, const std::string& limits) {
  const auto ship = float_hull(file);
  std::string text;
  report_stations(*ship, text);
  report_replaced(*ship, text);
  report_hydrostatics(*ship, text);
  const AdvisorFindings advisor = advisor_findings(*ship);
  line(text, "natural roll period", fmt::format("{:.4g} s by strip theory", advisor.roll_period));
  line(text, "quality",
       advisor.quality == 0 ? "nothing to say of the hull itself" : quality_text(advisor.quality));
  report_swell_up(*ship, text);
  report_grid(*ship, text);
  for (const std::string& remark : warnings_of(*ship)) {
    line(text, "warning", remark);
  }
  if (limits.empty()) {
    for (const std::string& remark : unwatched_of(*ship)) {
      line(text, "not watched", remark);
    }
  } else {
    report_limits(limits_of(limits, *ship), text);
  }
  print_result(text + "ok\n");
}

}  // namespace

void add_check(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("check", "Is this file one that the advisor will load? Ends with \"ok\"");
  const auto file = std::make_shared<std::string>();
  const auto limits = std::make_shared<std::string>();
  add_hull_argument(*command, *file);
  add_limits_option(*command, *limits);
  command->callback([file, limits] { run(*file, *limits); });
}

}  // namespace quickstrip::hull_tool
