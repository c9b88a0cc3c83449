// Messages to bytes and back in memory of the caller: no heap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace quickstrip {

inline constexpr std::size_t kMaxMessageBytes =
    65'000;  // beyond 65,499 a UDP packet is split, and lost in bursts

/// The bytes written, at the front of `buffer`; empty when it is too small.
template <typename Message>
std::span<const std::uint8_t> encode(const Message& message, std::span<std::uint8_t> buffer) {
  const int written = message.encode(buffer.data(), 0, static_cast<int>(buffer.size()));
  return written < 0 ? std::span<const std::uint8_t>{}
                     : std::span<const std::uint8_t>{buffer.data(), static_cast<std::size_t>(written)};
}

/// False for another type, another version of it, or another length; `out` is then not to be used.
template <typename Message>
[[nodiscard]] bool decode(std::span<const std::uint8_t> bytes, Message& out) {
  if (bytes.size() > kMaxMessageBytes) {
    return false;
  }
  const int size = static_cast<int>(bytes.size());
  return out.decode(bytes.data(), 0, size) == size;
}

}  // namespace quickstrip
