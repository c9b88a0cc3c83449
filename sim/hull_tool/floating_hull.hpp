// A hull file read, cut at its waterline and floated: what most subcommands begin with.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/hull/hull.hpp"
#include "core/hull/hydrostatics.hpp"

namespace quickstrip::hull_tool {

struct FloatingHull {
  std::string file;
  Hull hull;  // as in the file; `hull.loading` is the file's
  Loading loading;
  ImmersedSections sections;
  Hydrostatics hydrostatics;
};

/// What the command line puts in place of the file's loading condition.
struct LoadingOptions {
  std::optional<double> draught_aft;
  std::optional<double> draught_fwd;
  std::optional<double> kg;
  [[nodiscard]] bool any() const { return draught_aft || draught_fwd || kg; }
};

/// The positional argument HULL.
void add_hull_argument(CLI::App& command, std::string& file);

/// --draught-aft-m, --draught-fwd-m, --kg-m.
void add_loading_options(CLI::App& command, LoadingOptions& options);

/// Reads, cuts, floats. A gm_m of the file does not survive another draught or kg: dropped, with a note on
/// standard error. Throws InputError.
std::unique_ptr<FloatingHull> float_hull(const std::string& file, const LoadingOptions& options = {});

/// The same from the text of a hull file; `file` is the name that refusals quote.
std::unique_ptr<FloatingHull> float_hull_text(std::string_view text, const std::string& file);

/// core's refusal as one line of file, field, value and what would be right.
std::string explain(Error error, const FloatingHull& ship, const LoadingOptions& options);

}  // namespace quickstrip::hull_tool
