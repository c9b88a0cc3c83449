// Text from a file or a bus, fit for one line on a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace quickstrip {

/// At most so many bytes of a value are quoted in a refusal.
inline constexpr std::size_t kMaxShownBytes = 60;

/// `text` with '?' for control characters and for what is not UTF-8; what is longer is cut between characters
/// and ends with "...".
std::string printable(std::string_view text, std::size_t max_bytes = kMaxShownBytes);

}  // namespace quickstrip
