// The heap guard must be able to fail: each way of taking memory is counted, and taking none counts none.
#include "tests/support/heap_guard.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace quickstrip::test {
namespace {

// The optimiser may drop an allocation whose block nobody sees; this makes the block seen.
void seen(const void* block) {
  asm volatile("" : : "g"(block) : "memory");
}

TEST(HeapGuard, CountsNothingWhereNothingIsAllocated) {
  const HeapGuard guard;
  std::array<double, 1000> on_stack{};
  seen(on_stack.data());
  EXPECT_EQ(guard.allocations(), 0U);
}

TEST(HeapGuard, CountsOperatorNew) {
  const HeapGuard guard;
  const auto one = std::make_unique<double>(1.0);
  seen(one.get());
  EXPECT_EQ(guard.allocations(), 1U);
}

TEST(HeapGuard, CountsAVectorAndALongString) {
  const HeapGuard guard;
  std::vector<int> numbers(100);
  seen(numbers.data());
  EXPECT_EQ(guard.allocations(), 1U);
  const std::string text(100, 'x');
  seen(text.data());
  EXPECT_EQ(guard.allocations(), 2U);
}

TEST(HeapGuard, CountsTheWholeMallocFamily) {
  if (!kCountsMalloc) {
    GTEST_SKIP() << "a sanitizer owns malloc: only operator new is counted in this build";
  }
  const HeapGuard guard;
  void* block = std::malloc(10);
  seen(block);
  EXPECT_EQ(guard.allocations(), 1U);
  block = std::realloc(block, 100000);
  seen(block);
  EXPECT_EQ(guard.allocations(), 2U);
  std::free(block);
  block = std::calloc(10, 10);
  seen(block);
  EXPECT_EQ(guard.allocations(), 3U);
  std::free(block);
  block = std::aligned_alloc(64, 128);
  seen(block);
  EXPECT_EQ(guard.allocations(), 4U);
  std::free(block);
  block = nullptr;
  ASSERT_EQ(posix_memalign(&block, 64, 100), 0);
  seen(block);
  EXPECT_EQ(guard.allocations(), 5U);
  std::free(block);
}

TEST(HeapGuard, LeavesOtherThreadsOut) {
  bool go = false;
  std::thread other([&go] {
    while (!__atomic_load_n(&go, __ATOMIC_ACQUIRE)) {
      std::this_thread::yield();
    }
    const std::vector<int> numbers(1000);
    seen(numbers.data());
  });
  const HeapGuard guard;  // the thread itself is made before: making one allocates here
  __atomic_store_n(&go, true, __ATOMIC_RELEASE);
  other.join();
  EXPECT_EQ(guard.allocations(), 0U);
}

}  // namespace
}  // namespace quickstrip::test
