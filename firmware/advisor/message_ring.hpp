// MessageRing<Bytes>: hands messages of any length, in order, from one writing thread to one reading thread.
//
// Demands of its caller: one writer (push), one reader (front, pop), no more. Neither ever waits and neither
// allocates. A message that does not fit is refused whole, and the writer is told: what is published is of
// the past already, so the newest goes, not the one that is being read. `Bytes` in place, a power of two.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace quickstrip {

struct RingMessage {
  std::uint32_t channel = 0;
  std::span<const std::uint8_t> bytes;  // until pop()
};

template <std::size_t Bytes>
class MessageRing {
 public:
  /// Writer: false when it does not fit now. `channel` below 2^32 - 1.
  bool push(std::uint32_t channel, std::span<const std::uint8_t> bytes) {
    const std::size_t wanted = record_bytes(bytes.size());
    std::uint64_t at = written_.load(std::memory_order_relaxed);
    const std::size_t to_end = Bytes - place(at);
    const std::size_t skipped = wanted > to_end ? to_end : 0;  // a record lies in one piece
    if (bytes.size() > Bytes || wanted + skipped > free()) {
      return false;
    }
    if (skipped > 0) {
      store(at, {.size = static_cast<std::uint32_t>(skipped - sizeof(Header)), .channel = kSkip});
      at += skipped;
    }
    store(at, {.size = static_cast<std::uint32_t>(bytes.size()), .channel = channel});
    std::copy(bytes.begin(), bytes.end(),
              ring_.begin() + static_cast<std::ptrdiff_t>(place(at) + sizeof(Header)));
    written_.store(at + wanted, std::memory_order_release);
    return true;
  }

  /// Reader: whether there is a message, and which.
  bool front(RingMessage& out) {
    for (int turn = 0; turn < 2; ++turn) {  // a skip, then a message: never two skips
      const std::uint64_t at = read_.load(std::memory_order_relaxed);
      if (at == written_.load(std::memory_order_acquire)) {
        return false;
      }
      const Header header = load(at);
      if (header.channel != kSkip) {
        out = {header.channel, {ring_.data() + place(at) + sizeof(Header), header.size}};
        return true;
      }
      read_.store(at + record_bytes(header.size), std::memory_order_release);
    }
    return false;
  }

  /// Reader: after front() was true.
  void pop() {
    const std::uint64_t at = read_.load(std::memory_order_relaxed);
    read_.store(at + record_bytes(load(at).size), std::memory_order_release);
  }

  /// Bytes that are free now; a message takes up to sizeof(Header) + 7 more than its own. Any thread.
  [[nodiscard]] std::size_t free() const {
    const std::uint64_t read = read_.load(std::memory_order_acquire);
    return Bytes - static_cast<std::size_t>(written_.load(std::memory_order_acquire) - read);
  }

 private:
  struct Header {
    std::uint32_t size = 0;
    std::uint32_t channel = 0;
  };
  static constexpr std::uint32_t kSkip = 0xFFFF'FFFFU;
  static_assert(std::has_single_bit(Bytes) && Bytes >= 2 * sizeof(Header));

  static constexpr std::size_t record_bytes(std::size_t size) {
    return sizeof(Header) + (size + sizeof(Header) - 1) / sizeof(Header) * sizeof(Header);
  }
  static constexpr std::size_t place(std::uint64_t at) { return static_cast<std::size_t>(at % Bytes); }
  void store(std::uint64_t at, const Header& header) {
    std::memcpy(ring_.data() + place(at), &header, sizeof(header));
  }
  [[nodiscard]] Header load(std::uint64_t at) const {
    Header header;
    std::memcpy(&header, ring_.data() + place(at), sizeof(header));
    return header;
  }

  std::array<std::uint8_t, Bytes> ring_{};
  std::atomic<std::uint64_t> written_{0};  // bytes ever, multiples of a header
  std::atomic<std::uint64_t> read_{0};
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
};

}  // namespace quickstrip
