#include "firmware/display/recorded_moment.hpp"

#include <chrono>
#include <cstdio>
#include <memory>

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

}  // namespace

std::optional<std::int64_t> utime_of_text(const std::string& text) {
  int y = 0;
  int mo = 0;
  int d = 0;
  int h = 0;
  int mi = 0;
  int s = 0;
  int end = 0;
  const bool has_seconds =
      std::sscanf(text.c_str(), "%4d-%2d-%2dT%2d:%2d:%2dZ%n", &y, &mo, &d, &h, &mi, &s, &end) == 6 && end > 0;
  if (!has_seconds) {
    s = 0;
    end = 0;
    if (std::sscanf(text.c_str(), "%4d-%2d-%2dT%2d:%2dZ%n", &y, &mo, &d, &h, &mi, &end) != 5) {
      return std::nullopt;
    }
  }
  const std::chrono::year_month_day date{std::chrono::year{y}, std::chrono::month{static_cast<unsigned>(mo)},
                                         std::chrono::day{static_cast<unsigned>(d)}};
  const bool is_time = h >= 0 && h < 24 && mi >= 0 && mi < 60 && s >= 0 && s < 60;
  if (static_cast<std::size_t>(end) != text.size() || !date.ok() || !is_time || y < 1970) {
    return std::nullopt;
  }
  const auto days = std::chrono::sys_days{date}.time_since_epoch();
  const auto seconds =
      std::chrono::seconds{days} + std::chrono::hours{h} + std::chrono::minutes{mi} + std::chrono::seconds{s};
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
  bool has_advice = false;
  while (reader.next(event) && !is_later_advice(event, prefix, until)) {
    if (!event.channel.starts_with(prefix)) {
      continue;
    }
    if (event.channel == prefix + "ADVICE") {  // a cycle a turn: each counts for the trends
      display.turn(event.utime, kNoWait);
      has_advice = true;
    }
    route(std::string_view(event.channel).substr(prefix.size()), event.data, display.mailbox());
  }
  display.turn(event.utime, kNoWait);
  if (!has_advice) {
    return FileError{log + ": holds no advice " + (at.empty() ? "" : "until " + at + " ") + "(channel " +
                     prefix + "ADVICE)"};
  }
  return {};
}

}  // namespace quickstrip
