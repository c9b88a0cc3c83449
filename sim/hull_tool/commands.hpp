// One function a subcommand, each in a file of its own (check.cpp, ...). A function adds its subcommand with
// its options and sets the callback that runs it: results go to standard output through print_result
// (csv.hpp), messages to standard error; bad input throws InputError, wrong use CLI::ValidationError.
#pragma once

#include <CLI/CLI.hpp>

namespace quickstrip::hull_tool {

void add_check(CLI::App& app);
void add_hydrostatics(CLI::App& app);
void add_sections(CLI::App& app);
void add_coefficients(CLI::App& app);
void add_hydrodynamics(CLI::App& app);
void add_motions(CLI::App& app);
void add_roll_damping(CLI::App& app);
void add_parent(CLI::App& app);
void add_validate(CLI::App& app);
void add_times(CLI::App& app);
void add_responses(CLI::App& app);
void add_grid(CLI::App& app);
void add_zones(CLI::App& app);
void add_compare(CLI::App& app);
void add_transform(CLI::App& app);
void add_parametric(CLI::App& app);
void add_mapping(CLI::App& app);
void add_tank(CLI::App& app);
void add_section(CLI::App& app);
void add_compile(CLI::App& app);
void add_frequencies(CLI::App& app);

/// Every subcommand, in the order of the help text.
inline void add_commands(CLI::App& app) {
  add_check(app);
  add_hydrostatics(app);
  add_sections(app);
  add_coefficients(app);
  add_hydrodynamics(app);
  add_motions(app);
  add_roll_damping(app);
  add_parent(app);
  add_validate(app);
  add_times(app);
  add_responses(app);
  add_grid(app);
  add_zones(app);
  add_compare(app);
  add_transform(app);
  add_parametric(app);
  add_mapping(app);
  add_tank(app);
  add_section(app);
  add_compile(app);
  add_frequencies(app);
}

}  // namespace quickstrip::hull_tool
