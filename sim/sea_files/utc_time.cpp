#include "sim/sea_files/utc_time.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstddef>

namespace quickstrip {
namespace {

// The number that fills text[at, at + digits); nothing when it does not consist of digits.
std::optional<int> number_at(std::string_view text, std::size_t at, std::size_t digits) {
  if (text.size() < at + digits) {
    return std::nullopt;
  }
  int value = 0;
  for (const char c : text.substr(at, digits)) {
    if (c < '0' || c > '9') {
      return std::nullopt;
    }
    value = 10 * value + (c - '0');
  }
  return value;
}

}  // namespace

std::optional<std::int64_t> utime_of(int year, int month, int day, int hour, int minute, int second) {
  using std::chrono::sys_days;
  using std::chrono::year_month_day;
  if (year < 1970 || year > 9999 || month < 1 || day < 1 || hour < 0 || hour > 23 || minute < 0 ||
      minute > 59 || second < 0 || second > 59) {
    return std::nullopt;
  }
  const year_month_day date{std::chrono::year{year}, std::chrono::month{static_cast<unsigned>(month)},
                            std::chrono::day{static_cast<unsigned>(day)}};
  if (!date.ok()) {
    return std::nullopt;
  }
  const std::int64_t days = sys_days{date}.time_since_epoch().count();
  return (((days * 24 + hour) * 60 + minute) * 60 + second) * kUtimePerSecond;
}

std::optional<std::int64_t> parse_utc(std::string_view text) {
  const std::string_view shape = text.size() == 17 ? "0000-00-00T00:00Z" : "0000-00-00T00:00:00Z";
  if (text.size() != shape.size()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (shape[i] != '0' && text[i] != shape[i]) {
      return std::nullopt;
    }
  }
  const auto year = number_at(text, 0, 4);
  const auto month = number_at(text, 5, 2);
  const auto day = number_at(text, 8, 2);
  const auto hour = number_at(text, 11, 2);
  const auto minute = number_at(text, 14, 2);
  const auto second = text.size() == 17 ? std::optional<int>(0) : number_at(text, 17, 2);
  if (!year || !month || !day || !hour || !minute || !second) {
    return std::nullopt;
  }
  return utime_of(*year, *month, *day, *hour, *minute, *second);
}

std::string format_utc(std::int64_t utime_us) {
  using namespace std::chrono;
  const sys_seconds time{floor<seconds>(microseconds{utime_us})};
  const sys_days date = floor<days>(time);
  const year_month_day ymd{date};
  const hh_mm_ss clock{time - date};
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", static_cast<int>(ymd.year()),
                     static_cast<unsigned>(ymd.month()), static_cast<unsigned>(ymd.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count());
}

}  // namespace quickstrip
