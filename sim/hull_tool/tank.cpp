// quickstrip-hull tank: a hull beside what a towing tank measured on her model.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/measured_file.hpp"
#include "sim/hull_tool/strip_ship.hpp"
#include "sim/hull_tool/tank_figures.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  StripOptions strip;
  std::string with;
  std::string model;
  std::string format = "table";
};

double miss_percent(double computed, double measured) {
  return 100.0 * (computed / measured - 1.0);
}

std::string figures_as_csv(const std::vector<TankFigure>& figures, const std::vector<double>& computed) {
  Csv csv("fn,mu_deg,quantity,abscissa,measured,computed,miss_percent");
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const TankFigure& f = figures[i];
    csv.add(f.fn).add(f.mu_deg).add(name_of(f.quantity)).add(f.abscissa).add(f.measured);
    csv.add(computed[i]).add(miss_percent(computed[i], f.measured));
    csv.end_row();
  }
  return csv.text();
}

std::string curves_as_csv(const std::vector<TankCurve>& curves) {
  Csv csv(
      "fn,mu_deg,quantity,figures,peak_abscissa,peak_measured,peak_computed,peak_miss_percent,rms_percent,"
      "worst_percent");
  for (const TankCurve& c : curves) {
    csv.add(c.fn).add(c.mu_deg).add(name_of(c.quantity)).add(c.num_figures).add(c.peak_abscissa);
    csv.add(c.peak_measured).add(c.peak_computed).add(c.peak_miss_percent);
    csv.add(c.rms_percent).add(c.worst_percent);
    csv.end_row();
  }
  return csv.text();
}

std::string abscissa_text(const std::optional<double>& abscissa) {
  return abscissa ? fmt::format("{:g}", *abscissa) : "largest";
}

std::string as_table(const std::vector<TankFigure>& figures, const std::vector<double>& computed) {
  std::string out = fmt::format("{:>6} {:>7} {:<17}{:>9}{:>10}{:>10}{:>9}\n", "fn", "mu_deg", "quantity",
                                "abscissa", "measured", "computed", "miss, %");
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const TankFigure& f = figures[i];
    out += fmt::format("{:>6g} {:>7g} {:<17}{:>9}{:>10g}{:>10.3f}{:>+9.1f}\n", f.fn, f.mu_deg,
                       name_of(f.quantity), abscissa_text(f.abscissa), f.measured, computed[i],
                       miss_percent(computed[i], f.measured));
  }
  out += fmt::format(
      "\nBy curve, in % of the largest measured value\n{:>6} {:>7} {:<17}{:>8}{:>9}{:>9}{:>8}{:>8}\n", "fn",
      "mu_deg", "quantity", "figures", "peak at", "peak", "RMS", "worst");
  for (const TankCurve& c : tank_curves(figures, computed)) {
    out += fmt::format("{:>6g} {:>7g} {:<17}{:>8}{:>9}{:>+9.1f}{:>8.1f}{:>+8.1f}\n", c.fn, c.mu_deg,
                       name_of(c.quantity), c.num_figures, abscissa_text(c.peak_abscissa),
                       c.peak_miss_percent, c.rms_percent, c.worst_percent);
  }
  return out;
}

void run(const Options& options) {
  const auto figures =
      read_tank_file(options.with, options.model.empty() ? file_stem(options.strip.file) : options.model);
  const StripShip ship = load_strip_ship(options.strip);
  std::vector<double> computed;
  computed.reserve(figures.size());
  for (const TankFigure& figure : figures) {
    computed.push_back(computed_figure(*ship.loaded, figure));
  }
  if (options.format == "csv") {
    print_result(figures_as_csv(figures, computed));
  } else if (options.format == "curves") {
    print_result(curves_as_csv(tank_curves(figures, computed)));
  } else {
    print_result(as_table(figures, computed));
  }
}

}  // namespace

void add_tank(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("tank", "A hull beside figures that a towing tank measured, with the misses");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  command->add_option("--with", options->with, "CSV file of measured figures, see below")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--model", options->model,
                   "which lines of FILE, by its column hull; default: HULL's name up to the first dot")
      ->type_name("NAME");
  command
      ->add_option("--format", options->format, "table, csv (every figure) or curves (CSV, one line a curve)")
      ->check(CLI::IsMember({"table", "csv", "curves"}))
      ->capture_default_str()
      ->type_name("");
  command->footer(
      "FILE: '#' begins a comment; columns fn, quantity (a33, b33, b55, x3, x5, heave, pitch, pitch_slope,\n"
      "added_resistance), abscissa, measured, all dimensionless as the header of the example says, and "
      "perhaps\n"
      "hull and mu_deg (else 180). pitch_slope is pitch in parts of the wave's slope.\n"
      "Example: quickstrip-hull tank sim/hulls/wigley_iii.hull.toml --with tests/golden/wigley_tank.csv "
      "--model "
      "III\n         --method modified");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
