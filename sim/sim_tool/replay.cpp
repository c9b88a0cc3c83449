// quickstrip-sim replay LOG --hull HULL [--speed X|max] [--out LOG2] [--csv FILE]
#include "sim/replay/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <vector>

#include "msgs/cli/allow_source_option.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/method_options.hpp"
#include "msgs/files/ship_files.hpp"
#include "sim/hull_tool/loaded_table.hpp"
#include "sim/replay/advice_table.hpp"
#include "sim/replay/publish.hpp"
#include "sim/replay/recorded_run.hpp"
#include "sim/sim_tool/commands.hpp"

namespace quickstrip::sim_tool {
namespace {

struct Options {
  std::vector<std::string> logs;
  std::string hull;
  std::string limits;
  std::string speed = "max";
  std::string out;
  std::string csv;
  std::string recorded = "check";
  bool publish = false;
  PublishOptions far;
  ReplayOptions replay;
  SessionOptions session;
  MethodOptions method;
};

/// CSV beside its name, then renamed; "-" is standard output; "" writes nothing.
class Table {
 public:
  explicit Table(std::string path) : path_(std::move(path)) {
    if (path_.empty() || path_ == "-") {
      return;
    }
    file_.open(path_ + ".part");
    if (!file_) {
      throw InputError{path_ + ": cannot be written"};
    }
  }
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;
  ~Table() {
    if (file_.is_open()) {  // not finished: a failed run leaves nothing
      file_.close();
      std::error_code ignored;
      std::filesystem::remove(path_ + ".part", ignored);
    }
  }
  void write(const std::string& text) {
    if (path_ == "-") {
      fmt::print("{}", text);
    } else if (file_.is_open()) {
      file_ << text;
    }
  }
  void finish() {
    if (!file_.is_open()) {
      return;
    }
    file_.close();
    std::error_code error;
    std::filesystem::rename(path_ + ".part", path_, error);
    if (!file_ || error) {
      throw InputError{path_ + ": cannot be written"};
    }
  }

 private:
  std::string path_;
  std::ofstream file_;
};

double factor(const std::string& speed) {
  if (speed == "max") {
    return 0.0;
  }
  return parse_list("--speed", speed, {1e-3, 1e6}).front();
}

/// The logs as they were given; of a folder, its logs in the order of their names (a recorder's are times).
std::vector<std::filesystem::path> log_paths(const Options& options) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& log : options.logs) {
    if (!std::filesystem::is_directory(log)) {
      paths.emplace_back(log);
      continue;
    }
    std::vector<std::filesystem::path> inside;
    for (const auto& entry : std::filesystem::directory_iterator(log)) {
      if (entry.path().extension() == ".log") {
        inside.push_back(entry.path());
      }
    }
    if (inside.empty()) {
      throw InputError{log + ": no *.log in this folder"};
    }
    std::sort(inside.begin(), inside.end());
    paths.insert(paths.end(), inside.begin(), inside.end());
  }
  return paths;
}

/// To a running advisor over LCM.
void run_published(Options options) {
  options.far.speed = factor(options.speed);
  options.far.prefix = options.replay.prefix;
  options.far.cycle_period_s = options.replay.cycle_period_s;
  LcmLogReader log;
  require(log.open(log_paths(options)));
  LcmLogWriter record;
  if (!options.out.empty()) {
    require(record.open(options.out));
  }
  PublishFigures figures;
  require(publish_log(log, options.far, options.out.empty() ? nullptr : &record, figures));
  if (!options.out.empty()) {
    require(record.finish());
  }
  fmt::print(stderr, "{} messages sent, {} cycles, {} messages received\n", figures.num_sent,
             figures.num_cycles, figures.num_answers);
}

void tell(const ReplayFigures& figures) {
  fmt::print(
      stderr,
      "{}{} events, {} cycles ({} without advice), {} refused, {} not ours, {} damaged places; {:.1f} s "
      "computing, slowest cycle {:.3f} s\n",
      remarks(figures), figures.num_events, figures.num_cycles, figures.num_without_advice,
      figures.num_refused, figures.num_unknown, figures.num_faults, figures.computing_s,
      figures.slowest_cycle_s);
}

/// Throws InputError at a difference.
void judge(const Options& options, const RecordedFigures& recorded) {
  if (options.recorded != "check") {
    return;
  }
  const std::uint64_t num_repeated = recorded.num_advice - recorded.num_beyond_log;
  fmt::print(stderr, "{} of {} recorded advice messages reproduced bit for bit, {} of {} grids{}\n",
             recorded.num_same_advice, num_repeated, recorded.num_same_grids, recorded.num_grids,
             recorded.num_beyond_log == 0
                 ? std::string()
                 : fmt::format("; {} more rest on inputs from before the log", recorded.num_beyond_log));
  if (num_repeated == 0) {
    throw InputError{options.logs.front() +
                     ": no recorded advice can be repeated: their inputs are not in the log"};
  }
  if (!recorded.first_difference.empty()) {
    throw InputError{fmt::format(
        "{}: first difference: {}; --recorded follow does not compare, ignore takes the inputs alone",
        options.logs.front(), recorded.first_difference)};
  }
}

