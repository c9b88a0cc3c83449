// quickstrip-sim picture LOG --out PNG [--at TIME]
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>

#include "msgs/convert/units.hpp"
#include "sim/picture/gnuplot.hpp"
#include "sim/picture/polar_picture.hpp"
#include "sim/replay/advice_log.hpp"
#include "sim/sea_files/utc_time.hpp"
#include "sim/sim_tool/commands.hpp"

namespace quickstrip::sim_tool {
namespace {

struct Options {
  std::string log;
  std::string out;
  std::string at;
  std::string prefix = "QS_";
};

void run(const Options& options) {
  const std::optional<std::int64_t> at = options.at.empty() ? std::nullopt : parse_utc(options.at);
  if (!options.at.empty() && !at) {
    throw CLI::ValidationError("--at", options.at + ": a time is written 2019-09-04T12:40Z");
  }
  const auto best = std::make_unique<RecordedAdvice>();
  double best_score = -std::numeric_limits<double>::infinity();
  require(read_advice_log(options.log, options.prefix, [&](const RecordedAdvice& recorded) {
    const double score = at ? -std::abs(seconds_between(recorded.advice.utime, *at)) : badness(recorded);
    if (score > best_score) {
      best_score = score;
      *best = recorded;
    }
  }));
  PolarPicture picture;
  picture.time = format_utc(best->advice.utime).substr(0, 10) + "  " +
                 format_utc(best->advice.utime).substr(11, 5) + " UTC";
  picture.hs_m = best->sea.hs_m;
  for (const SummedSystem& system : best->sea.systems) {
    picture.waves.push_back({system.hs_m, system.tp_s, system.dir_from_deg});
  }
  picture.advice = best->advice;
  picture.grid = best->grid;
  picture.limits = best->limits;
  require(draw_with_gnuplot([&](const std::string& png) { return polar_script(picture, png); }, options.out));
  fmt::print("{}: {}\n", options.out, picture.time);
}

}  // namespace

void add_picture(CLI::App& app) {
  CLI::App* const command =
      app.add_subcommand("picture", "Draws the polar of one advice: the worst of the log, or at a time");
  const auto options = std::make_shared<Options>();
  command->add_option("LOG", options->log, "LCM log with advice and grid")->required();
  command->add_option("--out", options->out, "PNG to write")->required();
  command->add_option("--at", options->at, "The advice nearest to this time, as 2019-09-04T12:40Z");
  command->add_option("--prefix", options->prefix, "Of the channel names")->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::sim_tool
