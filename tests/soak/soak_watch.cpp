// soak_watch: listens to QS_HEALTH of a live advisor for some minutes, and beside it watches the machine: a
// witness on each processor (witness.hpp), of the advisor's scheduling class where permitted and just above
// its priority. Exit 0 when nothing of the claim was broken: every missed deadline explained by time that the
// machine took away or by known work that took longer just then, resident memory and page faults flat, no
// heap calls in the cycle's thread; 1 otherwise. Figures on standard output.
//   soak_watch URL SECONDS WARM_UP_SECONDS [PAGES]
// PAGES, default 0: that may still be touched for the first time after the warm-up, in a run too short for
// that.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <thread>
#include <vector>

#include "quickstrip/health_t.hpp"
#include "tests/soak/witness.hpp"

namespace {

using quickstrip::health_t;

using quickstrip::soak::now_ns;
using quickstrip::soak::Witness;
using quickstrip::soak::WorstWindow;

WorstWindow worse(const WorstWindow& a, const WorstWindow& b) {
  return {std::max(a.taken_s, b.taken_s), std::max(a.slowness, b.slowness)};
}

struct Soak {
  std::vector<std::unique_ptr<Witness>> witnesses;
  std::int64_t warm_at = 0;
  int num_messages = 0;
  health_t first{};  // once warm
  health_t last{};
  bool is_warm = false;
  std::int64_t min_resident = INT64_MAX, max_resident = 0;
  std::int64_t machine_misses = 0, own_misses = 0;
  WorstWindow before;  // in the second before: a window may lie across two messages

  void take(const health_t& health) {
    WorstWindow worst;
    for (const auto& witness : witnesses) {
      worst = worse(worst, witness->take_worst());
    }
    if (num_messages++ > 0) {
      judge_misses(health, worse(worst, before));
    }
    before = worst;
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

  /// A cycle of mean length is late when the machine took the rest of its period, or was so slow.
  void judge_misses(const health_t& health, const WorstWindow& worst) {
    const std::int64_t misses = health.num_deadline_misses - last.num_deadline_misses;
    if (misses <= 0) {
      return;
    }
    const double rest_s = health.cycle_period_s - health.cycle_mean_s;
    const double slower_s = health.cycle_mean_s * (worst.slowness - 1.0);
    const bool is_explained = rest_s > 0.0 && worst.taken_s + slower_s >= rest_s;
    (is_explained ? machine_misses : own_misses) += misses;
    std::printf(
        "%lld missed after %lld cycles, longest so far %.2f ms; the machine took %.2f ms and %.2f by being "
        "slower, "
        "%.2f to spare%s\n",
        static_cast<long long>(misses), static_cast<long long>(health.num_cycles), 1e3 * health.cycle_max_s,
        1e3 * worst.taken_s, 1e3 * slower_s, 1e3 * rest_s, is_explained ? "" : ": NOT EXPLAINED");
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

/// A whole number >= 0; false for anything else.
bool read_count(const char* text, long& out) {
  const char* const end = text + std::strlen(text);
  const auto [at, error] = std::from_chars(text, end, out);
  return error == std::errc() && at == end && out >= 0;
}

}  // namespace

int main(int argc, char** argv) {
  long seconds = 0;
  long warm_up = 0;
  long pages = 0;
  if (argc < 4 || !read_count(argv[2], seconds) || !read_count(argv[3], warm_up) ||
      (argc > 4 && !read_count(argv[4], pages))) {
    std::fprintf(stderr, "usage: soak_watch URL SECONDS WARM_UP_SECONDS [PAGES], whole numbers\n");
    return 2;
  }
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  const std::int64_t until = now_ns() + seconds * kSecond_ns;
  constexpr int priority = 51;  // the advisor's is 50: what it takes itself is not the machine's
  lcm::LCM bus(argv[1]);
  if (!bus.good()) {
    std::fprintf(stderr, "soak_watch: %s: LCM cannot open it\n", argv[1]);
    return 1;
  }
  Soak soak;
  soak.warm_at = now_ns() + warm_up * kSecond_ns;
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
  return report(soak, pages);
}
