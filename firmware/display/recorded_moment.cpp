#include "firmware/display/recorded_moment.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string_view>
#include <vector>

#include "firmware/display/mail_route.hpp"
#include "msgs/convert/encode.hpp"
#include "msgs/files/lcm_log.hpp"

namespace quickstrip {
namespace {

constexpr std::chrono::milliseconds kNoWait{0};

/// After this the messages of the cycle have been read: the next advice would be another's.
bool is_later_advice(const LogEvent& event, const std::string& prefix, std::int64_t until) {
  if (event.channel != prefix + "ADVICE") {
    return false;
  }
  const auto advice = std::make_unique<advice_t>();
  return decode(event.data, *advice) && advice->utime > until;
}

/// What an advice rests on. An input that comes after the advice of the moment belongs to the next one.
bool is_input(std::string_view name) {
  constexpr std::array<std::string_view, 5> kInputs{"SEA_STATE", "WAVE_SPECTRUM", "OWN_SHIP", "LOADING",
                                                    "MOTION"};
  return std::find(kInputs.begin(), kInputs.end(), name) != kInputs.end();
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Digits where the pattern has 0, else its own characters.
bool is_like(std::string_view text, std::string_view pattern) {
  if (text.size() != pattern.size()) {
    return false;
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (pattern[i] == '0' ? !is_digit(text[i]) : text[i] != pattern[i]) {
      return false;
    }
  }
  return true;
}

/// Of digits only.
int number(std::string_view text, std::size_t from, std::size_t size) {
  int value = 0;
  for (const char digit : text.substr(from, size)) {
    value = 10 * value + (digit - '0');
  }
  return value;
}

}  // namespace

std::optional<std::int64_t> utime_of_text(const std::string& text) {
  constexpr std::string_view kMinutes = "0000-00-00T00:00Z";
  constexpr std::string_view kSeconds = "0000-00-00T00:00:00Z";
  if (!is_like(text, kMinutes) && !is_like(text, kSeconds)) {
    return std::nullopt;
  }
  const bool has_seconds = text.size() == kSeconds.size();
  const std::chrono::year_month_day date{std::chrono::year{number(text, 0, 4)},
                                         std::chrono::month{static_cast<unsigned>(number(text, 5, 2))},
                                         std::chrono::day{static_cast<unsigned>(number(text, 8, 2))}};
  const int h = number(text, 11, 2);
  const int m = number(text, 14, 2);
  const int s = has_seconds ? number(text, 17, 2) : 0;
  if (!date.ok() || h > 23 || m > 59 || s > 59 || date.year() < std::chrono::year{1970}) {
    return std::nullopt;
  }
  const auto days = std::chrono::sys_days{date}.time_since_epoch();
  const auto seconds =
      std::chrono::seconds{days} + std::chrono::hours{h} + std::chrono::minutes{m} + std::chrono::seconds{s};
  return std::chrono::duration_cast<std::chrono::microseconds>(seconds).count();
}

FileStatus put_recorded_moment(const std::string& log, const std::string& at, const std::string& prefix,
                               Display& display) {
  std::int64_t until = INT64_MAX;
  if (!at.empty()) {
    const auto utime = utime_of_text(at);
    if (!utime) {
      return FileError{"--at: " + at + ": a time is written 2019-09-04T12:40Z"};
    }
    // To the minute or the second as it is written: what is finer belongs to it.
    until = *utime + (at.size() > 17 ? 999'999 : 59'999'999);
  }
  LcmLogReader reader;
  if (FileStatus status = reader.open(log); !status) {
    return status;
  }
  LogEvent event;
  std::vector<LogEvent> waiting;  // inputs since the last advice
  bool has_advice = false;
  while (reader.next(event) && !is_later_advice(event, prefix, until)) {
    if (!event.channel.starts_with(prefix)) {
      continue;
    }
    const std::string_view name = std::string_view(event.channel).substr(prefix.size());
    if (is_input(name)) {
      waiting.push_back(event);
      continue;
    }
    if (name == "ADVICE") {  // a cycle a turn: each counts for the trends
      display.turn(event.utime, kNoWait);
      has_advice = true;
      for (const LogEvent& input : waiting) {
        route(std::string_view(input.channel).substr(prefix.size()), input.data, display.mailbox());
      }
      waiting.clear();
    }
    route(name, event.data, display.mailbox());
  }
  display.turn(event.utime, kNoWait);
  if (!has_advice) {
    return FileError{log + ": holds no advice " + (at.empty() ? "" : "until " + at + " ") + "(channel " +
                     prefix + "ADVICE)"};
  }
  return {};
}

}  // namespace quickstrip
