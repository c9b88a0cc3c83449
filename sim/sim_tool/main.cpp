// quickstrip-sim: makes, replays and inspects LCM logs, and draws what they say. Exit 0 done, 1 the input is
// bad, 2 wrong use.
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "sim/sim_tool/commands.hpp"

namespace {

constexpr int kBadInput = 1;
constexpr int kWrongUse = 2;

int run(int argc, char** argv) {
  CLI::App app("Makes, replays and inspects LCM logs of the sea, the ship and the advice", "quickstrip-sim");
  app.set_version_flag("--version", "quickstrip-sim " QUICKSTRIP_VERSION);
  app.require_subcommand(1);
  quickstrip::sim_tool::add_log(app);
  quickstrip::sim_tool::add_replay(app);
  quickstrip::sim_tool::add_inspect(app);
  quickstrip::sim_tool::add_story(app);
  quickstrip::sim_tool::add_picture(app);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kWrongUse;  // help and version end here too, with 0
  } catch (const quickstrip::sim_tool::InputError& error) {
    fmt::print(stderr, "{}\n", error.line);
    return kBadInput;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {  // memory, locale: nothing of ours
    std::fprintf(stderr, "quickstrip-sim: %s\n", error.what());
    return kBadInput;
  }
}
