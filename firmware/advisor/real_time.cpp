#include "firmware/advisor/real_time.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <ctime>

namespace quickstrip {
namespace {

constexpr std::size_t kPrefaultedStackBytes = 256U << 10U;
constexpr std::size_t kStackBytes = 512U << 10U;  // above the cycle's thread's need, prefaulted or not
constexpr std::size_t kPageBytes = 4096;

std::string memory_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) != 0) {
    return "not known";
  }
  return limit.rlim_cur == RLIM_INFINITY ? "none" : fmt::format("{} kB", limit.rlim_cur >> 10U);
}

}  // namespace

void keep_threads_small() {
  mallopt(M_ARENA_MAX, 1);
  pthread_attr_t attributes;
  if (pthread_getattr_default_np(&attributes) != 0) {
    return;
  }
  pthread_attr_setstacksize(&attributes, kStackBytes);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
}

RealTimeResult lock_memory() {
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_MMAP_MAX, 0);
  if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) {
    return {true, "memory is locked"};
  }
  return {false, fmt::format("memory is not locked: {} (limit: {}; LimitMEMLOCK= or CAP_IPC_LOCK permits it)",
                             std::strerror(errno), memory_limit())};
}

RealTimeResult schedule_in_real_time(int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  if (error == 0) {
    return {true, fmt::format("the cycle runs at SCHED_FIFO {}", priority)};
  }
  return {false, fmt::format("the cycle runs at ordinary priority: SCHED_FIFO {}: {} (LimitRTPRIO= or "
                             "CAP_SYS_NICE permits it)",
                             priority, std::strerror(error))};
}

[[gnu::noinline]] void prefault_stack() {
  std::array<volatile std::byte, kPrefaultedStackBytes> stack;  // not initialised: touched below, a page each
  for (std::size_t i = 0; i < stack.size(); i += kPageBytes) {
    stack[i] = std::byte{0};
  }
}

void sleep_until(std::chrono::steady_clock::time_point when) {
  using std::chrono::nanoseconds;
  constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
  const std::int64_t ns = std::chrono::duration_cast<nanoseconds>(when.time_since_epoch()).count();
  const timespec wake{.tv_sec = ns / kNanosecondsPerSecond, .tv_nsec = ns % kNanosecondsPerSecond};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr);
}

}  // namespace quickstrip
