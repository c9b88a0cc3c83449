// quickstrip-hull: ashore, everything about a hull file.
#include "msgs/cli/run_tool.hpp"
#include "sim/hull_tool/commands.hpp"

int main(int argc, char** argv) {
  CLI::App app("Checks a hull file and prints what Quickstrip computes from it", "quickstrip-hull");
  app.set_version_flag("--version", "quickstrip-hull " QUICKSTRIP_VERSION);
  app.require_subcommand(1);
  quickstrip::hull_tool::add_commands(app);
  return quickstrip::run_tool(app, argc, argv);
}
