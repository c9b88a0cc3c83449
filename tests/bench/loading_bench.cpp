// A change of loading: the hull's coefficient table, then every transfer function of the contract's grid (25
// speeds x 37 solved directions x 48 frequencies, six degrees of freedom, and the points of the roll peak).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <memory>

#include "core/strip/loaded_hull.hpp"
#include "core/strip/transfer_functions.hpp"
#include "sim/hull_table/compile_hull_table.hpp"
#include "tests/bench/loading_work.hpp"
#include "tests/bench/machine_peak.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;

std::array<double, kMaxSpeeds> contract_speeds() {
  std::array<double, kMaxSpeeds> speeds{};
  for (std::size_t v = 0; v < speeds.size(); ++v) {
    speeds[v] = static_cast<double>(v) * kKnot;
  }
  return speeds;
}

// Wigley I of 175 m: any number of stations.
Hull wigley_ship(std::size_t stations) {
  return test::scaled(test::wigley_hull(1, stations), 175.0 / 3.0);
}

void load_and_solve(benchmark::State& state, const Hull& hull, const StripMethod& method = {},
                    const HullTable* table = nullptr) {
  const auto loaded = std::make_unique<LoadedHull>();
  const auto transfer = std::make_unique<TransferFunctions>();
  const auto work = std::make_unique<TransferWorkspace>();
  const auto speeds = contract_speeds();
  for (auto _ : state) {
    if (!load(hull, hull.loading, method, *loaded, table) ||
        !solve_transfer_functions(*loaded, speeds, *work, *transfer)) {
      state.SkipWithError("the hull is refused");
      return;
    }
  }
  std::size_t points = 0;
  for (const auto& row : transfer->peak) {
    for (const RollPeak& peak : row) {
      points += peak.num_points;
    }
  }
  const double solutions = kMaxSpeeds * kNumSolvedDirections * kMaxFrequencies;
  state.counters["sections"] = static_cast<double>(loaded->num_sections);
  state.counters["solutions"] = solutions;
  state.counters["at_roll_peaks"] = static_cast<double>(points);
  state.counters["s_per_solution"] = benchmark::Counter(
      solutions, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// The best of many against the floor: its arithmetic at the peak that the same run reaches, or its memory.
void ChangeLoadingAgainstTheFloor(benchmark::State& state) {
  const Hull hull = test::s175();
  const auto loaded = std::make_unique<LoadedHull>();
  const auto transfer = std::make_unique<TransferFunctions>();
  const auto work = std::make_unique<TransferWorkspace>();
  const auto speeds = contract_speeds();
  double best = 1e9;
  for (auto _ : state) {
    const double before = bench::processor_seconds();
    if (!load(hull, hull.loading, {}, *loaded) ||
        !solve_transfer_functions(*loaded, speeds, *work, *transfer)) {
      state.SkipWithError("the hull is refused");
      return;
    }
    best = std::min(best, bench::processor_seconds() - before);
  }
  const bench::LoadingWork needed = bench::loading_work(*loaded, *transfer);
  const double flops = bench::peak_flops();
  const double bytes = bench::peak_read_bytes(1U << 20U);
  state.counters["Mflop"] = needed.flops() * 1e-6;
  state.counters["Mflop_contours"] = needed.contours * 1e-6;
  state.counters["Mflop_sums"] = needed.sums * 1e-6;
  state.counters["Mflop_solutions"] = needed.solutions * 1e-6;
  state.counters["Mflop_peaks"] = needed.peaks * 1e-6;
  state.counters["MB"] = needed.bytes * 1e-6;
  state.counters["peak_Gflop/s"] = flops * 1e-9;
  state.counters["share_of_peak"] = needed.flops() / best / flops;
  state.counters["floor_ms"] = 1e3 * std::max(needed.flops() / flops, needed.bytes / bytes);
  state.counters["best_ms"] = 1e3 * best;
}
BENCHMARK(ChangeLoadingAgainstTheFloor)->Unit(benchmark::kMillisecond)->MinTime(2);

void ChangeLoadingOfTheS175(benchmark::State& state) {
  load_and_solve(state, test::s175());
}
BENCHMARK(ChangeLoadingOfTheS175)->Unit(benchmark::kMillisecond)->UseRealTime();

// The same by the hull's own sections and loads by boundary values.
void ChangeLoadingWithHullTable(benchmark::State& state) {
  const Hull hull = test::s175();
  const CompiledHullTable compiled =
      compile_hull_table(hull, HullSections::kLewis, {{9.25, 9.75, 10.25}, {}});
  const Result<HullTable> table = HullTable::view(compiled.words);
  StripMethod method;
  method.loads = DiffractionLoads::kBoundaryValue;
  load_and_solve(state, hull, method, &*table);
}
BENCHMARK(ChangeLoadingWithHullTable)->Unit(benchmark::kMillisecond)->UseRealTime();

void ChangeLoadingByStations(benchmark::State& state) {
  load_and_solve(state, wigley_ship(static_cast<std::size_t>(state.range(0))));
}
BENCHMARK(ChangeLoadingByStations)->Arg(24)->Arg(64)->Unit(benchmark::kMillisecond)->UseRealTime();

void LoadHull(benchmark::State& state) {
  const Hull hull = test::s175();
  const auto loaded = std::make_unique<LoadedHull>();
  for (auto _ : state) {
    benchmark::DoNotOptimize(load(hull, hull.loading, StripMethod{}, *loaded).ok());
  }
}
BENCHMARK(LoadHull)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace quickstrip
