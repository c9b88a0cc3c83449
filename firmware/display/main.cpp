// quickstrip-display: the bridge picture in a browser, and what the officer enters. Exit 0 after SIGINT or
// SIGTERM, 1 when the bus, a file or the port is bad, 2 wrong use.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "firmware/display/bus_link.hpp"
#include "firmware/display/display.hpp"
#include "firmware/display/http_service.hpp"
#include "firmware/display/recorded_moment.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/files/ship_files.hpp"

namespace {

using namespace quickstrip;

constexpr std::chrono::milliseconds kLook{100};  // how long a stop may take
constexpr int kNice = 5;                         // the advisor on the same machine goes first

std::atomic<bool> stop_asked{false};

struct Options {
  std::string address = "127.0.0.1";
  int port = 8042;
  std::vector<std::string> hosts;
  std::vector<std::string> origins;
  std::string url = "udpm://239.255.76.67:7667?ttl=0";  // this host only
  std::string prefix = "QS_";
  std::int16_t source_id = 2;
  std::string hull;
  std::string log;
  std::string at;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--address", options.address, "To listen on; another than the loopback needs --allow-host")
      ->capture_default_str();
  app.add_option("--port", options.port, "0: any free one, told on standard output")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  app.add_option("--allow-host", options.hosts, "Name under which a browser may ask, beside the loopback's");
  app.add_option("--allow-origin", options.origins, "Another origin that may read and enter, http://HOST");
  app.add_option("--url", options.url, "LCM URL")->capture_default_str();
  app.add_option("--prefix", options.prefix, "Of the channel names")->capture_default_str();
  app.add_option("--source-id", options.source_id, "Of our messages")->capture_default_str();
  app.add_option("--hull", options.hull, "Hull file: loadings are checked against it as the advisor does");
  CLI::Option* const replay =
      app.add_option("--replay", options.log, "Shows a moment of an LCM log instead of the bus");
  app.add_option("--at", options.at, "The moment, as 2019-09-04T12:40Z; default the end of the log")
      ->needs(replay);
}

std::int64_t utime_now() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

void serve(const Options& options, Display& display, HttpService& service, const BusLink* bus) {
  if (!service.start(options.address, options.port)) {
    throw InputError{fmt::format("--port: {}:{}: cannot listen there (taken, or not an address of this host)",
                                 options.address, options.port)};
  }
  fmt::print("http://{}:{}/\n", options.address, service.port());
  std::fflush(stdout);
  while (!stop_asked.load()) {
    if (bus != nullptr && bus->has_failed()) {
      throw InputError{"--url: " + options.url + ": LCM has failed"};
    }
    display.turn(utime_now(), kLook);
  }
  service.stop();
  fmt::print(stderr, "stopped\n");
}

void run(const Options& options) {
  if (nice(kNice) == -1) {
    fmt::print(stderr, "priority not lowered\n");
  }
  const auto files = std::make_unique<ShipFiles>();
  if (!options.hull.empty()) {
    require(read_ship_files(options.hull, "", *files));
  }
  DisplayOptions of_display;
  of_display.source_id = options.source_id;
  of_display.hull = options.hull.empty() ? nullptr : &files->hull;
  of_display.is_recorded = !options.log.empty();
  of_display.start_id = random_token();
  GuardOptions guard;
  guard.hosts = options.hosts;
  guard.origins = options.origins;
  guard.token = random_token();
  if (of_display.is_recorded) {
    Display display(of_display, nullptr);
    require(put_recorded_moment(options.log, options.at, options.prefix, display));
    HttpService service(display, guard);
    serve(options, display, service, nullptr);
    return;
  }
  lcm::LCM bus(options.url);
  if (!bus.good()) {
    throw InputError{"--url: " + options.url + ": LCM cannot open it (udpm:// needs a multicast route)"};
  }
  BusLink* sender = nullptr;
  Display display(of_display, [&sender](std::string_view channel, std::span<const std::uint8_t> bytes) {
    return sender->send(channel, bytes);
  });
  BusLink link(bus, options.prefix, display.mailbox());
  sender = &link;
  HttpService service(display, guard);
  serve(options, display, service, &link);
}

}  // namespace

// Only an option named twice could throw outside run_tool(): at every start, so never on board.
int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape)
  std::signal(SIGINT, [](int) { stop_asked = true; });
  std::signal(SIGTERM, [](int) { stop_asked = true; });
  std::signal(SIGPIPE, SIG_IGN);
  CLI::App app("The advice on the bridge: one page in a browser, and manual entry of sea and loading",
               "quickstrip-display");
  app.set_version_flag("--version", "quickstrip-display " QUICKSTRIP_VERSION);
  Options options;
  add_options(app, options);
  add_config_option(app);
  return run_tool(app, argc, argv, [&options] { run(options); });
}
