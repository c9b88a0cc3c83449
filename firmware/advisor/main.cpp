// quickstrip-advisor: the onboard process. Sea state, own ship and loading come over LCM; advice goes out
// each cycle. Exit 0 after SIGINT or SIGTERM, 1 when a file or the bus is bad, 2 wrong use.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>

#include "firmware/advisor/live.hpp"
#include "msgs/cli/method_options.hpp"
#include "msgs/files/ship_files.hpp"

namespace {

using namespace quickstrip;

constexpr int kBadInput = 1;
constexpr int kWrongUse = 2;

std::atomic<bool> stop_asked{false};

struct Options {
  std::string hull;
  std::string limits;
  std::string url = "udpm://239.255.76.67:7667?ttl=0";  // this host only
  std::string prefix = "QS_";
  std::string clock = "system";
  std::string state;
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
  app.add_option("--state", options.state, "File that keeps the last inputs over a restart");
  app.add_option("--cycle-s", options.session.cycle_period_s, "Cycle period")
      ->check(CLI::Range(0.01, 86400.0))
      ->capture_default_str();
  StaleAfter& stale = options.session.stale_after;
  app.add_option("--own-ship-stale-after-s", stale.own_ship_s, "Age above which there is no advice")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--sea-stale-after-s", stale.sea_s, "Likewise, of the sea")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--loading-stale-after-s", stale.loading_s, "Likewise, of a loading that was sent")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--source-id", options.session.source_id, "Of our messages")->capture_default_str();
  add_method_options(app, options.method);
}

int fail(const std::string& line) {
  fmt::print(stderr, "{}\n", line);
  return kBadInput;
}

std::int64_t wall_utime() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

int run(Options& options) {
  options.session.log_clock = options.clock == "log";
  options.session.method = options.method.method();
  const auto files = std::make_unique<ShipFiles>();
  if (const FileStatus status = read_ship_files(options.hull, options.limits, *files); !status) {
    return fail(status.line());
  }
  options.session.profile = files->profile;
  options.session.version = Name(QUICKSTRIP_VERSION);
  const auto session = std::make_unique<Session>();
  if (const Status status = session->configure(files->hull, files->criteria, options.session); !status) {
    return fail(refused_by_core(options.hull, status.error()));
  }
  std::unique_ptr<InputKeeper> keeper;
  if (!options.state.empty()) {
    int num_restored = 0;
    // With log time the age is judged when the first QS_TIME comes: everything passes here.
    const std::int64_t now = options.session.log_clock ? INT64_MAX : wall_utime();
    if (const FileStatus status = restore_inputs(options.state, options.prefix, now, *session, num_restored);
        !status) {
      return fail(status.line());
    }
    fmt::print(stderr, "{}: {} inputs restored\n", options.state, num_restored);
    keeper = std::make_unique<InputKeeper>(options.state, options.prefix);
  }
  lcm::LCM bus(options.url);
  if (!bus.good()) {
    return fail("--url: " + options.url + ": LCM cannot open it (udpm:// needs a multicast route)");
  }
  const auto live = std::make_unique<Live>(bus, options.prefix, *session, options.session, keeper.get());
  fmt::print(stderr, "quickstrip-advisor {}: {} on {}, clock {}, a cycle every {} s\n", QUICKSTRIP_VERSION,
             files->hull.name.view(), options.url, options.clock, options.session.cycle_period_s);
  if (!live->run(stop_asked)) {
    return fail("--url: " + options.url + ": LCM has failed");
  }
  fmt::print(stderr, "stopped\n");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, [](int) { stop_asked = true; });
  std::signal(SIGTERM, [](int) { stop_asked = true; });
  try {
    CLI::App app("Onboard seakeeping advisor: what the ship will do on every course and speed, each cycle",
                 "quickstrip-advisor");
    app.set_version_flag("--version", "quickstrip-advisor " QUICKSTRIP_VERSION);
    Options options;
    add_options(app, options);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return app.exit(error) == 0 ? 0 : kWrongUse;
    }
    return run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "quickstrip-advisor: %s\n", error.what());
    return kBadInput;
  }
}
