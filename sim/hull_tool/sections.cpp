// quickstrip-hull sections: every immersed section and the Lewis form that stands for it in added mass and
// damping.
#include <memory>

#include "core/hull/lewis_section.hpp"
#include "msgs/cli/run_tool.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/floating_hull.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  std::string file;
  LoadingOptions loading;
};

// The class of the section as it is: the replaced form would always be called conventional.
const char* class_of(const ImmersedSection& section) {
  const auto own = lewis_section(section.breadth, section.draught, section.area);
  return own ? name_of(own->lewis_class) : "none";
}

void add_row(const ImmersedSection& section, const FloatingHull& ship, Csv& csv) {
  const auto used = hydrodynamic_lewis_section(section.breadth, section.draught, section.area);
  if (!used) {
    throw InputError{ship.file + ": station at x_m = " + number_text(section.x) + ": " +
                     message(used.error())};
  }
  csv.add(section.x).add(section.breadth).add(section.draught).add(section.area);
  csv.add(used->h0).add(used->sigma).add(used->a1).add(used->a3);
  csv.add(class_of(section)).add(used->replaced);
  csv.end_row();
}

void run(const Options& options) {
  const auto ship = float_hull(options.file, options.loading);
  Csv csv("x_m,breadth_m,draught_m,area_m2,h0,sigma,a1,a3,lewis_class,replaced");
  for (const ImmersedSection& section : ship->sections) {
    add_row(section, *ship, csv);
  }
  print_result(csv.text());
}

}  // namespace

void add_sections(CLI::App& app) {
  CLI::App* command = app.add_subcommand("sections", "Immersed sections and their Lewis forms, one row each");
  const auto options = std::make_shared<Options>();
  add_hull_argument(*command, options->file);
  add_loading_options(*command, options->loading);
  command->footer(
      "breadth, draught, area and lewis_class are those of the section (\"none\": no Lewis form); h0, sigma, "
      "a1 and "
      "a3 those of the form used for added mass and damping, another one where replaced is 1.");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
