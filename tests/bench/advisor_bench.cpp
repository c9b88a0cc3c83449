// What the ship waits for: the rebuild after a change of loading, and the step of every cycle. S-175,
// contract grid (25 speeds x 72 headings, 48 frequencies), NORDFORSK criteria. Counters: solutions of the
// equations of motion and multiply-adds of the sweep per second, to set beside the processor's peak.
#include <benchmark/benchmark.h>

#include <memory>

#include "core/advice/nordforsk.hpp"
#include "core/advisor.hpp"
#include "msgs/files/hull_file.hpp"

namespace quickstrip {
namespace {

std::unique_ptr<Hull> s175() {
  auto hull = std::make_unique<Hull>();
  if (!read_hull_file(QUICKSTRIP_SOURCE_DIR "/sim/hulls/s175.hull.toml", *hull).ok()) {
    return nullptr;
  }
  return hull;
}

SeaState crossing_sea() {
  SeaState sea;
  const WaveSystem swell{
      4.0, 14.0, PeriodKind::kPeak, WaveFrom{radians(310)}, radians(20), SpectrumShape::kJonswap, 3.3};
  const WaveSystem wind{
      3.0, 8.0, PeriodKind::kPeak, WaveFrom{radians(220)}, radians(30), SpectrumShape::kBretschneider, 1.0};
  static_cast<void>(sea.systems.push_back(swell));
  static_cast<void>(sea.systems.push_back(wind));
  return sea;
}

void LoadHull(benchmark::State& state) {
  const auto hull = s175();
  const auto loaded = std::make_unique<LoadedHull>();
  for (auto _ : state) {
    benchmark::DoNotOptimize(load(*hull, hull->loading, StripMethod{}, *loaded).ok());
  }
}
BENCHMARK(LoadHull)->Unit(benchmark::kMillisecond);

void SolveTransferFunctions(benchmark::State& state) {
  const auto hull = s175();
  const auto loaded = std::make_unique<LoadedHull>();
  static_cast<void>(load(*hull, hull->loading, StripMethod{}, *loaded).ok());
  std::array<double, kMaxSpeeds> speeds{};
  for (std::size_t v = 0; v < speeds.size(); ++v) {
    speeds[v] = static_cast<double>(v) * 1852.0 / 3600.0;
  }
  const auto transfer = std::make_unique<TransferFunctions>();
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve_transfer_functions(*loaded, speeds, *transfer).ok());
  }
  state.counters["solutions/s"] =
      benchmark::Counter(static_cast<double>(kMaxSpeeds * kNumSolvedDirections * kMaxFrequencies),
                         benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(SolveTransferFunctions)->Unit(benchmark::kMillisecond);

void Step(benchmark::State& state) {
  const auto hull = s175();
  const auto advisor = std::make_unique<Advisor>();
  if (!advisor->configure(*hull, *nordforsk_merchant(*hull), StripMethod{})) {
    state.SkipWithError("the S-175 is refused");
    return;
  }
  const SeaState sea = crossing_sea();
  const OwnShip ship{Heading{radians(75)}, 7.0, false};
  StepInputs inputs;
  inputs.sea_state = &sea;
  inputs.own_ship = &ship;
  for (auto _ : state) {
    benchmark::DoNotOptimize(advisor->step(inputs).advice.present.margin);
  }
}
BENCHMARK(Step)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace quickstrip
