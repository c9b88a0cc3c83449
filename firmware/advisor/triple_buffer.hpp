// TripleBuffer<T>: hands the newest T from one writing thread to one reading thread.
//
// Demands of its caller: one writer (back, publish), one reader (take, front), no more. Neither ever waits,
// neither allocates: publish and take are one atomic exchange each. A value that is overtaken before the
// reader took it is lost, and counted: latest wins, which is right for a state (sea, own ship, loading) and
// for a question that its asker repeats. Three T in place.
//
// Why not LCM's own queue: full, it drops the newest message, and the newest is the one that is wanted.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace quickstrip {

template <typename T>
class TripleBuffer {
 public:
  /// Writer: the slot to fill; holds an old value. Not to be touched between publish and the next back().
  T& back() { return slots_[back_]; }

  /// Writer: makes what back() holds the newest.
  void publish() {
    const std::uint32_t given = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel);
    if ((given & kFresh) != 0U) {
      overtaken_.fetch_add(1, std::memory_order_relaxed);
    }
    back_ = given & kIndex;
  }

  /// Reader: true when something new has come since the last take; front() is it then.
  bool take() {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0U) {
      return false;
    }
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return true;
  }

  /// Reader: what the last successful take brought; a value-initialised T before.
  [[nodiscard]] const T& front() const { return slots_[front_]; }

  /// Values that were overtaken before they were taken. Any thread.
  [[nodiscard]] std::int64_t overtaken() const { return overtaken_.load(std::memory_order_relaxed); }

 private:
  static constexpr std::uint32_t kIndex = 3U;  // the low two bits: which slot
  static constexpr std::uint32_t kFresh = 4U;  // published, not taken yet

  std::array<T, 3> slots_{};
  std::uint32_t back_ = 0;                // writer's
  std::atomic<std::uint32_t> middle_{1};  // between them
  std::uint32_t front_ = 2;               // reader's
  std::atomic<std::int64_t> overtaken_{0};
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
};

}  // namespace quickstrip