void run(Options options) {
  options.replay.speed = factor(options.speed);
  options.session.method = options.method.method();
  options.session.cycle_period_s = options.replay.cycle_period_s;
  options.session.log_clock = true;
  RecordedAdvisor recorded_advisor;
  if (options.recorded != "ignore") {
    require(find_recorded_advisor(log_paths(options), options.replay.prefix, recorded_advisor));
  }
  if (recorded_advisor.has_advice) {
    options.session.cycle_period_s = recorded_advisor.cycle_period_s;
    options.session.source_id = recorded_advisor.source_id;
  }
  LcmLogReader log;
  require(log.open(log_paths(options)));
  const auto files = std::make_unique<ShipFiles>();
  require(read_ship_files(options.hull, options.limits, *files));
  options.session.profile = files->profile;
  options.session.version = Name(QUICKSTRIP_VERSION);
  const auto hull_table = hull_tool::load_table(options.method.table, files->hull);
  options.session.table = hull_tool::view_of(hull_table);
  const auto session = std::make_unique<Session>();
  const auto configure = [&] { return session->configure(files->hull, files->criteria, options.session); };
  if (const Status status = configure(); !status) {
    throw InputError{refused_by_core(options.hull, status.error())};
  }
  LcmLogWriter out;
  if (!options.out.empty()) {
    require(out.open(options.out));
  }
  Table table(options.csv);
  table.write(advice_table_header());
  ReplayFigures figures;
  RecordedFigures recorded;
  LcmLogWriter* const out_or_none = options.out.empty() ? nullptr : &out;
  const auto line = [&](std::int64_t) {
    table.write(advice_table_line(session->advice(), summary(*session->output())));
  };
  if (recorded_advisor.has_advice) {
    require(
        replay_recorded_run(log, *session, options.replay, configure, out_or_none, line, figures, recorded));
  } else {
    require(replay_log(log, *session, options.replay, out_or_none, line, figures));
  }
  if (!options.out.empty()) {
    require(out.finish());
  }
  table.finish();
  tell(figures);
  if (recorded_advisor.has_advice) {
    judge(options, recorded);
  }
}

}  // namespace

void add_replay(CLI::App& app) {
  CLI::App* const command = app.add_subcommand(
      "replay",
      "Runs the advisor over a log, at the log's time: the recorded cycles where the log holds advice, else "
      "one cycle per change of an input and per cycle period");
  const auto options = std::make_shared<Options>();
  command->add_option("LOG", options->logs, "LCM log; several, or a recorder's folder, are read as one")
      ->required();
  command->add_option("--hull", options->hull, "Hull file; computes here, by the live process's own code");
  command->add_flag(
      "--publish", options->publish,
      "Sends the inputs, with QS_TIME, to a running advisor (--clock log) instead of computing; at "
      "speed max in step with its answers");
  command->add_option("--url", options->far.url, "With --publish: LCM URL")->capture_default_str();
  command
      ->add_option(
          "--answer-s", options->far.answer_s,
          "With --publish at speed max: how long the first answer may take; later ones a tenth of it")
      ->capture_default_str();
  command->add_option("--limits", options->limits, "Limits file; default NORDFORSK 1987 for merchant ships");
  command
      ->add_option(
          "--recorded", options->recorded,
          "What to do with advice in the log (QS_ADVICE, lcm-logger's or our own). check: run the same "
          "cycles on the inputs that each advice names, compare advice and grids byte for byte, and exit "
          "1 at a difference; follow: the same cycles, not compared (another hull, other limits); "
          "ignore: as if the log held inputs alone")
      ->check(CLI::IsMember({"check", "follow", "ignore"}))
      ->capture_default_str();
  command->add_option("--speed", options->speed, "Log seconds a second, or max")->capture_default_str();
  command->add_option("--out", options->out, "LCM log of the inputs and of what the advisor says");
  command->add_option("--csv", options->csv, "One line per advice; - for standard output");
  add_number(*command, "--cycle-s", options->replay.cycle_period_s, {0.01, 86400.0},
             "Cycle period in log time; that of the recorded advisor where its cycles are followed")
      ->default_str("3600");
  StaleAfter& stale = options->session.stale_after;
  constexpr ListRange kStaleAfter_s{0.001, 1e8};
  add_number(*command, "--own-ship-stale-after-s", stale.own_ship_s, kStaleAfter_s,
             "Age above which there is no advice")
      ->default_str("10");
  add_number(*command, "--sea-stale-after-s", stale.sea_s, kStaleAfter_s, "Likewise, of the sea")
      ->default_str("5400");
  add_number(*command, "--loading-stale-after-s", stale.loading_s, kStaleAfter_s, "Likewise, of a loading")
      ->default_str("86400");
  command
      ->add_option("--ensemble-per-cycle", options->session.ensemble_per_cycle,
                   "Members of the ensemble computed each cycle, for QS_OUTLOOK")
      ->check(CLI::Range(std::size_t{0}, kEnsembleMembers))
      ->capture_default_str();
  add_allow_source_option(*command, options->session.allowed);
  command->add_option("--prefix", options->replay.prefix, "Of the channel names")->capture_default_str();
  add_method_options(*command, options->method);
  command->callback([options] {
    if (options->publish == !options->hull.empty()) {
      throw CLI::ValidationError("replay", "one of --hull HULL and --publish");
    }
    if (options->publish) {
      run_published(*options);
    } else {
      run(*options);
    }
  });
}

}  // namespace quickstrip::sim_tool
