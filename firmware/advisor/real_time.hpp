// What the operating system is asked for, so that a cycle comes when it is due: memory that stays in RAM, a
// stack that is there, a processor before ordinary programs. Each may be refused (an ordinary user may lock
// 8 MB and has no real-time priorities): then it is said, not hidden.
#pragma once

#include <chrono>
#include <string>

namespace quickstrip {

enum class RealTime {
  kAuto,  // what is permitted
  kOn,    // all of it, or no start
  kOff,
};

struct RealTimeResult {
  bool is_whole = false;  // nothing was refused
  std::string line;       // for the journal
};

/// Threads that begin from here on, LCM's among them, have stacks of 512 kB and one heap together: memory
/// that is locked is filled, and the system's 8 and 64 MB a thread are not needed. Call first.
void keep_threads_small();

/// Fills and locks the pages that the process has and will have, and keeps the heap from giving pages back.
/// Call when everything large is made and before threads start.
RealTimeResult lock_memory();

/// Gives the calling thread SCHED_FIFO at `priority`, 1 ... 99, where permitted.
RealTimeResult schedule_in_real_time(int priority);

/// Touches the calling thread's stack to kPrefaultedStackBytes below here. Measured need: tests/evidence.
void prefault_stack();

/// Of CLOCK_MONOTONIC; returns early on a signal.
void sleep_until(std::chrono::steady_clock::time_point when);

}  // namespace quickstrip
