// What the operating system has given the calling thread: tells a cycle that was long from one that was kept
// from the processor, and shows that a cycle waits for nothing.
#pragma once

#include <cstdint>

namespace quickstrip {

struct ThreadUsage {
  double processor_s = 0.0;
  std::int64_t num_waits = 0;  // times it gave the processor up of itself: slept, or waited for something
  std::int64_t num_page_faults = 0;  // pages it touched that were not there

  ThreadUsage& operator+=(const ThreadUsage& other) {
    processor_s += other.processor_s;
    num_waits += other.num_waits;
    num_page_faults += other.num_page_faults;
    return *this;
  }
  friend ThreadUsage operator-(const ThreadUsage& a, const ThreadUsage& b) {
    return {a.processor_s - b.processor_s, a.num_waits - b.num_waits, a.num_page_faults - b.num_page_faults};
  }
};

/// Since the thread began. Two system calls that never wait, about a microsecond.
ThreadUsage usage_of_this_thread();

}  // namespace quickstrip
