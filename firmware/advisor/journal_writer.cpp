// Words and writes the journal's records.
#include <fmt/format.h>

#include <chrono>
#include <ctime>

#include "firmware/advisor/journal.hpp"
#include "firmware/advisor/standard_streams.hpp"

namespace quickstrip {
namespace {

constexpr std::chrono::milliseconds kLook{50};

/// By Input.
constexpr const char* kInputNames[kNumInputs] = {"SEA_STATE", "WAVE_SPECTRUM", "SEA_FORECAST",
                                                 "OWN_SHIP",  "LOADING",       "MOTION",
                                                 "TIME",      "QUERY",         "ALERT_ACK"};

/// "2019-09-04T12:40:00Z"
std::string utc_text(std::int64_t utime) {
  const std::time_t seconds = utime / 1'000'000;
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char text[32] = {};
  std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

const char* word(int verdict) {
  switch (verdict) {
    case 1:
      return "good";
    case 2:
      return "caution";
    case 3:
      return "limits exceeded";
    default:
      return "not known";
  }
}

std::string line_of_missed(const MissedDeadline& missed, int num) {
  const std::string beginning = num == 1 ? "a deadline was missed: the cycle"
                                         : fmt::format("{} deadlines were missed, the worst: the cycle", num);
  return fmt::format(
      "{} began {:.1f} ms late, took {:.1f} of {:.1f} ms, had the processor for {:.1f} ms and gave it up {} "
      "times",
      beginning, 1e3 * missed.late_s, 1e3 * missed.took_s, 1e3 * missed.period_s, 1e3 * missed.processor_s,
      missed.num_waits);
}

std::string line_of(const JournalRecord& record) {
  const std::string time = utc_text(record.utime);
  switch (record.kind) {
    case JournalRecord::Kind::kAdvice:
      return fmt::format("{} {} at {:03.0f}, {:.1f} kn ({}): {}", time, word(record.verdict),
                         record.heading_deg, record.speed_kn,
                         record.is_spectrum ? "wave spectrum" : "sea state", record.text.data());
    case JournalRecord::Kind::kNoAdvice:
      return fmt::format("{} {}", time, record.text.data());
    case JournalRecord::Kind::kMissed:
      return fmt::format("{} {}", time, line_of_missed(record.missed, record.num_missed));
    case JournalRecord::Kind::kRefusal:
      break;
  }
  const Conversion& refused = record.refusal;
  return fmt::format("{} a message was refused: {}: {}{}{}; from here on counted in QS_HEALTH", time,
                     kInputNames[record.input], refused.field, refused.field[0] != '\0' ? ": " : "",
                     message(refused.refusal));
}

}  // namespace

void JournalWriter::start() {
  is_running_ = true;
  thread_ = std::thread([this] { write(); });
}

void JournalWriter::stop() {
  is_running_ = false;
  if (thread_.joinable()) {
    thread_.join();
  }
}

void JournalWriter::write() {
  std::int64_t num_unwritten = 0;
  while (true) {
    const bool was_running = is_running_.load();
    JournalRecord record;
    while (ring_.pop(record)) {
      num_unwritten += write_line(line_of(record)) ? 0 : 1;
    }
    const std::int64_t num_lost = num_unwritten + ring_.lost();
    if (num_lost > num_lost_ &&
        write_line(fmt::format("{} lines of this journal were lost", num_lost - num_lost_))) {
      num_lost_ = num_lost;
    }
    if (!was_running) {
      return;  // after a last look
    }
    std::this_thread::sleep_for(kLook);
  }
}

}  // namespace quickstrip
