#include "tests/soak/witness.hpp"

#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <algorithm>
#include <numeric>

namespace quickstrip::soak {
namespace {

constexpr std::int64_t kTick_ns = 1'000'000;
constexpr std::int64_t kWindow_ns = 100'000'000;  // late wakes within it add up
constexpr std::int64_t kLate_ns = 200'000;        // less than that cannot make a cycle late
constexpr std::size_t kLeastWork = 10;            // pieces of it that tell anything of a window
constexpr int kRounds = 2'000;                    // some 5 us: half a per cent of the processor

/// Registers only; the result is used.
double known_work() {
  std::array<double, 4> x{1.0, 1.1, 1.2, 1.3};
  volatile double factor = 0.999999;
  const double f = factor;
  for (int i = 0; i < kRounds; ++i) {
    for (double& value : x) {
      value = value * f + 1e-9;
    }
  }
  return x[0] + x[1] + x[2] + x[3];
}

template <typename Value>
void raise(std::atomic<Value>& most, Value value) {
  if (value > most.load()) {
    most.store(value);
  }
}

}  // namespace

std::int64_t now_ns() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

void Witness::run(unsigned cpu, int priority, const std::atomic<bool>& stop) {
  cpu_set_t cpus;
  CPU_ZERO(&cpus);
  CPU_SET(cpu, &cpus);
  pthread_setaffinity_np(pthread_self(), sizeof(cpus), &cpus);
  sched_param parameters{};
  parameters.sched_priority = priority;
  is_real_time_ = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
  volatile double sink = 0.0;
  window_from_ = now_ns();
  std::int64_t next = window_from_ + kTick_ns;
  while (!stop.load(std::memory_order_relaxed)) {
    const timespec until{next / 1'000'000'000, next % 1'000'000'000};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
    const std::int64_t woken = now_ns();
    sink = known_work();
    const std::int64_t now = now_ns();
    note_late(woken, woken - next);
    note_work(now, now - woken);
    next += ((now - next) / kTick_ns + 1) * kTick_ns;
  }
  static_cast<void>(sink);
}

WorstWindow Witness::take_worst() {
  return {1e-9 * static_cast<double>(worst_taken_.exchange(0)), worst_slowness_.exchange(1.0)};
}

double Witness::quantile_us(double part) const {
  const double wanted = part * static_cast<double>(num_wakes_);
  double seen = 0.0;
  for (std::size_t i = 0; i < kBins; ++i) {
    seen += static_cast<double>(bins_[i]);
    if (seen >= wanted) {
      return static_cast<double>(i);
    }
  }
  return max_us();
}

void Witness::note_late(std::int64_t now, std::int64_t late) {
  max_ = std::max(max_, late);
  ++num_wakes_;
  ++bins_[std::min(static_cast<std::size_t>(late / 1000), kBins - 1)];
  if (late < kLate_ns) {
    return;
  }
  recent_[num_recent_ % recent_.size()] = {now, late};
  ++num_recent_;
  std::int64_t sum = 0;
  for (const Late& one : recent_) {
    sum += now - one.at <= kWindow_ns ? one.by : 0;
  }
  raise(worst_taken_, sum);
}

void Witness::note_work(std::int64_t now, std::int64_t took) {
  work_.push_back(took);
  if (now - window_from_ >= kWindow_ns) {
    close_window();
    window_from_ = now;
  }
}

// The median, for a piece of work that was interrupted says what a late wake says.
void Witness::close_window() {
  if (work_.size() >= kLeastWork) {
    const auto middle = work_.begin() + static_cast<std::ptrdiff_t>(work_.size() / 2);
    std::nth_element(work_.begin(), middle, work_.end());
    const auto median = static_cast<double>(*middle);
    const std::size_t known = std::min(num_windows_, medians_.size());
    if (known > 0) {
      const double usual =
          std::accumulate(medians_.begin(), medians_.begin() + static_cast<std::ptrdiff_t>(known), 0.0) /
          static_cast<double>(known);
      raise(worst_slowness_, median / usual);
    }
    medians_[num_windows_++ % medians_.size()] = median;
  }
  work_.clear();
}

}  // namespace quickstrip::soak
