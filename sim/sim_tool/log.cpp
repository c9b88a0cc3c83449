// quickstrip-sim log --sea FILE --voyage FILE --out LOG
#include <fmt/format.h>

#include <memory>

#include "msgs/cli/list_option.hpp"
#include "sim/replay/voyage_log.hpp"
#include "sim/sim_tool/commands.hpp"

namespace quickstrip::sim_tool {
namespace {

struct Options {
  std::string sea;
  std::string voyage;
  std::string out;
  VoyageLogOptions log;
};

void run(const Options& options) {
  SeaSeries sea;
  require(load_sea(options.sea, sea));
  Voyage voyage;
  require(read_voyage_file(options.voyage, voyage));
  LcmLogWriter log;
  require(log.open(options.out));
  VoyageLogFigures figures;
  require(write_voyage_log(sea, voyage, options.log, log, figures));
  require(log.finish());
  fmt::print("{}: {} wave spectra and {} own-ship messages, {:.1f} days\n", options.out, figures.num_spectra,
             figures.num_own_ship,
             static_cast<double>(voyage.end_utime - voyage.legs.front().from_utime) / 86400e6);
}

}  // namespace

void add_log(CLI::App& app) {
  CLI::App* const command = app.add_subcommand("log", "Makes the log of a voyage through a measured sea");
  const auto options = std::make_shared<Options>();
  command->add_option("--sea", options->sea, "Sea file, or ndbc:PREFIX of the five NDBC files")->required();
  command->add_option("--voyage", options->voyage, "Voyage file (courses and speeds)")->required();
  command->add_option("--out", options->out, "LCM log to write")->required();
  add_number(*command, "--own-ship-period-s", options->log.own_ship_period_s, {0.1, 3600.0},
             "Own ship every so many seconds; above the advisor's stale-after (10 s) own ship goes stale "
             "between messages")
      ->default_str("10");
  command->add_option("--prefix", options->log.prefix, "Of the channel names")->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::sim_tool
