// HeapGuard: counts the heap allocations of the present thread while it lives.
// How: this library replaces malloc, calloc, realloc and their aligned kin (and so operator new, which
// calls them) by counting wrappers over glibc's own. Under a sanitizer, which owns malloc, only operator new
// is counted: kCountsMalloc says which. Linking quickstrip_heap_guard replaces them for the whole program.
// Cost: one thread-local increment an allocation. Needs glibc.
#pragma once

#include <cstddef>

namespace quickstrip::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define QUICKSTRIP_UNDER_SANITIZER 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define QUICKSTRIP_UNDER_SANITIZER 1
#endif

#ifdef QUICKSTRIP_UNDER_SANITIZER
inline constexpr bool kCountsMalloc = false;
#else
inline constexpr bool kCountsMalloc = true;
#endif

class HeapGuard {
 public:
  HeapGuard();

  /// Allocations (reallocations included, releases not) of this thread since construction.
  [[nodiscard]] std::size_t allocations() const;

 private:
  std::size_t at_start_;
};

}  // namespace quickstrip::test
