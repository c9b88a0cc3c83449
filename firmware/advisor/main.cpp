// quickstrip-advisor: the onboard process. Sea state, own ship and loading come over LCM; advice goes out
// each cycle. Exit 0 after SIGINT or SIGTERM, 1 when a file or the bus is bad, 2 wrong use.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "firmware/advisor/live.hpp"
#include "firmware/advisor/real_time.hpp"
#include "firmware/advisor/standard_streams.hpp"
#include "msgs/cli/allow_source_option.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/method_options.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/limits_difference.hpp"
#include "msgs/files/hull_table_file.hpp"
#include "msgs/files/printable.hpp"
#include "msgs/files/ship_files.hpp"

namespace {

using namespace quickstrip;

std::atomic<bool> stop_asked{false};

struct Options {
  std::string hull;
  std::string limits;
  std::string url = "udpm://239.255.76.67:7667?ttl=0";  // this host only
  std::string prefix = "QS_";
  std::string clock = "system";
  std::string state;
  std::string author;
  int ensemble_per_cycle = -1;  // not given
  std::string real_time = "auto";
  LiveOptions live;
  SessionOptions session;
  MethodOptions method;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--hull", options.hull, "Hull file")->required();
  app.add_option("--limits", options.limits, "Limits file; default NORDFORSK 1987 for merchant ships");
  app.add_option("--url", options.url, "LCM URL")->capture_default_str();
  app.add_option("--prefix", options.prefix, "Of the channel names")->capture_default_str();
  app.add_option("--clock", options.clock, "system: this machine's; log: QS_TIME, one cycle for each")
      ->check(CLI::IsMember({"system", "log"}))
      ->capture_default_str();
  app.add_option("--state", options.state, "File that keeps the last inputs and limits over a restart");
  app.add_option("--author", options.author,
                 "Who chose the limits: for the logbook, when they are others than at the last start "
                 "(--state)")
      ->check([](const std::string& name) {
        const bool fits = name.size() < kMaxNameBytes && printable(name, name.size()) == name;
        return fits ? std::string() : fmt::format("a name of at most {} bytes is wanted", kMaxNameBytes - 1);
      });
  add_number(app, "--cycle-s", options.session.cycle_period_s, {0.01, 86400.0}, "Cycle period")
      ->default_str("1");
  app.add_option("--ensemble-per-cycle", options.ensemble_per_cycle,
                 "Members of the ensemble computed each cycle, 0 ... 16; default 4, by log time all")
      ->check(CLI::Range(0, static_cast<int>(kEnsembleMembers)));
  StaleAfter& stale = options.session.stale_after;
  constexpr ListRange kStaleAfter_s{0.001, 1e8};
  add_number(app, "--own-ship-stale-after-s", stale.own_ship_s, kStaleAfter_s,
             "Age above which there is no advice")
      ->default_str("10");
  add_number(app, "--sea-stale-after-s", stale.sea_s, kStaleAfter_s, "Likewise, of the sea")
      ->default_str("5400");
  add_number(app, "--loading-stale-after-s", stale.loading_s, kStaleAfter_s,
             "Likewise, of a loading that was sent")
      ->default_str("86400");
  add_allow_source_option(app, options.session.allowed);
  app.add_option("--realtime", options.real_time,
                 "Locked memory and SCHED_FIFO for the cycle. auto: what is permitted; on: or no start; off")
      ->check(CLI::IsMember({"auto", "on", "off"}))
      ->capture_default_str();
  app.add_option("--priority", options.live.priority, "SCHED_FIFO priority of the cycle")
      ->check(CLI::Range(1, 99))
      ->capture_default_str();
  app.add_option("--source-id", options.session.source_id, "Of our messages")->capture_default_str();
  add_method_options(app, options.method);
}

// The hull table is looked at where it is read: memory for the largest, whole before the first cycle.
std::array<std::uint32_t, kMaxHullTableBytes / sizeof(std::uint32_t)> table_words;
std::optional<HullTable> hull_table;

std::string levels(std::size_t count) {
  return fmt::format("{} level{}", count, count == 1 ? "" : "s");
}

/// Says which one it is, for the journal.
const HullTable* load_table(const std::string& file, const Hull& hull) {
  if (file.empty()) {
    return nullptr;
  }
  require(read_hull_table(file, hull, table_words, hull_table));
  tell("{}: hull table {:016x}, {} from {:g} to {:g} m; by {}", printable(file, 1000), hull_table->checksum(),
       levels(hull_table->num_levels()), hull_table->level(0),
       hull_table->level(hull_table->num_levels() - 1), provenance_text(*hull_table));
  return &*hull_table;
}

std::int64_t wall_utime() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

/// Says so on the bus and here when the limits are others than when the file was written.
void compare_limits(const Options& options, Session& session) {
  const auto before = std::make_unique<limits_t>();
  require(read_kept_limits(options.state, options.prefix, *before));
  if (before->num_criteria == 0 || before->digest == session.limits().digest) {
    return;
  }
  Sentence change;
  add_limits_difference(*before, session.limits(), change);
  session.note_limits_change(options.author, change.view());
  tell("limits changed by {}: {}", options.author.empty() ? "somebody who is not named" : options.author,
       change.view());
}

void run(Options& options) {
  keep_threads_small();
  options.session.log_clock = options.clock == "log";
  options.live.real_time = options.real_time == "on"    ? RealTime::kOn
                           : options.real_time == "off" ? RealTime::kOff
                                                        : RealTime::kAuto;
  options.session.method = options.method.method();
  constexpr std::size_t kMembersEachSecond = 4;  // all of them within four cycles, each within its life
  const std::size_t by_clock = options.session.log_clock ? kEnsembleMembers : kMembersEachSecond;
  options.session.ensemble_per_cycle =
      options.ensemble_per_cycle < 0 ? by_clock : static_cast<std::size_t>(options.ensemble_per_cycle);
  const auto files = std::make_unique<ShipFiles>();
  require(read_ship_files(options.hull, options.limits, *files));
  options.session.profile = files->profile;
  options.session.version = Name(QUICKSTRIP_VERSION);
  options.session.table = load_table(options.method.table, files->hull);
  const auto session = std::make_unique<Session>();
  const SelfTestItem failed = session->self_test(options.session.table, *std::make_unique<Hull>());
  if (const Status status = session->configure(files->hull, files->criteria, options.session); !status) {
    throw InputError{refused_by_core(options.hull, status.error())};
  }
  std::unique_ptr<InputKeeper> keeper;
  if (!options.state.empty()) {
    int num_restored = 0;
    // With log time the age is judged when the first QS_TIME comes: everything passes here.
    const std::int64_t now = options.session.log_clock ? INT64_MAX : wall_utime();
    require(restore_inputs(options.state, options.prefix, now, *session, num_restored));
    bool is_whole = true;
    require(look_at_state(options.state, options.prefix, is_whole));
    tell("{}: {} inputs restored{}", options.state, num_restored,
         is_whole ? "" : ": the file is damaged, nothing of it is used");
    compare_limits(options, *session);
    keeper = std::make_unique<InputKeeper>(options.state, options.prefix, session->limits());
  }
  lcm::LCM bus(options.url);
  if (!bus.good()) {
    throw InputError{"--url: " + options.url + ": LCM cannot open it (udpm:// needs a multicast route)"};
  }
  const auto live = std::make_unique<Live>(bus, options.prefix, *session, options.session, keeper.get());
  tell("self-test: {}{}", message(failed), failed == SelfTestItem::kNone ? "" : ": there will be no advice");
  tell("quickstrip-advisor {}: {} on {}, clock {}, a cycle every {} s", QUICKSTRIP_VERSION,
       files->hull.name.view(), options.url, options.clock, options.session.cycle_period_s);
  std::string why_not;
  if (!live->run(options.live, stop_asked, why_not)) {
    throw InputError{"--url: " + options.url + ": LCM has failed"};
  }
  if (!why_not.empty()) {
    throw InputError{"--realtime: on: " + why_not};
  }
  tell("stopped");
}

}  // namespace

// Only an option named twice could throw outside run_tool(): at every start, so never on board.
int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape)
  hold_standard_streams();
  std::signal(SIGINT, [](int) { stop_asked = true; });
  std::signal(SIGTERM, [](int) { stop_asked = true; });
  CLI::App app("Onboard seakeeping advisor: what the ship will do on every course and speed, each cycle",
               "quickstrip-advisor");
  app.set_version_flag("--version", "quickstrip-advisor " QUICKSTRIP_VERSION);
  Options options;
  add_options(app, options);
  add_config_option(app);
  return run_tool(app, argc, argv, [&options] { run(options); });
}
