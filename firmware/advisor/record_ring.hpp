// RecordRing<T, N>: hands records of one kind, in order, from one writing thread to one reading thread.
//
// Demands of its caller: one writer (push), one reader (pop), no more. Neither ever waits and neither
// allocates. A record that finds the ring full is lost, and counted. N records in place.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace quickstrip {

template <typename T, std::size_t N>
class RecordRing {
 public:
  /// Writer: false when it was lost.
  bool push(const T& record) {
    const std::uint64_t at = written_.load(std::memory_order_relaxed);
    if (at - read_.load(std::memory_order_acquire) >= N) {
      lost_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    records_[static_cast<std::size_t>(at % N)] = record;
    written_.store(at + 1, std::memory_order_release);
    return true;
  }

  /// Reader: false when there is none.
  bool pop(T& out) {
    const std::uint64_t at = read_.load(std::memory_order_relaxed);
    if (at == written_.load(std::memory_order_acquire)) {
      return false;
    }
    out = records_[static_cast<std::size_t>(at % N)];
    read_.store(at + 1, std::memory_order_release);
    return true;
  }

  /// Since the start. Any thread.
  [[nodiscard]] std::int64_t lost() const { return lost_.load(std::memory_order_relaxed); }

 private:
  std::array<T, N> records_{};
  std::atomic<std::uint64_t> written_{0};
  std::atomic<std::uint64_t> read_{0};
  std::atomic<std::int64_t> lost_{0};
};

}  // namespace quickstrip
