// FNV-1a, 64 bit (Fowler, Noll, Vo; offset basis and prime as published): tells whether two runs, or two
// settings, are the same. Not a protection against intent.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/hull/hull.hpp"

namespace quickstrip {

class Fnv1a {
 public:
  void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
      add_byte(byte);
    }
  }
  void add(std::string_view text) {
    for (const char c : text) {
      add_byte(static_cast<std::uint8_t>(c));
    }
  }
  /// The eight bytes of the IEEE form, least first: the same on every machine.
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (unsigned shift = 0; shift < 64; shift += 8) {
      add_byte(static_cast<std::uint8_t>((bits >> shift) & 0xFFu));
    }
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }
  /// As messages carry it.
  [[nodiscard]] std::int64_t as_int64() const { return static_cast<std::int64_t>(hash_); }

 private:
  void add_byte(std::uint8_t byte) {
    hash_ ^= byte;
    hash_ *= 0x100000001B3u;
  }
  std::uint64_t hash_ = 0xCBF29CE484222325u;
};

/// Of the form, what is watched, and a loading (the hull's own or another).
std::int64_t hull_digest(const Hull& hull, const Loading& loading);

/// Encodes `message` with its field `digest` set to 0 into `scratch`, and sets the field to the digest of
/// that. False, and the digest stays 0, when `scratch` is too small.
template <typename Message>
[[nodiscard]] bool seal(Message& message, std::span<std::uint8_t> scratch) {
  message.digest = 0;
  const int written = message.encode(scratch.data(), 0, static_cast<int>(scratch.size()));
  if (written < 0) {
    return false;
  }
  Fnv1a fnv;
  fnv.add(std::span<const std::uint8_t>{scratch.data(), static_cast<std::size_t>(written)});
  message.digest = fnv.as_int64();
  return true;
}

}  // namespace quickstrip
