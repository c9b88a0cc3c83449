// One function a subcommand, each in a file of its own. A function adds its subcommand with its options and
// sets the callback that runs it. Results go to standard output, messages to standard error; bad input throws
// InputError (exit 1), wrong use CLI11's own errors (exit 2).
#pragma once

#include "msgs/cli/run_tool.hpp"

namespace quickstrip::sim_tool {

void add_log(CLI::App& app);
void add_replay(CLI::App& app);
void add_inspect(CLI::App& app);
void add_simulate(CLI::App& app);
void add_story(CLI::App& app);
void add_picture(CLI::App& app);
void add_pilot(CLI::App& app);

}  // namespace quickstrip::sim_tool
