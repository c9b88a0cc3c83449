// quickstrip-hull compile: the table of a hull's own sections that the advisor takes on board.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/files/hull_file.hpp"
#include "msgs/files/hull_table_file.hpp"
#include "sim/hull_table/compile_hull_table.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/floating_hull.hpp"

#include <unistd.h>

namespace quickstrip::hull_tool {
namespace {

constexpr double kFineSpacing = 0.06;  // of the draught (tests/hull_table/levels_test.cpp)

struct Options {
  std::string file;
  std::string sections = "close-fit";
  std::vector<double> draughts;
  std::vector<double> trims;
  std::string out;
};

HullSections sections_of(const std::string& name) {
  return name == "lewis"       ? HullSections::kLewis
         : name == "close-fit" ? HullSections::kCloseFit
                               : HullSections::kFrank;
}

CompiledLoadings loadings_of(const Options& options, const Hull& hull) {
  CompiledLoadings loadings = own_loadings(hull);
  if (!options.draughts.empty()) {
    loadings = {options.draughts, {0.0}};
  }
  if (!options.trims.empty()) {
    loadings.trims = options.trims;
  }
  return loadings;
}

CompiledHullTable compile_with_progress(const Options& options, const Hull& hull) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const auto progress = [terminal](double share) {
    if (terminal) {
      fmt::print(stderr, "\r{:3.0f} %", 100.0 * share);
    }
  };
  try {
    CompiledHullTable table =
        compile_hull_table(hull, sections_of(options.sections), loadings_of(options, hull), progress);
    fmt::print(stderr, "{}", terminal ? "\r" : "");
    return table;
  } catch (const std::invalid_argument& reason) {
    throw InputError{fmt::format("{}: {}", options.file, reason.what())};
  }
}

// Before the work, not after it.
void refuse_bad_name(const std::string& out) {
  const std::filesystem::path folder = std::filesystem::path(out).parent_path();
  std::error_code ignored;
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
    throw InputError{fmt::format("--out = {}: no folder of that name", out)};
  }
  if (std::filesystem::is_directory(out, ignored)) {
    throw InputError{fmt::format("--out = {}: a folder: the name of a file is wanted", out)};
  }
}

void tell(const Options& options, const Hull& hull, const CompiledHullTable& table) {
  print_result(fmt::format(
      "file,stations,levels_m,sections,flagged,by_another_method,bytes,checksum\n{},{},{:g},{},{},{},{},{:"
      "#018x}\n",
      options.out, hull.stations.size(), fmt::join(table.levels, " "), table.num_sections, table.num_flagged,
      table.num_other_method, 4 * table.words.size(), HullTable::view(table.words)->checksum()));
}

// What the user may want to do otherwise.
void tell_limits(const Options& options, const CompiledHullTable& table) {
  if (table.num_flagged > 0) {
    fmt::print(stderr, "note: {} of {} sections failed their own check of accuracy at a frequency\n",
               table.num_flagged, table.num_sections);
  }
  if (table.num_other_method > 0) {
    fmt::print(stderr, "note: not {} but another method at x_m = {:g}\n", options.sections,
               fmt::join(table.other_method_x, " "));
  }
  if (table.levels.size() == 1) {
    fmt::print(stderr, "note: one level: at any other draught Lewis forms stand in\n");
  }
  for (std::size_t i = 1; i < table.levels.size(); ++i) {
    const double step = table.levels[i] - table.levels[i - 1];
    if (step > kFineSpacing * table.levels[i]) {
      fmt::print(stderr,
                 "note: levels {:g} and {:g} m: farther apart than {:g} % of the draught, between them "
                 "interpolation "
                 "can err by more than 0.5 %\n",
                 table.levels[i - 1], table.levels[i], 100.0 * kFineSpacing);
      return;
    }
  }
}

void run(const Options& options) {
  const auto ship = std::make_unique<Hull>();
  require(read_hull_file(options.file, *ship));
  refuse_bad_name(options.out);
  const CompiledHullTable table = compile_with_progress(options, *ship);
  require(write_hull_table(table.words, options.out));
  tell(options, *ship, table);
  tell_limits(options, table);
}

}  // namespace

void add_compile(CLI::App& app) {
  CLI::App* const command =
      app.add_subcommand("compile", "Solves the hull's own sections and makes the table for --table");
  const auto options = std::make_shared<Options>();
  add_hull_argument(*command, options->file);
  command
      ->add_option("--sections", options->sections,
                   "lewis: forms of breadth, draught and area; close-fit: conformal mapping of the contour "
                   "(Frank's method where none fits); frank: pulsating sources")
      ->check(CLI::IsMember({"lewis", "close-fit", "frank"}))
      ->capture_default_str()
      ->type_name("");
  constexpr ListRange kDraughts_m{0.001, 100.0};
  constexpr ListRange kTrims_m{-50.0, 50.0};
  add_list(*command, "--draughts", options->draughts, kDraughts_m,
           "draughts amidships above base [m]; default: the file's own loading, trim too");
  add_list(*command, "--trims", options->trims, kTrims_m,
           "draught aft less draught forward [m]: levels are added for them at the ends; default 0");
  command->add_option("--out", options->out, "file to write")->required()->type_name("FILE");
  command->footer(
      "Loadings between the draughts are interpolated, outside them Lewis forms stand in, flagged. A "
      "spacing of 5 % of the draught keeps the interpolation within 0.5 %.");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
