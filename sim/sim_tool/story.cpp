// quickstrip-sim story LOG: a line per so many hours of what the advisor said.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "msgs/cli/list_option.hpp"
#include "msgs/convert/text.hpp"
#include "sim/replay/advice_log.hpp"
#include "sim/replay/advice_table.hpp"
#include "sim/sea_files/utc_time.hpp"
#include "sim/sim_tool/commands.hpp"

namespace quickstrip::sim_tool {
namespace {

struct Options {
  std::string log;
  std::string prefix = "QS_";
  double every_h = 24.0;
  bool csv = false;
};

std::string line_of(const RecordedAdvice& recorded) {
  const advice_t& advice = recorded.advice;
  const std::string sea =
      recorded.sea.systems.empty() ? std::string("sea -   ") : fmt::format("Hs {:4.1f} m", recorded.sea.hs_m);
  const std::string_view text =
      advice.no_advice != 0 ? get_text(advice.no_advice_text) : get_text(advice.reasons_text);
  return fmt::format("{}  {}  {:03.0f} {:4.1f} kn  {:<9}  {}", format_utc(advice.utime).substr(0, 16), sea,
                     advice.heading_deg, advice.speed_kn, verdict_word(advice), text);
}

void print_table(const Options& options) {
  fmt::print("{}", advice_table_header());
  require(read_advice_log(options.log, options.prefix, [](const RecordedAdvice& recorded) {
    fmt::print("{}", advice_table_line(recorded.advice, recorded.sea));
  }));
}

/// Of each span of time the worst advice speaks.
void run(const Options& options) {
  const auto span = static_cast<std::int64_t>(options.every_h * 3600e6);
  std::optional<std::int64_t> span_end;
  std::string worst_line;
  double worst = -2.0;
  int num = 0;
  int num_without = 0;
  const auto flush = [&] {
    if (num > 0) {
      fmt::print("{}{}\n", worst_line,
                 num_without == 0 ? std::string()
                                  : fmt::format("  [{} of {} cycles without advice]", num_without, num));
    }
    num = 0;
    num_without = 0;
    worst = -2.0;
  };
  require(read_advice_log(options.log, options.prefix, [&](const RecordedAdvice& recorded) {
    if (!span_end) {
      span_end = recorded.advice.utime + span;
    }
    if (recorded.advice.utime >= *span_end) {
      flush();
      *span_end += ((recorded.advice.utime - *span_end) / span + 1) * span;
    }
    ++num;
    num_without += recorded.advice.no_advice != 0 ? 1 : 0;
    if (badness(recorded) > worst) {
      worst = badness(recorded);
      worst_line = line_of(recorded);
    }
  }));
  flush();
}

}  // namespace

void add_story(CLI::App& app) {
  CLI::App* const command =
      app.add_subcommand("story", "What the advisor said: the worst advice of each day, a line each");
  const auto options = std::make_shared<Options>();
  command->add_option("LOG", options->log, "LCM log with advice")->required();
  add_number(*command, "--every-h", options->every_h, {0.001, 1e6}, "Hours a line")->default_str("24");
  command->add_flag("--csv", options->csv, "Every advice instead, a line of CSV each");
  command->add_option("--prefix", options->prefix, "Of the channel names")->capture_default_str();
  command->callback([options] { options->csv ? print_table(*options) : run(*options); });
}

}  // namespace quickstrip::sim_tool
