// quickstrip-sim inspect LOG
#include "sim/replay/inspect.hpp"

#include <fmt/format.h>

#include <memory>

#include "sim/sim_tool/commands.hpp"

namespace quickstrip::sim_tool {

void add_inspect(CLI::App& app) {
  struct Options {
    std::string log;
    std::string prefix = "QS_";
  };
  CLI::App* const command =
      app.add_subcommand("inspect", "Channels, counts, times, gaps and damage of a log");
  const auto options = std::make_shared<Options>();
  command->add_option("LOG", options->log, "LCM log")->required();
  command->add_option("--prefix", options->prefix, "Of the channel names")->capture_default_str();
  command->callback([options] {
    LogFigures figures;
    require(inspect_log(options->log, options->prefix, figures));
    fmt::print("{}", inspection_text(figures));
  });
}

}  // namespace quickstrip::sim_tool
