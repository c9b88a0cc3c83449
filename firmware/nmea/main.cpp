// quickstrip-nmea: NMEA 0183 gateway. Own ship and attitude from the bridge's sensors onto LCM. Exit 0 after
// SIGINT or SIGTERM or at the end of the files, 1 when a source or the bus is bad, 2 wrong use.
#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>

#include "firmware/nmea/run.hpp"
#include "firmware/nmea/sinks.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"

namespace {

using namespace quickstrip;
using namespace quickstrip::nmea;

std::atomic<bool> stop_asked{false};

struct Options {
  std::vector<std::string> udp;
  std::vector<std::string> serial;
  std::vector<std::string> file;
  std::string interface;
  int baud = 4800;
  std::string talkers{kDefaultTalkers};
  std::vector<std::string> invert;
  std::string clock = "system";
  std::string speed = "1";
  std::string url = "udpm://239.255.76.67:7667?ttl=0";  // this host only
  std::string prefix = "QS_";
  std::string out;
  double window_min = 20.0;
  RunOptions run;
  GatewayOptions gateway;
};

void add_source_options(CLI::App& app, Options& options) {
  app.add_option(
         "--udp", options.udp,
         "PORT[@ADDRESS]: UDP, multicast where ADDRESS is a group; plain lines or IEC 61162-450. Every "
         "option for a source may be given several times: the one given first is believed first")
      ->allow_extra_args(false);
  app.add_option("--interface", options.interface, "With --udp: our address that joins the groups");
  app.add_option("--serial", options.serial, "DEVICE[@BAUD]: serial line, 8 data bits, no parity")
      ->allow_extra_args(false);
  app.add_option("--baud", options.baud, "Of --serial without one of its own")->capture_default_str();
  app.add_option("--file", options.file,
                 "Lines from a file, - for standard input; a UTC time may stand before each line")
      ->allow_extra_args(false);
  app.add_option("--clock", options.clock,
                 "system: a reading is of the time it arrives; record: of the time before its line, and "
                 "QS_TIME is sent (an advisor with --clock log follows)")
      ->check(CLI::IsMember({"system", "record"}))
      ->capture_default_str();
  app.add_option("--speed", options.speed, "With --clock record: its seconds a second, or max")
      ->capture_default_str();
}

void add_reading_options(CLI::App& app, Options& options) {
  app.add_option("--talker", options.talkers,
                 "Talkers that are believed, of one source the first first; P: makers' own sentences")
      ->capture_default_str();
  app.add_flag("--allow-missing-checksum", options.gateway.reader.allow_missing_checksum,
               "For old gear; a wrong one is refused all the same");
  app.add_option("--invert", options.invert, "roll, pitch, heave: of a sensor that has them the other way")
      ->delimiter(',')
      ->check(CLI::IsMember({"roll", "pitch", "heave"}));
  add_number(app, "--transducer-depth-m", options.gateway.reader.transducer_depth_m, {0.0, 40.0},
             "Below the water line: for DPT without an offset to it, and DBT")
      ->default_str("0");
  add_number(app, "--stale-after-s", options.gateway.stale_after_s, {0.1, 60.0},
             "Age above which a quantity drops out")
      ->default_str("5");
  add_number(app, "--rate-hz", options.gateway.rate_hz, {0.1, 10.0}, "QS_OWN_SHIP at most so often")
      ->default_str("1");
  add_number(app, "--window-min", options.window_min, {1.0, 120.0}, "Of QS_MOTION")->default_str("20");
  add_number(app, "--motion-every-s", options.gateway.motion_every_s, {1.0, 3600.0}, "QS_MOTION so often")
      ->default_str("60");
}

void add_options(CLI::App& app, Options& options) {
  add_source_options(app, options);
  add_reading_options(app, options);
  app.add_option("--url", options.url, "LCM URL")->capture_default_str();
  app.add_option("--prefix", options.prefix, "Of the channel names")->capture_default_str();
  app.add_option("--out", options.out, "Into an LCM log instead of the bus");
  app.add_option("--source-id", options.gateway.source_id, "Of our messages")->capture_default_str();
  add_number(app, "--report-every-s", options.run.report_every_s, {0.1, 1e6}, "Counts to standard error")
      ->default_str("60");
}

/// In the order of the command line, whatever their kinds; then those of a configuration file, kind by kind.
std::vector<SourceSpec> sources_in_order(const CLI::App& app, const Options& options) {
  const std::map<std::string, std::pair<SourceKind, const std::vector<std::string>*>> kinds{
      {"--udp", {SourceKind::kUdp, &options.udp}},
      {"--serial", {SourceKind::kSerial, &options.serial}},
      {"--file", {SourceKind::kFile, &options.file}}};
  std::map<std::string, std::size_t> num_taken;
  std::vector<SourceSpec> specs;
  for (const CLI::Option* option : app.parse_order()) {
    const auto kind = kinds.find(option->get_name());
    if (kind != kinds.end()) {
      const std::string& where = kind->second.second->at(num_taken[kind->first]++);
      specs.push_back({kind->second.first, where, options.interface, options.baud});
    }
  }
  for (const char* const kind : {"--udp", "--serial", "--file"}) {
    const auto& [source_kind, places] = kinds.at(kind);
    for (std::size_t i = num_taken[kind]; i < places->size(); ++i) {
      specs.push_back({source_kind, places->at(i), options.interface, options.baud});
    }
  }
  if (specs.empty()) {
    throw CLI::ValidationError("quickstrip-nmea", "one of --udp, --serial and --file");
  }
  if (specs.size() > kMaxSources) {
    throw CLI::ValidationError("quickstrip-nmea", "at most 16 sources");
  }
  return specs;
}

void settle(Options& options) {
  if (!options.gateway.reader.talkers.set(options.talkers)) {
    throw CLI::ValidationError("--talker", options.talkers +
                                               ": GP,HE,... is right, at most 32 of two capitals or digits; "
                                               "P for makers' own");
  }
  for (const std::string& quantity : options.invert) {
    options.gateway.reader.invert_roll |= quantity == "roll";
    options.gateway.reader.invert_pitch |= quantity == "pitch";
    options.gateway.reader.invert_heave |= quantity == "heave";
  }
  options.gateway.window_s = options.window_min * 60.0;
  options.gateway.record_clock = options.clock == "record";
  options.run.record_clock = options.gateway.record_clock;
  if (options.speed != "max") {
    options.run.speed = parse_list("--speed", options.speed, {1e-3, 1e6}).front();
    options.gateway.record_speed = options.run.speed;
  }
}

void run_to(Sink& sink, std::vector<Source>& sources, const Options& options) {
  const auto gateway = std::make_unique<Gateway>(options.gateway, sources.size(), sink);
  run(sources, *gateway, options.run, stop_asked);
}

void run_all(const CLI::App& app, Options& options) {
  settle(options);
  std::vector<Source> sources;
  for (SourceSpec& spec : sources_in_order(app, options)) {
    sources.emplace_back(std::move(spec));
  }
  for (Source& source : sources) {
    require(source.open());
  }
  if (!options.out.empty()) {
    LcmLogWriter log;
    require(log.open(options.out));
    LogSink sink(log, options.prefix);
    run_to(sink, sources, options);
    require(sink.status());
    require(log.finish());
    return;
  }
  lcm::LCM bus(options.url);
  if (!bus.good()) {
    throw InputError{"--url: " + options.url + ": LCM cannot open it (udpm:// needs a multicast route)"};
  }
  BusSink sink(bus, options.prefix);
  std::fprintf(stderr, "quickstrip-nmea %s: %zu sources, to %s\n", QUICKSTRIP_VERSION, sources.size(),
               options.url.c_str());
  run_to(sink, sources, options);
}

}  // namespace

// Only an option named twice could throw outside run_tool(): at every start, so never on board.
int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape)
  std::signal(SIGINT, [](int) { stop_asked = true; });
  std::signal(SIGTERM, [](int) { stop_asked = true; });
  CLI::App app("NMEA 0183 gateway: heading, speed, position, depth and attitude from the bridge onto LCM",
               "quickstrip-nmea");
  app.set_version_flag("--version", "quickstrip-nmea " QUICKSTRIP_VERSION);
  Options options;
  add_options(app, options);
  add_config_option(app);
  return run_tool(app, argc, argv, [&] { run_all(app, options); });
}
