#include "sim/replay/recorded_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "msgs/convert/encode.hpp"
#include "msgs/convert/units.hpp"
#include "sim/replay/advice_difference.hpp"
#include "sim/replay/event_stream.hpp"
#include "sim/replay/log_feed.hpp"
#include "sim/replay/pace.hpp"

namespace quickstrip {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kMaxWaiting = 4096;  // messages of one channel that no advice has named yet
// A message that came this shortly before a cycle may or may not have been taken by it.
constexpr std::int64_t kTakenBefore_us = 5000;

/// The three fields that every type begins with (contract §5), after the eight bytes of its fingerprint.
UsedInput header_of(const std::vector<std::uint8_t>& bytes) {
  UsedInput header{InputUse::kLive, 0, 0, 0};
  if (bytes.size() < 22) {
    return header;
  }
  const auto big_endian = [&bytes](std::size_t from, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = from; i < from + count; ++i) {
      value = (value << 8u) | bytes[i];
    }
    return value;
  };
  header.utime = static_cast<std::int64_t>(big_endian(8, 8));
  header.seq = static_cast<std::int32_t>(static_cast<std::uint32_t>(big_endian(16, 4)));
  header.source_id = static_cast<std::int16_t>(static_cast<std::uint16_t>(big_endian(20, 2)));
  return header;
}

bool is_same_message(const UsedInput& a, const UsedInput& b) {
  return a.source_id == b.source_id && a.seq == b.seq && a.utime == b.utime;
}

struct Heard {
  LogEvent event;
  UsedInput header;
};

/// What the log has brought on one input channel.
struct Channel {
  std::string_view name;
  Input input;
  std::deque<Heard> waiting{};   // heard, and not known to be taken by a cycle
  std::optional<Heard> taken{};  // the one in force: for a restart that reads it from disk
};

/// Keeps a cycle's advice and grid, and writes all that it sends into a log, if there is one.
class KeepingOutbox : public Outbox {
 public:
  KeepingOutbox(LcmLogWriter* log, std::string prefix) : log_(log), prefix_(std::move(prefix)) {}
  bool send(OutChannel channel, std::span<const std::uint8_t> bytes) override {
    if (is_silent) {
      return true;
    }
    if (channel == OutChannel::kAdvice) {
      advice.assign(bytes.begin(), bytes.end());
    } else if (channel == OutChannel::kGrid) {
      grid.assign(bytes.begin(), bytes.end());
    }
    if (log_ != nullptr && failure.ok()) {
      failure = log_->append(
          log_utime, prefix_ + std::string(kOutChannelNames[static_cast<std::size_t>(channel)]), bytes);
    }
    return failure.ok();
  }
  bool is_silent = false;
  std::int64_t log_utime = 0;
  std::vector<std::uint8_t> advice;
  std::vector<std::uint8_t> grid;
  FileStatus failure;

 private:
  LcmLogWriter* log_;
  std::string prefix_;
};

class RecordedRun {
 public:
  RecordedRun(Session& session, const ReplayOptions& options, const std::function<Status()>& configure,
              LcmLogWriter* log_out, const std::function<void(std::int64_t)>& after_cycle,
              ReplayFigures& figures, RecordedFigures& recorded)
      : session_(session),
        options_(options),
        configure_(configure),
        log_out_(log_out),
        after_cycle_(after_cycle),
        figures_(figures),
        recorded_(recorded),
        feed_(options.prefix),
        outbox_(log_out, options.prefix),
        pace_(options.speed) {}

  FileStatus take(const LogEvent& event) {
    ++figures_.num_events;
    const std::string_view name = name_without_prefix(event.channel, options_.prefix);
    if (name.empty()) {
      ++figures_.num_unknown;
      ++figures_.unknown_channels[event.channel];
    } else if (is_input(name)) {
      note_input(event, name);
      if (log_out_ != nullptr) {
        if (FileStatus status = log_out_->append(event.utime, event.channel, event.data); !status) {
          return status;
        }
      }
    } else if (name == "ADVICE") {
      if (decode(event.data, advice_) && is_time(advice_.utime)) {
        if (advice_.seq != last_seq_ || advice_.utime != last_utime_) {  // else a recorder's repeat
          follow(event);
        }
      } else {
        ++figures_.num_refused;
      }
    } else if (name == "GRID") {
      compare_grid(event);
    }
    return outbox_.failure;
  }

