#include "sim/replay/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "msgs/files/printable.hpp"
#include "sim/replay/cycle_times.hpp"
#include "sim/replay/event_stream.hpp"
#include "sim/replay/log_feed.hpp"
#include "sim/replay/pace.hpp"

namespace quickstrip {
namespace {

using Clock = std::chrono::steady_clock;
// After two days without an event every input is stale by its default, and more cycles would say it again.
constexpr std::int64_t kLongestGap_us = 2 * 86'400'000'000;

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
  EventStream events(log);
  LogEvent event;
  bool has_event = events.next(event);
  std::int64_t before = event.utime;  // of the event before
  while (has_event && outbox.failure.ok()) {
    const std::int64_t now = event.utime;
    const bool is_gap = now - before > kLongestGap_us;
    figures.num_gaps += is_gap ? 1u : 0u;
    const std::int64_t cycles_until = is_gap ? before + kLongestGap_us : now;
    while (const std::int64_t due = times.due_before(cycles_until)) {
      run_cycle(due);
    }
    before = now;
    bool has_input = false;
    for (; has_event && event.utime <= now; has_event = events.next(event)) {  // all events of one time
      ++figures.num_events;
      const Fed fed = feed->feed(event, now, session);
      figures.num_refused += fed == Fed::kRefused ? 1u : 0u;
      if (fed == Fed::kUnknown) {
        ++figures.num_unknown;
        ++figures.unknown_channels[event.channel];
      }
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
  figures.first_fault = log.faults().empty() ? std::string() : log.faults().front().line;
  figures.num_out_of_time = events.num_out_of_time();
  figures.num_out_of_order = events.num_out_of_order();
  return outbox.failure;
}

std::string remarks(const ReplayFigures& figures) {
  constexpr int kMaxNamed = 5;
  std::string text;
  if (figures.num_unknown > 0) {
    text += fmt::format("passed over, {} events on {} channels not ours:", figures.num_unknown,
                        figures.unknown_channels.size());
    int named = 0;
    for (const auto& [name, count] : figures.unknown_channels) {
      if (++named > kMaxNamed) {
        text += " ...";
        break;
      }
      text += fmt::format(" {} ({})", printable(name), count);
    }
    text += "\n";
  }
  if (figures.num_faults > 0) {
    text += fmt::format("passed over, {} damaged places; the first: {}\n", figures.num_faults,
                        figures.first_fault);
  }
  if (figures.num_out_of_time > 0) {
    text += fmt::format("passed over, {} events whose time is none or leaps ahead of what follows\n",
                        figures.num_out_of_time);
  }
  if (figures.num_out_of_order > 0) {
    text += fmt::format("{} events lie before the one before them: taken at that one's time\n",
                        figures.num_out_of_order);
  }
  if (figures.num_gaps > 0) {
    text +=
        fmt::format("{} gaps of more than two days: no cycles beyond two days of each\n", figures.num_gaps);
  }
  return text;
}

}  // namespace quickstrip
