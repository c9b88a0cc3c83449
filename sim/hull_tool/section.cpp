// quickstrip-hull section: a cylinder at the surface beside figures of others, by any section method.
#include <fmt/format.h>

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "msgs/cli/run_tool.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/measured_file.hpp"
#include "sim/hull_tool/section_figures.hpp"
#include "sim/parent/true_section.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  std::string contour;
  std::string with;
  std::string model;
  std::string sections = "frank";
};

const std::map<std::string, SectionMethod> kMethods = {{"lewis", SectionMethod::kLewis},
                                                       {"close-fit", SectionMethod::kCloseFit},
                                                       {"frank", SectionMethod::kFrank}};

TrueSection section_of(const Options& options, const SectionContour& contour) {
  try {
    return {contour, kMethods.at(options.sections)};
  } catch (const std::invalid_argument& error) {
    throw InputError{fmt::format("{}: {}", options.contour, error.what())};
  }
}

void run(const Options& options) {
  const SectionContour contour = read_contour_file(options.contour);
  if (contour.is_submerged()) {
    throw InputError{options.contour + ": ends under water: a section of the surface is wanted"};
  }
  const auto figures =
      read_section_figures(options.with, options.model.empty() ? file_stem(options.contour) : options.model);
  const TrueSection section = section_of(options, contour);
  if (section.method() != kMethods.at(options.sections)) {
    fmt::print(stderr, "{}: solved by {}\n", options.contour, name_of(section.method()));
  }
  Csv csv("sections,quantity,abscissa,measured,computed,miss_percent");
  for (const SectionFigure& figure : figures) {
    const SectionFlow flow = section.flow(wave_number_of(contour, figure));
    const double computed = computed_figure(contour, flow, figure.quantity);
    if (!flow.is_converged) {
      fmt::print(stderr, "{} at {}: the solution's own check failed\n", name_of(figure.quantity),
                 number_text(figure.abscissa));
    }
    csv.add(name_of(section.method())).add(name_of(figure.quantity));
    csv.add(figure.abscissa).add(figure.measured).add(computed);
    csv.add(100.0 * (computed / figure.measured - 1.0));
    csv.end_row();
  }
  print_result(csv.text());
}

}  // namespace

void add_section(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "section", "A cylinder's added mass, damping and beam-wave loads beside figures of others");
  const auto options = std::make_shared<Options>();
  command->add_option("CONTOUR", options->contour, "CSV file of the half contour: y_m, z_m, see below")
      ->required()
      ->type_name("");
  command->add_option("--with", options->with, "CSV file of figures, see below")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--model", options->model,
                   "which lines of FILE, by its column section; default: CONTOUR's name up to the first dot")
      ->type_name("NAME");
  command->add_option("--sections", options->sections, "lewis, close-fit or frank")
      ->check(CLI::IsMember({"lewis", "close-fit", "frank"}))
      ->capture_default_str()
      ->type_name("");
  command->footer(
      "CONTOUR: from the keel to the waterline, z from the waterline, up. FILE: columns quantity (a22 ... "
      "b44, x2, "
      "f2,\n"
      "f3, x4), abscissa omega sqrt(B/2g), measured, and perhaps section; normalised as the header of the "
      "example "
      "says.\n"
      "Example: quickstrip-hull section sim/validation/data/circle.contour.csv --with "
      "sim/validation/data/cylinders.csv");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
