// quickstrip-hull compare: this hull's motions beside transfer functions from elsewhere.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/parent_options.hpp"
#include "sim/hull_tool/strip_ship.hpp"
#include "sim/hull_tool/transfer_comparison.hpp"
#include "sim/hull_tool/transfer_file.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  StripOptions strip;
  std::string with;
  std::string point = "waterline";
  std::string format = "table";
  ParentChoice parent;
  ComparisonWindow window;
};

std::vector<MotionTransfer> parent_motions(const ParentShip& parent,
                                           const std::vector<TransferValue>& values) {
  std::vector<ParentWave> waves;
  for (const TransferValue& value : values) {
    waves.push_back({value.omega, {wrap_pi(radians(value.mu_deg))}, from_knots(value.speed_kn)});
  }
  std::vector<MotionTransfer> out;
  for (const ParentResponse& response : parent.solve(waves)) {
    out.push_back(response.transfer);
  }
  return out;
}

std::string as_csv(const std::vector<CurveDeviation>& curves) {
  Csv csv("speed_kn,mu_deg,motion,frequencies,peak,scale,rms_percent,worst_percent,worst_omega_rad_s");
  for (const CurveDeviation& c : curves) {
    csv.add(c.speed_kn).add(c.mu_deg).add(kMotionNames[c.motion]).add(static_cast<int>(c.num_frequencies));
    csv.add(c.peak).add(c.scale).add(c.rms_percent).add(c.worst_percent).add(c.worst_omega);
    csv.end_row();
  }
  return csv.text();
}

/// One line a speed and direction, one column a motion; "-" where the other source has no such motion, or
/// less than a thousandth of what it has from elsewhere (sway in head seas).
template <typename Text>
void add_block(std::string& out, const std::vector<CurveDeviation>& curves, const char* title, Text text) {
  out += fmt::format("\n{}\n{:>8} {:>7} {:>6}", title, "speed_kn", "mu_deg", "freq.");
  for (const std::string_view name : kMotionNames) {
    out += fmt::format(" {:>8}", name);
  }
  out += '\n';
  std::vector<const CurveDeviation*> lines;  // the first curve of each speed and direction
  const auto same_line = [](const CurveDeviation& a, const CurveDeviation& b) {
    return a.speed_kn == b.speed_kn && a.mu_deg == b.mu_deg;
  };
  for (const CurveDeviation& curve : curves) {
    if (std::none_of(lines.begin(), lines.end(), [&](const auto* l) { return same_line(*l, curve); })) {
      lines.push_back(&curve);
    }
  }
  for (const CurveDeviation* line : lines) {
    std::array<std::string, 6> cells;
    cells.fill("-");
    for (const CurveDeviation& c : curves) {
      if (same_line(c, *line) && c.peak > 1e-3 * 4.0 * c.scale) {
        cells[c.motion] = text(c);
      }
    }
    out += fmt::format("{:>8g} {:>7g} {:>6} {:>8}\n", line->speed_kn, line->mu_deg, line->num_frequencies,
                       fmt::join(cells, " "));
  }
}

std::string as_table(const Options& options, const std::vector<CurveDeviation>& curves) {
  std::string out = fmt::format(
      "{} beside {}\nRoot mean square of the difference of amplitudes over {:g} < omega < {:g} rad/s, "
      "omega_e > {:g} rad/s,\nin % of max(peak, a quarter of the largest peak over the directions at that "
      "speed)\n",
      options.strip.file, options.with, options.window.omega_from, options.window.omega_to,
      options.window.encounter_from);
  add_block(out, curves, "RMS, %", [](const auto& c) { return fmt::format("{:.1f}", c.rms_percent); });
  add_block(out, curves, "worst, % (ours less theirs)",
            [](const auto& c) { return fmt::format("{:+.1f}", c.worst_percent); });
  add_block(out, curves, "peak of theirs, m/m and rad/m",
            [](const auto& c) { return fmt::format("{:.4g}", c.peak); });
  return out;
}

void run(const Options& options) {
  const std::vector<TransferValue> values = read_transfer_file(options.with);
  const ComparisonPoint point =
      options.point == "G" ? ComparisonPoint::kGravity : ComparisonPoint::kWaterline;
  std::vector<CurveDeviation> curves;
  if (options.parent.is_given()) {
    const std::unique_ptr<ParentShip> parent = load_parent(options.strip, options.parent);
    curves = compare_transfer(
        parent->hull(), values, options.window, point,
        [&](const std::vector<TransferValue>& wanted) { return parent_motions(*parent, wanted); });
  } else {
    curves = compare_transfer(*load_strip_ship(options.strip).loaded, values, options.window, point);
  }
  print_result(options.format == "csv" ? as_csv(curves) : as_table(options, curves));
}

}  // namespace

void add_compare(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("compare", "Amplitudes of motion beside those of another source, curve by curve");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  command->add_option("--with", options->with, "CSV file of transfer functions, see below")
      ->required()
      ->type_name("FILE");
  add_parent_choice(*command, "--parent", options->parent,
                    "motions by the parent program, with these sections, instead of the program on board");
  command
      ->add_option("--at", options->point,
                   "what FILE's motions are those of: the point of the waterline at the x of G, or G")
      ->check(CLI::IsMember({"waterline", "G"}))
      ->capture_default_str()
      ->type_name("");
  command->add_option("--format", options->format, "table or csv")
      ->check(CLI::IsMember({"table", "csv"}))
      ->capture_default_str()
      ->type_name("");
  command->footer(
      "FILE: '#' begins a comment; a header line names the columns, in any order: speed_kn, mu_deg or\n"
      "direction_deg (0 following, 90 from starboard, 180 head), omega or omega_rad_s, and either dof and\n"
      "amplitude, one motion a line (dof: surge, sway, heave, roll, pitch or yaw), or surge_amp ... yaw_amp\n"
      "as `motions` prints them. m/m and rad/m; other columns are ignored.\n"
      "Compared are frequencies 0.2 < omega < 1.6 rad/s with omega_e > 0.1 rad/s.\n"
      "Example: quickstrip-hull compare sim/hulls/s175.hull.toml --with "
      "tests/golden/s175_veres_amplitudes.csv\n"
      "         --method modified --surge inertia-only");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
