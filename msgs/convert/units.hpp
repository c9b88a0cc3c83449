// Units of the rim against those of core: knots, degrees, hours and microseconds here; m/s, radians and
// seconds there. The only place where the factors stand.
#pragma once

#include <cstdint>

#include "core/base/angles.hpp"

namespace quickstrip {

inline constexpr double kMetresPerSecondPerKnot = 1852.0 / 3600.0;  // international nautical mile, exact
inline constexpr double kMicrosecondsPerSecond = 1.0e6;
inline constexpr double kSecondsPerHour = 3600.0;

inline constexpr double from_knots(double knots) {
  return knots * kMetresPerSecondPerKnot;
}
inline constexpr double to_knots(double metres_per_second) {
  return metres_per_second / kMetresPerSecondPerKnot;
}
/// Times that we take, ends excluded: after 1970 and before 2200 [microseconds since the epoch]. Within them
/// a double holds every microsecond and no sum or difference overflows.
inline constexpr std::int64_t kLatestUtime = 7'258'118'400'000'000;
inline constexpr bool is_time(std::int64_t utime) {
  return utime > 0 && utime < kLatestUtime;
}
/// Age of something measured at `utime`, at the time `now`, both microseconds since the epoch [s]. Any two
/// values: the difference of doubles does not overflow.
inline constexpr double seconds_between(std::int64_t utime, std::int64_t now) {
  return (static_cast<double>(now) - static_cast<double>(utime)) / kMicrosecondsPerSecond;
}

}  // namespace quickstrip
