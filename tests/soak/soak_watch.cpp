// soak_watch: listens to QS_HEALTH of a live advisor for some minutes, and beside it measures the machine's
// own jitter: a thread on each processor, of the advisor's scheduling class where permitted and just above
// its priority, that only sleeps to absolute times, a millisecond apart. Exit 0 when nothing of the claim was
// broken: every missed deadline explained by time that the machine took away, resident memory and page faults
// flat, no heap calls in the cycle's thread; 1 otherwise. Figures on standard output.
//   soak_watch URL SECONDS WARM_UP_SECONDS [PAGES]
// PAGES, default 0: that may still be touched for the first time after the warm-up, in a run too short for
// that.
#include <pthread.h>
#include <sched.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <thread>
#include <vector>

#include "quickstrip/health_t.hpp"

namespace {

using quickstrip::health_t;

constexpr std::int64_t kTick_ns = 1'000'000;
constexpr std::int64_t kWindow_ns = 100'000'000;  // late wakes within it add up
constexpr std::int64_t kLate_ns = 200'000;        // less than that cannot make a cycle late
constexpr std::size_t kBins = 100'000;            // of a microsecond

std::int64_t now_ns() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// What one processor took away from whoever wanted to run on it.
class Witness {
 public:
  void run(unsigned cpu, int priority, const std::atomic<bool>& stop) {
    cpu_set_t cpus;
    CPU_ZERO(&cpus);
    CPU_SET(cpu, &cpus);
    pthread_setaffinity_np(pthread_self(), sizeof(cpus), &cpus);
    sched_param parameters{};
    parameters.sched_priority = priority;
    is_real_time_ = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
    std::int64_t next = now_ns() + kTick_ns;
    while (!stop.load(std::memory_order_relaxed)) {
      const timespec until{next / 1'000'000'000, next % 1'000'000'000};
      clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
      const std::int64_t now = now_ns();
      note(now, now - next);
      next += ((now - next) / kTick_ns + 1) * kTick_ns;
    }
  }

  /// The most that was taken within one window since the last call [s].
  double take_worst_window_s() { return 1e-9 * static_cast<double>(worst_window_.exchange(0)); }
  [[nodiscard]] bool is_real_time() const { return is_real_time_; }
  /// After the thread has ended.
  [[nodiscard]] double quantile_us(double part) const {
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
  [[nodiscard]] double max_us() const { return 1e-3 * static_cast<double>(max_); }

 private:
  void note(std::int64_t now, std::int64_t late) {
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
    if (sum > worst_window_.load()) {
      worst_window_.store(sum);
    }
  }

  struct Late {
    std::int64_t at = -1'000'000'000'000;
    std::int64_t by = 0;
  };
  std::array<Late, 128> recent_{};
  std::size_t num_recent_ = 0;
  std::vector<std::uint32_t> bins_ = std::vector<std::uint32_t>(kBins);
  std::int64_t max_ = 0;
  std::int64_t num_wakes_ = 0;
  std::atomic<std::int64_t> worst_window_{0};
  std::atomic<bool> is_real_time_{false};
};

struct Soak {
  std::vector<std::unique_ptr<Witness>> witnesses;
  std::int64_t warm_at = 0;
  int num_messages = 0;
  health_t first{};  // once warm
  health_t last{};
  bool is_warm = false;
  std::int64_t min_resident = INT64_MAX, max_resident = 0;
  std::int64_t machine_misses = 0, own_misses = 0;
  double stolen_before_s = 0.0;  // in the second before: a window may lie across two messages

  void take(const health_t& health) {
    double stolen_s = 0.0;
    for (const auto& witness : witnesses) {
      stolen_s = std::max(stolen_s, witness->take_worst_window_s());
    }
    if (num_messages++ > 0) {
      judge_misses(health, std::max(stolen_s, stolen_before_s));
    }
    stolen_before_s = stolen_s;
    if (!is_warm && now_ns() >= warm_at) {
      is_warm = true;
      first = health;
    }
    if (is_warm) {
      min_resident = std::min<std::int64_t>(min_resident, health.resident_bytes);
      max_resident = std::max<std::int64_t>(max_resident, health.resident_bytes);
    }
    last = health;
  }

