// What the watching thread sees of the process, and what it tells the service manager. The cycle's thread
// reads and writes its numbers as atomics; neither waits for the other.
//
// The manager hears that the process is alive only while the cycle's thread goes on: one that hangs is killed
// and started again.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "firmware/advisor/service_notice.hpp"

namespace quickstrip {

class ProcessWatch {
 public:
  // By the cycle's thread.
  /// It has come round its loop: every 100 ms or oftener, also between cycles.
  void note_alive() { turns_.fetch_add(1, std::memory_order_relaxed); }
  /// It has finished a cycle. The verdict's and reason's numbers are advice_t's.
  void note_cycle(int no_advice, int verdict);

  [[nodiscard]] std::int64_t page_faults() const { return page_faults_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::int64_t resident_bytes() const {
    return resident_bytes_.load(std::memory_order_relaxed);
  }

  // By the watching thread.
  /// Samples what the process takes: 1 Hz is enough.
  void sample();
  /// Tells READY once the cycle's thread runs, then WATCHDOG and STATUS. Call every 100 ms.
  void tell();
  void tell_stopping();

 private:
  ServiceNotice notice_;
  std::atomic<std::int64_t> turns_{0};
  std::atomic<int> state_{-1};  // no_advice and verdict of the last cycle; -1: none yet
  std::atomic<std::int64_t> page_faults_{-1};
  std::atomic<std::int64_t> resident_bytes_{-1};
  bool is_ready_ = false;
  std::int64_t told_turns_ = 0;
  int told_state_ = -1;
  std::chrono::steady_clock::time_point told_at_;
};

}  // namespace quickstrip
