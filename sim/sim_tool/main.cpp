// quickstrip-sim: makes, replays and inspects LCM logs, and draws what they say.
#include "msgs/cli/run_tool.hpp"
#include "sim/sim_tool/commands.hpp"

int main(int argc, char** argv) {
  CLI::App app("Makes, replays and inspects LCM logs of the sea, the ship and the advice", "quickstrip-sim");
  app.set_version_flag("--version", "quickstrip-sim " QUICKSTRIP_VERSION);
  app.require_subcommand(1);
  quickstrip::sim_tool::add_log(app);
  quickstrip::sim_tool::add_replay(app);
  quickstrip::sim_tool::add_inspect(app);
  quickstrip::sim_tool::add_simulate(app);
  quickstrip::sim_tool::add_story(app);
  quickstrip::sim_tool::add_picture(app);
  quickstrip::sim_tool::add_pilot(app);
  return quickstrip::run_tool(app, argc, argv);
}
