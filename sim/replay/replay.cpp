#include "sim/replay/replay.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "sim/replay/cycle_times.hpp"
#include "sim/replay/log_feed.hpp"

namespace quickstrip {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Writes what a session sends into a log; nothing without one.
class LogOutbox : public Outbox {
 public:
  LogOutbox(LcmLogWriter* log, std::string prefix) : log_(log), prefix_(std::move(prefix)) {}
  bool send(OutChannel channel, std::span<const std::uint8_t> bytes) override {
    if (log_ == nullptr) {
      return true;
    }
    const std::string name = prefix_ + std::string(kOutChannelNames[static_cast<std::size_t>(channel)]);
    if (FileStatus status = log_->append(now, name, bytes); !status) {
      failure = status;
      return false;
    }
    return true;
  }
  std::int64_t now = 0;
  FileStatus failure;

 private:
  LcmLogWriter* log_;
  std::string prefix_;
};

/// Keeps log time from running ahead of the wall clock at the factor asked for.
class Pace {
 public:
  explicit Pace(double speed) : speed_(speed) {}
  void wait(std::int64_t now) {
    if (!(speed_ > 0.0)) {
      return;
    }
    first_ = first_ == 0 ? now : first_;
    const std::chrono::duration<double> offset(seconds_between(first_, now) / speed_);
    std::this_thread::sleep_until(start_ + std::chrono::duration_cast<Clock::duration>(offset));
  }

 private:
  double speed_;
  std::int64_t first_ = 0;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

FileStatus replay_log(LcmLogReader& log, Session& session, const ReplayOptions& options,
                      LcmLogWriter* log_out, const std::function<void(std::int64_t now)>& after_cycle,
                      ReplayFigures& figures) {
  const auto feed = std::make_unique<LogFeed>(options.prefix);
  LogOutbox outbox(log_out, options.prefix);
  CycleTimes times(options.cycle_period_s);
  Pace pace(options.speed);
  figures = {};
  const auto run_cycle = [&](std::int64_t now) {
    pace.wait(now);
    const Clock::time_point start = Clock::now();
    outbox.now = now;
    session.cycle(now, outbox);
    if (session.is_rebuild_due()) {
      session.rebuild();
    }
    times.has_run(session.inputs(), now);
    const double took_s = seconds_since(start);
    figures.computing_s += took_s;
    figures.slowest_cycle_s = std::max(figures.slowest_cycle_s, took_s);
    ++figures.num_cycles;
    figures.num_without_advice += session.advice().no_advice != 0 ? 1u : 0u;
    after_cycle(now);
  };
  LogEvent event;
  bool has_event = log.next(event);
  while (has_event && outbox.failure.ok()) {
    const std::int64_t now = event.utime;
    while (const std::int64_t due = times.due_before(now)) {
      run_cycle(due);
    }
    bool has_input = false;
    for (; has_event && event.utime <= now; has_event = log.next(event)) {  // all events of one time
      ++figures.num_events;
      const Fed fed = feed->feed(event, now, session);
      figures.num_refused += fed == Fed::kRefused ? 1u : 0u;
      figures.num_unknown += fed == Fed::kUnknown ? 1u : 0u;
      has_input = has_input || fed == Fed::kTaken;
      const bool is_kept = is_input(name_without_prefix(event.channel, options.prefix));
      if (log_out != nullptr && is_kept) {
        if (FileStatus status = log_out->append(now, event.channel, event.data); !status) {
          return status;
        }
      }
    }
    if (has_input && times.is_due(session.inputs(), now)) {
      run_cycle(now);
    }
  }
  figures.num_faults = log.num_faults();
  return outbox.failure;
}

}  // namespace quickstrip
