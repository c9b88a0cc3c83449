// quickstrip-section-table: makes, checks and measures the table of section coefficients.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "core/strip/section_table.hpp"
#include "core/strip/section_table_data.hpp"
#include "sim/section_table/accuracy.hpp"
#include "sim/section_table/table_writer.hpp"

#include <unistd.h>

namespace quickstrip {
namespace {

GeneratedTable generate_with_progress() {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const GeneratedTable table = generate_table([terminal](double share) {
    if (terminal) {
      fmt::print(stderr, "\r{:3.0f} %", 100.0 * share);
    }
  });
  fmt::print(stderr, "{}{} coefficients, at most {} multipoles, {} nodes not converged\n",
             terminal ? "\r" : "", table.coefficients.size(), table.most_multipoles, table.not_converged);
  return table;
}

// Written beside, then renamed: a failed run leaves no half-written file.
int write(const std::string& path) {
  const GeneratedTable table = generate_with_progress();
  const std::string beside = path + ".part";
  {
    std::ofstream out(beside);
    write_table(table, out);
    if (!out.flush()) {
      fmt::print(stderr, "{}: cannot be written\n", beside);
      return 1;
    }
  }
  std::error_code error;
  std::filesystem::rename(beside, path, error);
  if (error) {
    fmt::print(stderr, "{}: {}\n", path, error.message());
    return 1;
  }
  return 0;
}

int check() {
  constexpr double kRounding = 1e-6;  // float, and another compiler's mathematics
  if (!section_table_is_intact()) {
    fmt::print(stderr, "section table: the checksum does not fit the data\n");
    return 1;
  }
  const GeneratedTable table = generate_with_progress();
  const double worst = largest_difference(table, section_table_data::kCoefficients);
  fmt::print("largest difference from the committed table: {:.2g}\n", worst);
  return worst <= kRounding ? 0 : 1;
}

int accuracy(int num_points) {
  fmt::print("section table version {}, checksum {:#018x}: {} numbers, {} bytes\n", section_table_version(),
             section_table_checksum(), section_table_numbers(), section_table_bytes());
  print_accuracy(measure_accuracy(SectionRegion::kPractical, num_points, 1), "practical", std::cout);
  print_accuracy(measure_accuracy(SectionRegion::kFull, num_points, 2), "bulbous, tunnelled", std::cout);
  print_times(std::cout);
  return 0;
}

}  // namespace
}  // namespace quickstrip

int main(int argc, char** argv) {
  CLI::App app("Makes, checks and measures the table of section coefficients that core holds");
  std::string path;
  bool do_check = false;
  int num_points = 0;
  app.add_option("--write", path, "compute the table and write it as C++ source to this file");
  app.add_flag("--check", do_check, "compute the table again and compare with the one compiled in");
  app.add_option("--accuracy", num_points,
                 "random points at which to compare table and direct solution, by spline and by Lagrange");
  app.require_option(1);
  app.set_version_flag("--version", "quickstrip-section-table 0.1.0");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (!path.empty()) {
    return quickstrip::write(path);
  }
  return do_check ? quickstrip::check() : quickstrip::accuracy(num_points);
}
