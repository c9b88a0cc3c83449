#include "firmware/nmea/record_time.hpp"

#include <array>
#include <chrono>
#include <cstddef>

namespace quickstrip::nmea {
namespace {

constexpr std::int64_t kMicroseconds = 1'000'000;

/// `count` digits off the front.
std::optional<int> take_digits(std::string_view& text, std::size_t count) {
  if (text.size() < count) {
    return {};
  }
  int value = 0;
  for (const char c : text.substr(0, count)) {
    if (c < '0' || c > '9') {
      return {};
    }
    value = value * 10 + (c - '0');
  }
  text.remove_prefix(count);
  return value;
}

bool take_mark(std::string_view& text, char mark) {
  if (!text.starts_with(mark)) {
    return false;
  }
  text.remove_prefix(1);
  return true;
}

/// ".285" in microseconds; finer digits are cut.
std::int64_t take_fraction(std::string_view& text) {
  std::int64_t fraction = 0;
  if (take_mark(text, '.')) {
    std::int64_t weight = kMicroseconds / 10;
    while (!text.empty() && text[0] >= '0' && text[0] <= '9') {
      fraction += weight * (text[0] - '0');
      weight /= 10;
      text.remove_prefix(1);
    }
  }
  return fraction;
}

}  // namespace

std::optional<std::int64_t> take_stamp(std::string_view& line) {
  struct Part {
    std::size_t digits;
    char mark;  // after it; NUL: none
    int from, to;
  };
  static constexpr std::array<Part, 6> kParts{{{4, '-', 1970, 2199},
                                               {2, '-', 1, 12},
                                               {2, 'T', 1, 31},
                                               {2, ':', 0, 23},
                                               {2, ':', 0, 59},
                                               {2, '\0', 0, 59}}};
  std::string_view rest = line;
  std::array<int, 6> values{};
  for (std::size_t i = 0; i < kParts.size(); ++i) {
    const std::optional<int> value = take_digits(rest, kParts[i].digits);
    const bool is_marked = kParts[i].mark == '\0' || take_mark(rest, kParts[i].mark);
    if (!value || *value < kParts[i].from || *value > kParts[i].to || !is_marked) {
      return {};
    }
    values[i] = *value;
  }
  const std::int64_t fraction = take_fraction(rest);
  static_cast<void>(take_mark(rest, 'Z'));
  if (!rest.starts_with(' ') && !rest.starts_with('\t') && !rest.starts_with(',')) {
    return {};
  }
  const std::chrono::year_month_day date{std::chrono::year{values[0]},
                                         std::chrono::month{static_cast<unsigned>(values[1])},
                                         std::chrono::day{static_cast<unsigned>(values[2])}};
  if (!date.ok()) {
    return {};
  }
  while (rest.starts_with(' ') || rest.starts_with('\t') || rest.starts_with(',')) {
    rest.remove_prefix(1);
  }
  line = rest;
  const std::int64_t day = std::chrono::sys_days{date}.time_since_epoch().count();
  const std::int64_t hours = std::int64_t{24} * day + values[3];
  const std::int64_t seconds = (hours * 60 + values[4]) * 60 + values[5];
  return seconds * kMicroseconds + fraction;
}

}  // namespace quickstrip::nmea
