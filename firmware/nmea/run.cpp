#include "firmware/nmea/run.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <thread>

#include "msgs/convert/units.hpp"

namespace quickstrip::nmea {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kWait_ms = 20;  // how late a message may be that falls due in silence
constexpr std::chrono::milliseconds kPaceLook{20};

std::int64_t system_utime() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Holds a record back to its own speed.
class Pace {
 public:
  explicit Pace(double speed) : speed_(speed) {}
  [[nodiscard]] bool is_ahead(std::int64_t record_time) {
    if (speed_ <= 0.0 || record_time == 0) {
      return false;
    }
    if (first_ == 0) {
      first_ = record_time;
      start_ = Clock::now();
    }
    return seconds_between(first_, record_time) > speed_ * seconds_since(start_);
  }

 private:
  double speed_;
  std::int64_t first_ = 0;
  Clock::time_point start_;
};

/// The sources that have something to read; waits for one of them, but not long.
using Polls = std::array<pollfd, kMaxSources>;
void wait(const std::vector<Source>& sources, Polls& polls) {
  for (std::size_t i = 0; i < sources.size(); ++i) {
    polls[i] = {sources[i].fd(), POLLIN, 0};  // a negative one is passed over
  }
  static_cast<void>(poll(polls.data(), sources.size(), kWait_ms));
}

bool all_ended(const std::vector<Source>& sources) {
  return std::all_of(sources.begin(), sources.end(), [](const Source& source) { return source.has_ended(); });
}

}  // namespace

std::string report(const Gateway& gateway, std::int64_t now) {
  const GatewayCounts& counts = gateway.counts();
  std::string text =
      fmt::format("{:%Y-%m-%dT%H:%M:%SZ} {} lines: {} taken, {} not used; refused {}",
                  fmt::gmtime(static_cast<std::time_t>(now / 1'000'000)), counts.lines.lines(),
                  counts.lines.of(Fate::kTaken), counts.lines.of(Fate::kNotUsed), counts.lines.refused());
  const char* mark = ": ";
  for (std::size_t i = static_cast<std::size_t>(Fate::kEmpty) + 1; i < kNumFates; ++i) {
    if (const std::int64_t num = counts.lines.of(static_cast<Fate>(i)); num > 0) {
      text += fmt::format("{}{} {}", mark, num, kFateWords[i]);
      mark = ", ";
    }
  }
  return text + fmt::format(
                    "; sent {} own ship ({} with speed over ground only), {} motion; {} readings of second "
                    "sources disagreed",
                    counts.own_ships, counts.own_ships_over_ground, counts.motions,
                    gateway.num_disagreements());
}

void run(std::vector<Source>& sources, Gateway& gateway, const RunOptions& options,
         const std::atomic<bool>& stop) {
  Polls polls{};
  Pace pace(options.speed);
  Clock::time_point reported = Clock::now();
  while (!stop.load() && !all_ended(sources)) {
    if (options.record_clock && pace.is_ahead(gateway.record_time())) {
      std::this_thread::sleep_for(kPaceLook);
      continue;
    }
    wait(sources, polls);
    const std::int64_t now = system_utime();
    for (std::size_t i = 0; i < sources.size(); ++i) {
      if (polls[i].revents != 0) {
        sources[i].read(i, now, gateway);
      }
      sources[i].mend(now);
    }
    if (!options.record_clock) {
      gateway.turn(system_utime());
    }
    if (seconds_since(reported) >= options.report_every_s) {
      reported = Clock::now();
      std::fprintf(stderr, "%s\n", report(gateway, system_utime()).c_str());
    }
  }
  gateway.finish();
  std::fprintf(stderr, "%s\n", report(gateway, system_utime()).c_str());
}

}  // namespace quickstrip::nmea
