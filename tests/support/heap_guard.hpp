// HeapGuard: counts the heap allocations of the present thread while it lives (firmware/heap_watch says how).
// Linking quickstrip_heap_guard replaces malloc for the whole program.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/heap_watch/heap_watch.hpp"

namespace quickstrip::test {

using quickstrip::kCountsMalloc;

class HeapGuard {
 public:
  HeapGuard();

  /// Allocations (reallocations included, releases not) of this thread since construction.
  [[nodiscard]] std::size_t allocations() const;

 private:
  std::int64_t at_start_;
};

}  // namespace quickstrip::test