 private:
  void note_input(const LogEvent& event, std::string_view name) {
    if (name == "TIME") {
      time_mark_ = {header_of(event.data).utime, event.number};
      return;
    }
    for (Channel& channel : channels_) {
      if (channel.name == name) {
        channel.waiting.push_back({event, header_of(event.data)});
        if (channel.waiting.size() > kMaxWaiting) {
          channel.waiting.pop_front();
        }
      }
    }
  }

  void follow(const LogEvent& event) {
    ++recorded_.num_advice;
    has_followed_ = false;
    if (advice_.seq <= last_seq_ && !restart()) {
      return;
    }
    last_seq_ = advice_.seq;
    last_utime_ = advice_.utime;
    const bool is_repeatable = take_inputs(event);
    last_advice_ = event.number;
    if (!is_repeatable) {
      ++recorded_.num_beyond_log;
      return;
    }
    pace_.wait(event.utime);
    settle_loading();
    session_.number_next_cycle(advice_.seq);
    outbox_.log_utime = event.utime;
    run_cycle();
    has_followed_ = true;
    compare_advice(event);
    after_cycle_(advice_.utime);
  }

  void run_cycle() {
    const Clock::time_point start = Clock::now();
    session_.cycle(advice_.utime, outbox_);
    if (session_.is_rebuild_due()) {
      session_.rebuild();
    }
    if (outbox_.is_silent) {
      return;
    }
    const double took_s = std::chrono::duration<double>(Clock::now() - start).count();
    figures_.computing_s += took_s;
    figures_.slowest_cycle_s = std::max(figures_.slowest_cycle_s, took_s);
    ++figures_.num_cycles;
    figures_.num_without_advice += session_.advice().no_advice != 0 ? 1u : 0u;
  }

  /// A recorded advisor that was started again: so is the session. False when that fails.
  bool restart() {
    for (Channel& channel : channels_) {
      std::erase_if(channel.waiting, [this](const Heard& h) { return h.event.number < last_advice_; });
    }
    return configure_().ok();
  }

  /// The recorded advisor had taken up its loading before the log began: take it up without a word.
  void settle_loading() {
    const bool says_so = advice_.no_advice == static_cast<std::int16_t>(NoAdvice::kLoadingChanged);
    if (says_so || advice_.hull_digest == session_.digest_of_hull()) {
      return;
    }
    outbox_.is_silent = true;
    run_cycle();
    outbox_.is_silent = false;
  }

  /// False when an input that the advice rests on is not in the log.
  bool take_inputs(const LogEvent& event) {
    bool has_all = true;
    for (Channel& channel : channels_) {
      const auto index = static_cast<std::size_t>(channel.input);
      const bool is_used = index < kNumAdviceInputs && (advice_.input_use[index] == advice_t::USE_LIVE ||
                                                        advice_.input_use[index] == advice_t::USE_RESTORED);
      if (!is_used) {
        take_newest_unnamed(channel, event);
        continue;
      }
      const UsedInput named{static_cast<InputUse>(advice_.input_use[index]), advice_.input_source_id[index],
                            advice_.input_seq[index], advice_.input_utime[index]};
      has_all = take_named(channel, named) && has_all;
    }
    return has_all;
  }

  bool take_named(Channel& channel, const UsedInput& named) {
    const UsedInput held = session_.inputs().used(channel.input);
    if (held.use == named.use && is_same_message(held, named)) {
      return true;
    }
    if (named.use == InputUse::kRestored && channel.taken && is_same_message(channel.taken->header, named)) {
      count(feed_.feed(channel.taken->event, advice_.utime, session_, InputUse::kRestored));
      return true;
    }
    const auto found = std::find_if(channel.waiting.rbegin(), channel.waiting.rend(),
                                    [&](const Heard& heard) { return is_same_message(heard.header, named); });
    if (found == channel.waiting.rend() || named.use != InputUse::kLive) {
      return false;
    }
    channel.taken = *found;
    channel.waiting.erase(channel.waiting.begin(), found.base());  // what came before was overtaken
    count(feed_.feed(channel.taken->event, advice_.utime, session_));
    return true;
  }

  /// A sea that is not in force, a query, an acknowledgement, a message that was refused: the newest that the
  /// cycle must have seen. Of an input that the advice says it had not, only what is refused.
  void take_newest_unnamed(Channel& channel, const LogEvent& event) {
    const auto is_seen = [&](const Heard& heard) {
      if (time_mark_.utime == advice_.utime) {
        return heard.event.number < time_mark_.number;  // QS_TIME called the cycle
      }
      const std::int64_t margin = event.utime == advice_.utime ? 0 : kTakenBefore_us;
      return heard.event.utime <= advice_.utime - margin;
    };
    const auto seen = std::find_if(channel.waiting.rbegin(), channel.waiting.rend(), is_seen);
    if (seen == channel.waiting.rend()) {
      return;
    }
    const bool is_denied = channel.input == Input::kOwnShip || channel.input == Input::kLoading;
    if (is_denied && feed_.is_acceptable(seen->event, advice_.utime, session_.inputs())) {
      return;
    }
    count(feed_.feed(seen->event, advice_.utime, session_));
    channel.waiting.erase(channel.waiting.begin(), seen.base());
  }

