// quickstrip-hull wigley: the four Wigley hulls beside what a towing tank measured on them.
#include <fmt/format.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "msgs/cli/method_options.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/tank_figures.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  std::string with;
  std::string format = "table";
  MethodOptions method;
};

/// [hull - 1][0] by the ordinary method, [1] by the modified.
using Wigleys = std::array<std::array<std::unique_ptr<LoadedHull>, 2>, 4>;

Wigleys load_all(const StripMethod& method) {
  Wigleys out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (const StripVariant variant : {StripVariant::kOrdinary, StripVariant::kModified}) {
      StripMethod of = method;
      of.variant = variant;
      auto& hull = out[i][variant == StripVariant::kModified ? 1 : 0];
      hull = std::make_unique<LoadedHull>();
      load_wigley(static_cast<int>(i) + 1, of, *hull);
    }
  }
  return out;
}

double miss_percent(double computed, double measured) {
  return 100.0 * (computed / measured - 1.0);
}

std::string as_csv(const std::vector<TankFigure>& figures, const Wigleys& wigleys) {
  Csv csv("hull,fn,quantity,abscissa,measured,ordinary,ordinary_miss_percent,modified,modified_miss_percent");
  for (const TankFigure& f : figures) {
    csv.add(wigley_numeral(f.hull)).add(f.fn).add(name_of(f.quantity)).add(f.abscissa).add(f.measured);
    for (const auto& hull : wigleys[static_cast<std::size_t>(f.hull - 1)]) {
      const double computed = computed_figure(*hull, f);
      csv.add(computed).add(miss_percent(computed, f.measured));
    }
    csv.end_row();
  }
  return csv.text();
}

std::string as_table(const std::vector<TankFigure>& figures, const Wigleys& wigleys) {
  std::string out = fmt::format("{:>4} {:>5} {:<17}{:>9}{:>10}{:>20}{:>20}\n", "hull", "fn", "quantity",
                                "abscissa", "measured", "ordinary", "modified");
  for (const TankFigure& f : figures) {
    out += fmt::format("{:>4} {:>5} {:<17}{:>9}{:>10}", wigley_numeral(f.hull), f.fn, name_of(f.quantity),
                       f.abscissa ? fmt::format("{:g}", *f.abscissa) : "largest", f.measured);
    for (const auto& hull : wigleys[static_cast<std::size_t>(f.hull - 1)]) {
      const double computed = computed_figure(*hull, f);
      out += fmt::format("{:>11.3f} {:>+6.0f} %", computed, miss_percent(computed, f.measured));
    }
    out += '\n';
  }
  return out;
}

void run(const Options& options) {
  const std::vector<TankFigure> figures = read_tank_file(options.with);
  const Wigleys wigleys = load_all(options.method.method());
  print_result(options.format == "csv" ? as_csv(figures, wigleys) : as_table(figures, wigleys));
}

}  // namespace

void add_wigley(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "wigley", "The Wigley hulls beside measured figures, by both methods, with the misses");
  const auto options = std::make_shared<Options>();
  command->add_option("--with", options->with, "CSV file of measured figures, see below")
      ->required()
      ->type_name("FILE");
  command->add_option("--format", options->format, "table or csv")
      ->check(CLI::IsMember({"table", "csv"}))
      ->capture_default_str()
      ->type_name("");
  add_method_options(*command, options->method);
  command->footer(
      "FILE: '#' begins a comment; columns hull (I ... IV), fn, quantity (a33, b33, b55, x3, x5, heave, "
      "pitch,\n"
      "added_resistance), abscissa, measured, all dimensionless as the header of the example says. --method "
      "is\n"
      "set aside: ordinary and modified are both printed.\n"
      "Example: quickstrip-hull wigley --with tests/golden/wigley_tank.csv");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
