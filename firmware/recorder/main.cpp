// quickstrip-recorder: everything on LCM into rotating logs with a disk quota. Exit 0 after SIGINT or
// SIGTERM, 1 when the folder or the bus is bad at the start, 2 wrong use.
#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <lcm/lcm-cpp.hpp>

#include "firmware/recorder/recorder.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"

namespace {

using namespace quickstrip;

std::atomic<bool> stop_asked{false};
constexpr int kWait_ms = 100;
constexpr int kMaxFailuresInRow = 10;
constexpr int kQueueCapacity = 4096;  // messages, while the disk takes its time
constexpr double kBytesPerMb = 1e6;

struct Options {
  std::string url = "udpm://239.255.76.67:7667?ttl=0";  // this host only
  RecorderOptions recorder;
  double segment_min = 60.0;
  double segment_mb = 256.0;
  double quota_mb = 8000.0;
  double report_every_s = 60.0;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--folder", options.recorder.folder, "Where the logs go; must exist")->required();
  app.add_option("--url", options.url, "LCM URL")->capture_default_str();
  app.add_option("--prefix", options.recorder.prefix, "Of the channels that are recorded")
      ->capture_default_str();
  add_number(app, "--segment-min", options.segment_min, {0.01, 1440.0}, "A new log after so many minutes")
      ->default_str("60");
  add_number(app, "--segment-mb", options.segment_mb, {0.2, 4000.0}, "And after so many MB")
      ->default_str("256");
  add_number(app, "--quota-mb", options.quota_mb, {0.4, 1e7}, "Of all logs together: the oldest make room")
      ->default_str("8000");
  add_number(app, "--flush-s", options.recorder.flush_s, {0.05, 60.0}, "What a power cut may lose")
      ->default_str("2");
  add_number(app, "--report-every-s", options.report_every_s, {0.1, 1e6}, "Counts to standard error")
      ->default_str("60");
}

std::int64_t system_utime() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

void report(const Recorder& recorder) {
  const RecorderCounts& counts = recorder.counts();
  std::fprintf(stderr, "%llu messages, %.1f MB, %llu lost; %llu logs begun, %llu deleted for the quota%s%s\n",
               static_cast<unsigned long long>(counts.messages),
               static_cast<double>(counts.bytes) / kBytesPerMb, static_cast<unsigned long long>(counts.lost),
               static_cast<unsigned long long>(counts.segments),
               static_cast<unsigned long long>(counts.deleted), recorder.trouble().empty() ? "" : "; ",
               recorder.trouble().c_str());
}

/// A prefix is no regular expression, which LCM takes channel names for.
std::string literal(const std::string& prefix) {
  std::string text;
  for (const char c : prefix) {
    const bool is_plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    if (!is_plain) {
      text.push_back('\\');
    }
    text.push_back(c);
  }
  return text;
}

void settle(Options& options) {
  if (options.quota_mb < 2.0 * options.segment_mb) {
    throw CLI::ValidationError("--quota-mb",
                               "at least twice --segment-mb, for the log that is being written");
  }
  options.recorder.segment_s = options.segment_min * 60.0;
  options.recorder.segment_bytes = static_cast<std::uint64_t>(options.segment_mb * kBytesPerMb);
  options.recorder.quota_bytes = static_cast<std::uint64_t>(options.quota_mb * kBytesPerMb);
  if (!std::filesystem::is_directory(options.recorder.folder)) {
    throw InputError{"--folder " + options.recorder.folder.string() + ": no such folder"};
  }
}

void run(Options& options) {
  settle(options);
  lcm::LCM bus(options.url);
  if (!bus.good()) {
    throw InputError{"--url: " + options.url + ": LCM cannot open it (udpm:// needs a multicast route)"};
  }
  Recorder recorder(options.recorder);
  bus.subscribeFunction<Recorder*>(
         literal(options.recorder.prefix) + ".*",
         [](const lcm::ReceiveBuffer* buffer, const std::string& channel, Recorder* to) {
           to->take(buffer->recv_utime, channel,
                    {static_cast<const std::uint8_t*>(buffer->data), buffer->data_size});
         },
         &recorder)
      ->setQueueCapacity(kQueueCapacity);
  std::fprintf(stderr, "quickstrip-recorder %s: %s to %s\n", QUICKSTRIP_VERSION, options.url.c_str(),
               options.recorder.folder.c_str());
  std::int64_t reported = system_utime();
  for (int failures = 0; !stop_asked.load();) {
    failures = bus.handleTimeout(kWait_ms) < 0 ? failures + 1 : 0;
    const std::int64_t now = system_utime();
    recorder.turn(now);
    if (failures >= kMaxFailuresInRow) {
      recorder.finish();
      throw InputError{"--url: " + options.url + ": LCM has failed"};
    }
    if (static_cast<double>(now - reported) >= options.report_every_s * 1e6) {
      reported = now;
      report(recorder);
    }
  }
  recorder.finish();
  report(recorder);
}

}  // namespace

// Only an option named twice could throw outside run_tool(): at every start, so never on board.
int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape)
  std::signal(SIGINT, [](int) { stop_asked = true; });
  std::signal(SIGTERM, [](int) { stop_asked = true; });
  CLI::App app("Records everything on LCM into rotating logs, from which any moment can be replayed",
               "quickstrip-recorder");
  app.set_version_flag("--version", "quickstrip-recorder " QUICKSTRIP_VERSION);
  Options options;
  add_options(app, options);
  add_config_option(app);
  return run_tool(app, argc, argv, [&options] { run(options); });
}
