// quickstrip-hull mapping: how near the close-fit conformal mapping comes to every immersed section.
#include <cmath>
#include <memory>
#include <stdexcept>

#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/floating_hull.hpp"
#include "sim/parent/close_fit.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  std::string file;
  LoadingOptions loading;
  int num_coefficients = static_cast<int>(kMaxMappingCoefficients);
};

void add_fit(const SectionContour& contour, int num_coefficients, Csv& csv) {
  constexpr double kMillimetres = 1e3;
  constexpr double kPercent = 1e2;
  const CloseFit fit = close_fit(contour, num_coefficients);
  csv.add(static_cast<int>(fit.a.size()));
  if (fit.a.empty()) {
    csv.add("").add("").add("").add("").add("");
  } else {
    const double scale = error_scale(contour);
    csv.add(kMillimetres * fit.rms_error).add(kMillimetres * fit.largest_error);
    csv.add(kPercent * fit.rms_error / scale).add(kPercent * fit.largest_error / scale);
    csv.add(kPercent * fit.area_error);
  }
  csv.add(fit.is_conventional).add(fit.reason);
}

void run(const Options& options) {
  const auto ship = float_hull(options.file, options.loading);
  Csv csv(
      "x_m,coefficients,rms_error_mm,largest_error_mm,rms_error_percent,largest_error_percent,"
      "area_error_percent,conventional,reason");
  for (const ImmersedSection& section : ship->sections) {
    csv.add(section.x);
    try {
      add_fit(section_contour(section), options.num_coefficients, csv);
    } catch (const std::invalid_argument& refused) {
      csv.add(0).add("").add("").add("").add("").add("").add(false).add(refused.what());
    }
    csv.end_row();
  }
  print_result(csv.text());
}

}  // namespace

void add_mapping(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "mapping", "Close-fit conformal mapping of every immersed section, and how near it comes");
  const auto options = std::make_shared<Options>();
  add_hull_argument(*command, options->file);
  add_loading_options(*command, options->loading);
  command
      ->add_option("--coefficients", options->num_coefficients,
                   "most coefficients of the mapping, a1, a3 ... (2 ... 10)")
      ->check(CLI::Range(kLeastMappingCoefficients, static_cast<int>(kMaxMappingCoefficients)))
      ->capture_default_str()
      ->type_name("");
  command->footer(
      "coefficients: as many as give a conformal mapping; errors: distances of the contours, RMS along the\n"
      "section and the largest, in mm and by the root of half-breadth times draught. Where conventional is "
      "0\n"
      "the section goes to Frank's method, because of the reason given.");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
