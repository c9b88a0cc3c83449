// The text of a fixed byte field of a message: up to the first NUL.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace quickstrip {

template <std::size_t N>
std::string message_text(const std::uint8_t (&field)[N]) {
  return {field, std::find(field, field + N, std::uint8_t{0})};
}

}  // namespace quickstrip
