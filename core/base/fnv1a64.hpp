// FNV-1a over words of 32 bits: checksums and digests, against damage and mistaken identity, not against
// malice.
#pragma once

#include <bit>
#include <cstdint>

namespace quickstrip {

class Fnv1a64 {
 public:
  void add(std::uint32_t word) { hash_ = (hash_ ^ word) * 0x100000001b3U; }
  void add(double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    add(static_cast<std::uint32_t>(bits));
    add(static_cast<std::uint32_t>(bits >> 32));
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

}  // namespace quickstrip