  /// A cycle of mean length is late when the machine took the rest of its period.
  void judge_misses(const health_t& health, double stolen_s) {
    const std::int64_t misses = health.num_deadline_misses - last.num_deadline_misses;
    if (misses <= 0) {
      return;
    }
    const double rest_s = health.cycle_period_s - health.cycle_mean_s;
    const bool is_explained = rest_s > 0.0 && stolen_s >= rest_s;
    (is_explained ? machine_misses : own_misses) += misses;
    std::printf(
        "%lld missed after %lld cycles, longest so far %.2f ms; the machine took %.2f ms, %.2f to spare%s\n",
        static_cast<long long>(misses), static_cast<long long>(health.num_cycles), 1e3 * health.cycle_max_s,
        1e3 * stolen_s, 1e3 * rest_s, is_explained ? "" : ": NOT EXPLAINED");
  }
};

bool check(bool holds, const char* what) {
  std::printf("%s: %s\n", holds ? "yes" : "NO", what);
  return holds;
}

int report(const Soak& soak, long pages) {
  double p50_us = 0.0, p99_us = 0.0, max_us = 0.0;
  bool is_real_time = true;
  for (const auto& witness : soak.witnesses) {
    p50_us = std::max(p50_us, witness->quantile_us(0.5));
    p99_us = std::max(p99_us, witness->quantile_us(0.99));
    max_us = std::max(max_us, witness->max_us());
    is_real_time = is_real_time && witness->is_real_time();
  }
  const health_t& last = soak.last;
  std::printf("cycles %lld, one each %.0f ms: mean of the last 256 %.2f ms, longest %.2f ms\n",
              static_cast<long long>(last.num_cycles), 1e3 * last.cycle_period_s, 1e3 * last.cycle_mean_s,
              1e3 * last.cycle_max_s);
  std::printf("deadlines missed %lld: %lld by the machine, %lld not explained\n",
              static_cast<long long>(last.num_deadline_misses), static_cast<long long>(soak.machine_misses),
              static_cast<long long>(soak.own_misses));
  std::printf("the machine's own jitter (%s, worse processor): p50 %.0f us, p99 %.0f us, max %.0f us\n",
              is_real_time ? "SCHED_FIFO" : "ordinary priority: SCHED_FIFO not permitted", p50_us, p99_us,
              max_us);
  std::printf(
      "resident memory %lld ... %lld bytes, page faults %lld, heap calls in the cycle's thread %lld\n",
      static_cast<long long>(soak.min_resident), static_cast<long long>(soak.max_resident),
      static_cast<long long>(last.page_faults - soak.first.page_faults),
      static_cast<long long>(last.heap_calls_in_cycle));
  bool is_well = check(soak.is_warm && soak.num_messages > 1, "QS_HEALTH came");
  is_well &= check(soak.own_misses == 0, "no deadline missed that the machine did not cause");
  is_well &=
      check(soak.max_resident - soak.min_resident <= pages * sysconf(_SC_PAGESIZE) && soak.max_resident > 0,
            "resident memory flat to the page after the warm-up");
  is_well &= check(last.page_faults - soak.first.page_faults <= pages && last.page_faults > 0,
                   "page faults flat after the warm-up");
  is_well &= check(last.heap_calls_in_cycle == 0, "no heap call in the cycle's thread");
  return is_well ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: soak_watch URL SECONDS WARM_UP_SECONDS [PAGES]\n");
    return 2;
  }
  const std::int64_t until = now_ns() + static_cast<std::int64_t>(1e9 * std::atof(argv[2]));
  constexpr int priority = 51;  // the advisor's is 50: what it takes itself is not the machine's
  lcm::LCM bus(argv[1]);
  if (!bus.good()) {
    std::fprintf(stderr, "soak_watch: %s: LCM cannot open it\n", argv[1]);
    return 1;
  }
  Soak soak;
  soak.warm_at = now_ns() + static_cast<std::int64_t>(1e9 * std::atof(argv[3]));
  std::atomic<bool> stop{false};
  std::vector<std::thread> threads;
  const unsigned num_cpus = std::max(1U, std::thread::hardware_concurrency());
  for (unsigned cpu = 0; cpu < num_cpus; ++cpu) {
    soak.witnesses.push_back(std::make_unique<Witness>());
    threads.emplace_back(
        [witness = soak.witnesses.back().get(), cpu, priority, &stop] { witness->run(cpu, priority, stop); });
  }
  bus.subscribeFunction<health_t, Soak*>(
      "QS_HEALTH",
      [](const lcm::ReceiveBuffer*, const std::string&, const health_t* health, Soak* to) {
        to->take(*health);
      },
      &soak);
  while (now_ns() < until) {
    bus.handleTimeout(100);
    std::fflush(stdout);
  }
  stop = true;
  for (std::thread& thread : threads) {
    thread.join();
  }
  return report(soak, argc > 4 ? std::atol(argv[4]) : 0);
}
