// soak_watch: listens to QS_HEALTH of a live advisor for some minutes, and beside it watches the machine: a
// witness on each processor (witness.hpp), of the advisor's scheduling class where permitted and just above
// its priority. Exit 0 when nothing of the claim was broken: every missed deadline explained by what the
// machine did, resident memory and page faults flat, no heap calls in the cycle's thread; 1 otherwise.
// Figures on standard output.
//   soak_watch URL SECONDS WARM_UP_SECONDS JOURNAL [PAGES]
// JOURNAL: the advisor's, read at the end for the deadlines that were missed. PAGES, default 0: that may
// still be touched for the first time after the warm-up, in a run too short for that.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "quickstrip/health_t.hpp"
#include "tests/soak/missed_line.hpp"
#include "tests/soak/witness.hpp"

namespace {

using quickstrip::health_t;

using quickstrip::soak::MissedLine;
using quickstrip::soak::now_ns;
using quickstrip::soak::read_missed_line;
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
  std::map<std::int64_t, WorstWindow> machine;  // by the second of the advisor's clock in which it was taken

  void take(const health_t& health) {
    WorstWindow& worst = machine[health.utime / 1'000'000];
    for (const auto& witness : witnesses) {
      worst = worse(worst, witness->take_worst());
    }
    ++num_messages;
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

  /// Whoever was told of it when: the messages come once a second, a window may lie across two.
  [[nodiscard]] WorstWindow worst_about(std::int64_t second) const {
    WorstWindow worst;
    for (auto at = machine.lower_bound(second - 1); at != machine.end() && at->first <= second + 2; ++at) {
      worst = worse(worst, at->second);
    }
    return worst;
  }
};

struct Misses {
  std::int64_t num = 0;
  std::int64_t num_lines = 0;
  std::int64_t num_own_lines = 0;  // that the machine does not explain
};

/// A cycle gives the processor up only when it is done: the time in which it did not have it was taken from
/// it. If it had it for longer than its period, a witness must have seen why: a host that stops a processor
/// without saying so, a processor that has become slower.
bool is_explained(const MissedLine& missed, const WorstWindow& worst) {
  const double beyond_ms = missed.processor_ms - missed.period_ms;
  const double slower_ms = missed.processor_ms * (1.0 - 1.0 / worst.slowness);
  return missed.num_waits == 0 && beyond_ms <= 1e3 * worst.taken_s + slower_ms;
}

std::vector<std::pair<std::string, MissedLine>> missed_lines(const char* journal) {
  std::vector<std::pair<std::string, MissedLine>> out;
  std::ifstream file(journal);
  std::string line;
  while (std::getline(file, line)) {
    if (const std::optional<MissedLine> missed = read_missed_line(line)) {
      out.emplace_back(line, *missed);
    }
  }
  return out;
}

std::int64_t num_told(const char* journal) {
  std::int64_t num = 0;
  for (const auto& [line, missed] : missed_lines(journal)) {
    num += missed.num;
  }
  return num;
}

Misses judge_misses(const Soak& soak, const char* journal) {
  // The journal tells of misses every ten seconds at most.
  for (int i = 0; i < 110 && num_told(journal) < soak.last.num_deadline_misses; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  Misses out;
  for (const auto& [line, missed] : missed_lines(journal)) {
    const WorstWindow worst = soak.worst_about(missed.second);
    const bool is_the_machines = is_explained(missed, worst);
    out.num += missed.num;
    ++out.num_lines;
    out.num_own_lines += is_the_machines ? 0 : 1;
    std::printf("%s; beside it the machine stood still for %.1f ms and was slower by %.2f%s\n", line.c_str(),
                1e3 * worst.taken_s, worst.slowness, is_the_machines ? "" : ": NOT EXPLAINED");
  }
  return out;
}

bool check(bool holds, const char* what) {
  std::printf("%s: %s\n", holds ? "yes" : "NO", what);
  return holds;
}

int report(const Soak& soak, const Misses& misses, long pages) {
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
  std::printf("deadlines missed %lld, told in %lld lines of the journal, %lld of them not explained\n",
              static_cast<long long>(last.num_deadline_misses), static_cast<long long>(misses.num_lines),
              static_cast<long long>(misses.num_own_lines));
  std::printf("the machine's own jitter (%s, worse processor): p50 %.0f us, p99 %.0f us, max %.0f us\n",
              is_real_time ? "SCHED_FIFO" : "ordinary priority: SCHED_FIFO not permitted", p50_us, p99_us,
              max_us);
  std::printf(
      "resident memory %lld ... %lld bytes, page faults %lld, heap calls in the cycle's thread %lld\n",
      static_cast<long long>(soak.min_resident), static_cast<long long>(soak.max_resident),
      static_cast<long long>(last.page_faults - soak.first.page_faults),
      static_cast<long long>(last.heap_calls_in_cycle));
  bool is_well = check(soak.is_warm && soak.num_messages > 1, "QS_HEALTH came");
  is_well &= check(misses.num >= last.num_deadline_misses, "each missed deadline told in the journal");
  is_well &= check(misses.num_own_lines == 0, "no deadline missed that the machine did not cause");
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
  if (argc < 5 || !read_count(argv[2], seconds) || !read_count(argv[3], warm_up) ||
      (argc > 5 && !read_count(argv[5], pages))) {
    std::fprintf(stderr, "usage: soak_watch URL SECONDS WARM_UP_SECONDS JOURNAL [PAGES], whole numbers\n");
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
  return report(soak, judge_misses(soak, argv[4]), pages);
}
