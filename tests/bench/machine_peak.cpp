#include "tests/bench/machine_peak.hpp"

#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <vector>

namespace quickstrip::bench {

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

namespace {

// The best of several short runs: others share the machine.
template <typename Work>
double best_rate(double amount, const Work& work) {
  double best = 0.0;
  for (int run = 0; run < 20; ++run) {
    const double start = processor_seconds();
    work();
    best = std::max(best, amount / (processor_seconds() - start));
  }
  return best;
}

}  // namespace

double peak_flops() {
  // Twelve vectors of two are in flight: enough for the latency of an addition, few enough for the registers.
  constexpr std::size_t kLanes = 24;
  constexpr int kRounds = 200000;
  std::array<double, kLanes> sums{};
  double factor = 0.999999;
  double addend = 1e-9;
  benchmark::DoNotOptimize(factor);
  benchmark::DoNotOptimize(addend);
  return best_rate(2.0 * kLanes * kRounds, [&] {
    std::array<double, kLanes> x = sums;
    for (int i = 0; i < kRounds; ++i) {
      for (double& value : x) {
        value = value * factor + addend;
      }
    }
    sums = x;
    benchmark::DoNotOptimize(sums);
  });
}

double peak_read_bytes(std::size_t block) {
  const std::vector<double> values(block / sizeof(double), 1.0);
  return best_rate(static_cast<double>(values.size() * sizeof(double)), [&] {
    std::array<double, 16> sums{};
    for (std::size_t i = 0; i + sums.size() <= values.size(); i += sums.size()) {
      for (std::size_t j = 0; j < sums.size(); ++j) {
        sums[j] += values[i + j];
      }
    }
    benchmark::DoNotOptimize(sums);
  });
}

}  // namespace quickstrip::bench
