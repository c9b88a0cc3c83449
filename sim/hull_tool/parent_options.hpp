// The parent program on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "sim/hull_tool/strip_ship.hpp"
#include "sim/parent/parent_ship.hpp"

namespace quickstrip::hull_tool {

struct ParentChoice {
  std::string sections;                  // "close-fit", "frank", "lewis"; empty: not given
  std::string potentials = "encounter";  // "encounter", "wave"
  [[nodiscard]] bool is_given() const { return !sections.empty(); }
};

/// The option of that name for the sections, and --potentials.
void add_parent_choice(CLI::App& command, const std::string& name, ParentChoice& choice,
                       const std::string& description);

/// Throws InputError.
std::unique_ptr<ParentShip> load_parent(const StripOptions& options, const ParentChoice& choice);
/// With another method than the options'.
std::unique_ptr<ParentShip> load_parent(const StripOptions& options, const ParentChoice& choice,
                                        const StripMethod& method);

}  // namespace quickstrip::hull_tool