  void count(Fed fed) { figures_.num_refused += fed == Fed::kRefused ? 1u : 0u; }

  void compare_advice(const LogEvent& event) {
    if (event.data == outbox_.advice) {
      ++recorded_.num_same_advice;
    } else if (recorded_.first_difference.empty()) {
      recorded_.first_difference = difference(advice_, session_.advice());
    }
  }

  void compare_grid(const LogEvent& event) {
    const UsedInput header = header_of(event.data);
    if (!has_followed_ || header.utime != advice_.utime || header.seq != advice_.seq) {
      return;
    }
    ++recorded_.num_grids;
    if (event.data == outbox_.grid) {
      ++recorded_.num_same_grids;
    } else if (recorded_.first_difference.empty()) {
      recorded_.first_difference = fmt::format("cycle {}: the grids differ", advice_.seq);
    }
  }

  struct TimeMark {
    std::int64_t utime = 0;
    std::uint64_t number = 0;  // of the event
  };

  Session& session_;
  const ReplayOptions& options_;
  const std::function<Status()>& configure_;
  LcmLogWriter* log_out_;
  const std::function<void(std::int64_t)>& after_cycle_;
  ReplayFigures& figures_;
  RecordedFigures& recorded_;
  LogFeed feed_;
  KeepingOutbox outbox_;
  Pace pace_;
  std::array<Channel, 6> channels_{{{"SEA_STATE", Input::kSeaState},
                                    {"WAVE_SPECTRUM", Input::kWaveSpectrum},
                                    {"OWN_SHIP", Input::kOwnShip},
                                    {"LOADING", Input::kLoading},
                                    {"QUERY", Input::kQuery},
                                    {"ALERT_ACK", Input::kAlertAck}}};
  advice_t advice_{};  // the recorded one that is followed
  TimeMark time_mark_;
  std::int32_t last_seq_ = 0;
  std::int64_t last_utime_ = 0;
  std::uint64_t last_advice_ = 0;  // number of the event
  bool has_followed_ = false;
};

}  // namespace

FileStatus find_recorded_advisor(const std::vector<std::filesystem::path>& paths, const std::string& prefix,
                                 RecordedAdvisor& out) {
  out = {};
  LcmLogReader log;
  if (FileStatus status = log.open(paths); !status) {
    return status;
  }
  const auto advice = std::make_unique<advice_t>();
  LogEvent event;
  while (!out.has_advice && log.next(event)) {
    if (event.channel != prefix + "ADVICE" || !decode(event.data, *advice)) {
      continue;
    }
    out.has_advice = true;
    out.source_id = advice->source_id;
    // An advice is valid for three cycles (session_messages.cpp); half a microsecond against truncation.
    out.cycle_period_s = (static_cast<double>(advice->valid_until_utime - advice->utime) + 0.5) / 3e6;
  }
  return {};
}

FileStatus replay_recorded_run(LcmLogReader& log, Session& session, const ReplayOptions& options,
                               const std::function<Status()>& configure, LcmLogWriter* log_out,
                               const std::function<void(std::int64_t now)>& after_cycle,
                               ReplayFigures& figures, RecordedFigures& recorded) {
  figures = {};
  recorded = {};
  if (const Status status = configure(); !status) {
    return FileError{std::string("the session cannot be configured: ").append(message(status.error()))};
  }
  const auto run =
      std::make_unique<RecordedRun>(session, options, configure, log_out, after_cycle, figures, recorded);
  EventStream events(log);
  LogEvent event;
  std::uint64_t number = 0;  // the log's own need not count up
  while (events.next(event)) {
    event.number = number++;
    if (FileStatus status = run->take(event); !status) {
      return status;
    }
  }
  figures.num_faults = log.num_faults();
  figures.first_fault = log.faults().empty() ? std::string() : log.faults().front().line;
  figures.num_out_of_time = events.num_out_of_time();
  figures.num_out_of_order = events.num_out_of_order();
  return {};
}

}  // namespace quickstrip
