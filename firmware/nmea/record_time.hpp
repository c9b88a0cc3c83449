// The time that a recorder has written before each line: "2014-08-01T00:00:00.285000Z $INHDT,...". Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace quickstrip::nmea {

/// Takes the stamp and the blanks after it off the front of `line`; nothing, and `line` as it was, without
/// one. Year to second, with a fraction of any length, `Z` or nothing behind; years 1970 ... 2199.
std::optional<std::int64_t> take_stamp(std::string_view& line);

}  // namespace quickstrip::nmea
