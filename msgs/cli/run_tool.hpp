// How a program of ours ends. Exit 0 done, 1 the input or the data is bad (one line on standard error that
// names file, field, value and what would be right), 2 wrong use (CLI11's own words).
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "msgs/files/file_status.hpp"

namespace quickstrip {

/// What stops a command: bad input or data. Wrong use is CLI11's own ParseError.
struct InputError {
  std::string line;
};

/// Throws InputError when reading or writing a file has failed.
void require(const FileStatus& status);

/// Adds --config FILE: every option of the program by its name, as TOML (`cycle-s = 0.5`). What the command
/// line says wins; a key that is no option is refused.
void add_config_option(CLI::App& app);

/// Parses, which runs the callbacks of the subcommands, then `run`, if given. Returns the exit status;
/// nothing is thrown.
int run_tool(CLI::App& app, int argc, char** argv, const std::function<void()>& run = {});

}  // namespace quickstrip
