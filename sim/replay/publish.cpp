#include "sim/replay/publish.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "firmware/session/inputs.hpp"
#include "msgs/convert/encode.hpp"
#include "quickstrip/clock_t.hpp"
#include "quickstrip/response_t.hpp"
#include "sim/replay/event_stream.hpp"
#include "sim/replay/log_feed.hpp"

namespace quickstrip {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::int16_t kReplayId = 101;

/// The advisor at the other end of the bus.
class FarAdvisor {
 public:
  FarAdvisor(const PublishOptions& options, LcmLogWriter* record)
      : options_(options), record_(record), bus_(options.url) {
    if (bus_.good()) {
      for (const std::string_view name : kOutChannelNames) {
        bus_.subscribe(options.prefix + std::string(name), &FarAdvisor::hear, this)->setQueueCapacity(1000);
      }
    }
  }
  [[nodiscard]] bool is_good() const { return bus_.good(); }

  bool send(const std::string& channel, std::span<const std::uint8_t> bytes) {
    return bus_.publish(channel, bytes.data(), static_cast<unsigned int>(bytes.size())) == 0;
  }

  bool send_time(std::int64_t now) {
    quickstrip::clock_t message{};
    message.utime = now;
    message.seq = ++time_seq_;
    message.source_id = kReplayId;
    message.rate = options_.speed > 0.0 ? options_.speed : -1.0;
    now_ = now;
    return send(options_.prefix + "TIME", encode(message, bytes_));
  }

  /// Sends the newest of each input and QS_TIME until the cycle of `now` has been answered: again every two
  /// seconds, for an advisor that is still starting does not hear the first.
  bool step(std::int64_t now, const std::map<std::string, std::vector<std::uint8_t>>& newest) {
    const double patience_s = has_answered_ ? 0.1 * options_.answer_s : options_.answer_s;
    const Clock::time_point end =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience_s));
    answered_utime_ = 0;
    while (Clock::now() < end) {
      bool is_sent = true;
      for (const auto& [channel, bytes] : newest) {
        is_sent = send(channel, bytes) && is_sent;
      }
      if (!send_time(now) || !is_sent) {
        return false;
      }
      const Clock::time_point again = std::min(end, Clock::now() + std::chrono::milliseconds(2000));
      while (Clock::now() < again) {
        bus_.handleTimeout(100);
        if (answered_utime_ == now) {
          has_answered_ = true;
          return true;
        }
      }
    }
    return false;
  }

  void listen_until(Clock::time_point end) {
    do {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
      bus_.handleTimeout(static_cast<int>(std::clamp<long long>(left, 1, 100)));
    } while (Clock::now() < end);
  }

  std::uint64_t num_answers = 0;
  FileStatus failure;

 private:
  void hear(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
    const std::span<const std::uint8_t> bytes{static_cast<const std::uint8_t*>(buffer->data),
                                              buffer->data_size};
    ++num_answers;
    if (record_ != nullptr && failure.ok()) {
      failure = record_->append(now_, channel, bytes);
    }
    if (channel == options_.prefix + "RESPONSE" && decode(bytes, response_) && response_.query_id == 0) {
      answered_utime_ = response_.utime;
    }
  }

  const PublishOptions& options_;
  LcmLogWriter* record_;
  lcm::LCM bus_;
  response_t response_{};
  std::array<std::uint8_t, 64> bytes_{};
  std::int64_t now_ = 0;
  std::int64_t answered_utime_ = 0;
  std::int32_t time_seq_ = 0;
  bool has_answered_ = false;
};

/// Which instants get a QS_TIME: every new sea or loading, and every cycle period.
class TimesToSend {
 public:
  TimesToSend(double period_s, std::string prefix)
      : period_us_(static_cast<std::int64_t>(period_s * 1e6)), prefix_(std::move(prefix)) {}
  void note(const LogEvent& event) {
    const std::string_view name = name_without_prefix(event.channel, prefix_);
    is_news_ =
        is_news_ || name == "SEA_STATE" || name == "WAVE_SPECTRUM" || name == "LOADING" || name == "QUERY";
  }
  [[nodiscard]] bool is_due(std::int64_t now) const {
    return is_news_ || last_ == 0 || now - last_ >= period_us_;
  }
  void has_run(std::int64_t now) {
    last_ = now;
    is_news_ = false;
  }

 private:
  std::int64_t period_us_;
  std::string prefix_;
  std::int64_t last_ = 0;
  bool is_news_ = false;
};

}  // namespace

FileStatus publish_log(LcmLogReader& log, const PublishOptions& options, LcmLogWriter* record,
                       PublishFigures& figures) {
  const auto far = std::make_unique<FarAdvisor>(options, record);
  if (!far->is_good()) {
    return FileError{"--url: " + options.url + ": LCM cannot open it (udpm:// needs a multicast route)"};
  }
  figures = {};
  TimesToSend times(options.cycle_period_s, options.prefix);
  const Clock::time_point start = Clock::now();
  std::int64_t first = 0;
  std::map<std::string, std::vector<std::uint8_t>> newest;  // of each input channel since the last cycle
  EventStream events(log);
  LogEvent event;
  bool has_event = events.next(event);
  while (has_event && far->failure.ok()) {
    const std::int64_t now = event.utime;
    first = first == 0 ? now : first;
    if (options.speed > 0.0) {
      const std::chrono::duration<double> offset(static_cast<double>(now - first) * 1e-6 / options.speed);
      far->listen_until(start + std::chrono::duration_cast<Clock::duration>(offset));
    }
    for (; has_event && event.utime <= now; has_event = events.next(event)) {
      const std::string_view name = name_without_prefix(event.channel, options.prefix);
      if (!is_input(name) || name == "TIME") {
        continue;
      }
      times.note(event);
      newest[event.channel] = event.data;
      if (options.speed > 0.0) {
        far->send(event.channel, event.data);
      }
    }
    if (!times.is_due(now)) {
      continue;
    }
    if (record != nullptr) {
      for (const auto& [channel, bytes] : newest) {
        if (FileStatus status = record->append(now, channel, bytes); !status) {
          return status;
        }
      }
    }
    const bool is_answered = options.speed > 0.0 ? far->send_time(now) : far->step(now, newest);
    if (!is_answered) {
      return FileError{options.url +
                       ": no advisor answers; start quickstrip-advisor --clock log with this URL"};
    }
    figures.num_sent += newest.size();
    newest.clear();
    times.has_run(now);
    ++figures.num_cycles;
  }
  figures.num_answers = far->num_answers;
  return far->failure;
}

}  // namespace quickstrip
