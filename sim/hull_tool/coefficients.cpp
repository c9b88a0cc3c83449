// quickstrip-hull coefficients: added mass and damping of Lewis sections, from the table or from the direct
// solution that the table was made with.
#include "sim/hull_tool/coefficients.hpp"

#include <fmt/format.h>

#include <memory>

#include "core/hull/lewis_section.hpp"
#include "core/strip/section_table.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/section_table/multipole_solver.hpp"

namespace quickstrip::hull_tool {
namespace {

LewisSection section_of(double h0, double sigma) {
  const auto section = lewis_section(2.0 * h0, 1.0, 2.0 * h0 * sigma);
  const double lowest = reentrant_limit(h0);
  const double highest = upper_limit(h0);
  if (!section || !(sigma >= lowest)) {
    throw InputError{fmt::format("--sigma {}: at --h0 {} Lewis sections have sigma {:.4f} ... {:.4f}",
                                 number_text(sigma), number_text(h0), lowest, highest)};
  }
  return *section;
}

void add_row(double h0, double sigma, double xi, const SectionCoefficients& c, Csv& csv) {
  csv.add(h0).add(sigma).add(xi);
  csv.add(c.a22).add(c.b22).add(c.a33).add(c.b33).add(c.a44).add(c.b44).add(c.a24).add(c.b24);
  csv.end_row();
}

void add_section(double h0, double sigma, const CoefficientOptions& options, Csv& csv) {
  const LewisSection section = section_of(h0, sigma);
  const auto column = section_table_column(h0, sigma);
  if (options.source == CoefficientSource::kTable && !column) {
    throw InputError{
        fmt::format("--h0 {} --sigma {}: {}", number_text(h0), number_text(sigma), message(column.error()))};
  }
  for (const double xi : options.xi) {
    if (options.source == CoefficientSource::kTable) {
      add_row(h0, sigma, xi, section_coefficients(*column, xi), csv);
      continue;
    }
    const SectionSolution solution =
        solve_lewis_form_adaptive(section.a1, section.a3, kappa_of_xi(section, xi));
    if (!solution.converged) {
      fmt::print(stderr, "--h0 {} --sigma {} --xi {}: not converged to 1e-4 at {} multipoles\n",
                 number_text(h0), number_text(sigma), number_text(xi), solution.num_multipoles);
    }
    add_row(h0, sigma, xi, normalised(section, xi, solution), csv);
  }
}

}  // namespace

std::string coefficients_csv(const CoefficientOptions& options) {
  Csv csv("h0,sigma,xi,a22,b22,a33,b33,a44,b44,a24,b24");
  for (const double h0 : options.h0) {
    for (const double sigma : options.sigma) {
      add_section(h0, sigma, options, csv);
    }
  }
  return csv.text();
}

void add_coefficients(CLI::App& app) {
  // Above and below, the direct solution is neither tested nor tabulated.
  constexpr ListRange kXiRange{1e-6, 1e3};
  CLI::App* command =
      app.add_subcommand("coefficients", "Added mass and damping of Lewis sections, deep water");
  const auto options = std::make_shared<CoefficientOptions>();
  add_list(*command, "--h0", options->h0, {kMinTabulatedH0, kMaxTabulatedH0}, "breadth / (2 draught)")
      ->required();
  add_list(*command, "--sigma", options->sigma, {0.01, 10.0}, "area / (breadth draught)")->required();
  add_list(*command, "--xi", options->xi, kXiRange, "omega^2 breadth / 2g")->required();
  const auto source = std::make_shared<std::string>("table");
  command->add_option("--source", *source, "table (as on board) or direct (multipole solution)")
      ->check(CLI::IsMember({"table", "direct"}))
      ->capture_default_str();
  command->footer(
      "Normalised: a22, a33 by rho A; a24 by rho A B; a44 by rho A B^2; b the same times sqrt(B/2g). About "
      "the "
      "waterline and the centre plane, z up.");
  command->callback([options, source] {
    refuse_too_many("--h0, --sigma, --xi", {options->h0.size(), options->sigma.size(), options->xi.size()});
    options->source = *source == "direct" ? CoefficientSource::kDirect : CoefficientSource::kTable;
    print_result(coefficients_csv(*options));
  });
}

}  // namespace quickstrip::hull_tool
