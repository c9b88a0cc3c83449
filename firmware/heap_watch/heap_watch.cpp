#include "firmware/heap_watch/heap_watch.hpp"

#include <cerrno>
#include <cstdlib>
#include <new>

namespace {

// Plain thread-local data: no constructor, so it may be touched before main and inside malloc itself.
thread_local std::int64_t t_allocations = 0;

}  // namespace

namespace quickstrip {

std::int64_t heap_calls_of_this_thread() {
  return t_allocations;
}

}  // namespace quickstrip

#ifndef QUICKSTRIP_UNDER_SANITIZER

// glibc exports its own allocator under these names, so that a replacement can stand before it.
// NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp): the names are glibc's.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  ++t_allocations;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  ++t_allocations;
  return __libc_calloc(count, size);
}

void* realloc(void* block, std::size_t size) {
  ++t_allocations;
  return __libc_realloc(block, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
  ++t_allocations;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++t_allocations;
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  if (alignment % sizeof(void*) != 0 || (alignment & (alignment - 1)) != 0 || alignment == 0) {
    return EINVAL;
  }
  ++t_allocations;
  void* const found = __libc_memalign(alignment, size);
  if (found == nullptr) {
    return ENOMEM;
  }
  *block = found;
  return 0;
}
}
// NOLINTEND(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)

#else

namespace {

void* counted(std::size_t size) {
  ++t_allocations;
  void* const block = std::malloc(size == 0 ? 1 : size);
  if (block == nullptr) {
    std::abort();  // out of memory under a sanitizer: nothing left to say
  }
  return block;
}

}  // namespace

// The aligned forms stay the sanitizer's own: uncounted, and paired with its own release.
void* operator new(std::size_t size) {
  return counted(size);
}
void* operator new[](std::size_t size) {
  return counted(size);
}
void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete[](void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}
void operator delete[](void* block, std::size_t) noexcept {
  std::free(block);
}

#endif
