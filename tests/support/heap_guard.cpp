#include "tests/support/heap_guard.hpp"

namespace quickstrip::test {

HeapGuard::HeapGuard() : at_start_(heap_calls_of_this_thread()) {}

std::size_t HeapGuard::allocations() const {
  return static_cast<std::size_t>(heap_calls_of_this_thread() - at_start_);
}

}  // namespace quickstrip::test
