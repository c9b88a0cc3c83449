// METHOD of the command line (contract §4): the choices that strip theory leaves open.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "core/strip/method.hpp"

namespace quickstrip {

/// Keep it alive until the callback has run: the options write into it.
struct MethodOptions {
  bool paper = false;
  std::optional<std::string> variant;
  std::optional<std::string> end_terms;
  std::optional<std::string> loads;
  std::optional<std::string> surge;
  std::optional<std::string> low_encounter;
  std::optional<std::string> swell_up;
  std::string table;  // a file; empty: Lewis forms

  /// --paper first, then what was named beside it; the defaults of StripMethod for the rest, but boundary
  /// values where a hull table was given.
  [[nodiscard]] StripMethod method() const;
};

/// --method ordinary|modified  --end-terms on|off  --loads haskind|classic|boundary-value  --surge
/// full|inertia-only
/// --low-encounter floor|paper  --swell-up onboard|off  --paper  --table FILE
void add_method_options(CLI::App& command, MethodOptions& options);

}  // namespace quickstrip
