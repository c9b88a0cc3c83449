// Counts the heap calls of each thread, in the programs that link this: the advisor, which tells those of its
// cycle in QS_HEALTH, and the tests.
// How: malloc, calloc, realloc and their aligned kin (and so operator new, which calls them) are replaced by
// counting wrappers over glibc's own. Under a sanitizer, which owns malloc, only operator new is counted:
// kCountsMalloc says which. Cost: one thread-local increment a call. Needs glibc.
#pragma once

#include <cstdint>

namespace quickstrip {

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

/// Allocations (reallocations included, releases not) of this thread since it began.
std::int64_t heap_calls_of_this_thread();

}  // namespace quickstrip
