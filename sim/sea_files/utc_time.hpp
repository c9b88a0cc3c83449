// Times of files and command lines: UTC, microseconds since 1970 as in the messages (utime).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace quickstrip {

inline constexpr std::int64_t kUtimePerSecond = 1'000'000;
inline constexpr std::int64_t kUtimePerHour = 3600 * kUtimePerSecond;

/// Years 1970 ... 9999. Nothing when there is no such date or time of day.
std::optional<std::int64_t> utime_of(int year, int month, int day, int hour, int minute, int second);

/// "2019-09-04T12:40Z", seconds optional ("2019-09-04T12:40:00Z"). Nothing for everything else.
std::optional<std::int64_t> parse_utc(std::string_view text);

/// "2019-09-04T12:40:00Z"; fractions of a second are cut.
std::string format_utc(std::int64_t utime_us);

}  // namespace quickstrip
