// The cycle: S-175, 72 headings x 25 speeds, 48 frequencies, wave systems with spreading. Percentiles are of
// single steps in processor time of the thread, because the machine may be shared, and the slowest also by
// the wall clock; the floor is that of the sums alone (sweep_work.hpp) against what the machine reaches in
// the same run (machine_peak.hpp).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

#include "core/advice/nordforsk.hpp"
#include "core/advisor.hpp"
#include "sim/hull_table/compile_hull_table.hpp"
#include "tests/bench/cycle_case.hpp"
#include "tests/bench/machine_peak.hpp"
#include "tests/bench/sweep_work.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

using bench::Case;
using bench::every_response;
using bench::make_case;

constexpr double kKnot = 1852.0 / 3600.0;

double percentile(std::vector<double>& sorted, double share) {
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(share * last)];
}

double step_ms(Advisor& advisor, const StepInputs& inputs) {
  const double before = bench::processor_seconds();
  benchmark::DoNotOptimize(advisor.step(inputs).advice.present.margin);
  return 1e3 * (bench::processor_seconds() - before);
}

struct Stepped {
  Advisor& advisor;
  const StepInputs& inputs;
};

/// Steps of two kinds in one run, one after the other, and their ratio.
void turn_about(benchmark::State& state, const Stepped& one, const Stepped& other) {
  std::vector<double> without;
  std::vector<double> with;
  for (auto _ : state) {
    without.push_back(step_ms(one.advisor, one.inputs));
    with.push_back(step_ms(other.advisor, other.inputs));
  }
  std::sort(without.begin(), without.end());
  std::sort(with.begin(), with.end());
  state.counters["without_p50_ms"] = percentile(without, 0.5);
  state.counters["with_p50_ms"] = percentile(with, 0.5);
  state.counters["with_p99_ms"] = percentile(with, 0.99);
  state.counters["ratio"] = percentile(with, 0.5) / percentile(without, 0.5);
}

void run(benchmark::State& state, Case& at, const Criteria& criteria) {
  const auto advisor = std::make_unique<Advisor>();
  if (!advisor->configure(at.hull, criteria, StripMethod{})) {
    state.SkipWithError("the hull or its criteria are refused");
    return;
  }
  std::vector<double> times;
  double slowest = 0.0;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    times.push_back(step_ms(*advisor, at.inputs));
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    slowest = std::max(slowest, took.count());
  }
  std::sort(times.begin(), times.end());
  state.counters["p50_ms"] = percentile(times, 0.50);
  state.counters["p99_ms"] = percentile(times, 0.99);
  state.counters["max_ms"] = times.back();
  state.counters["max_wall_ms"] = slowest;
  state.counters["MB"] = sizeof(Advisor) * 1e-6;
}

// Argument: wave systems; 0 for a measured spectrum of 47 bands.
void StepWithEveryResponse(benchmark::State& state) {
  const auto at = make_case(static_cast<std::size_t>(state.range(0)));
  run(state, *at, every_response(at->hull));
}
BENCHMARK(StepWithEveryResponse)->Arg(1)->Arg(3)->Arg(6)->Arg(0)->Unit(benchmark::kMillisecond)->MinTime(2);

void StepWithNordforsk(benchmark::State& state) {
  const auto at = make_case(static_cast<std::size_t>(state.range(0)));
  run(state, *at, *nordforsk_merchant(at->hull));
}
BENCHMARK(StepWithNordforsk)->Arg(3)->Arg(0)->Unit(benchmark::kMillisecond)->MinTime(2);

// The cycle with members of the ensemble, as a ratio to the cycle without; turn about in one run. Arguments:
// wave systems (0: measured), members a cycle.
void StepWithEnsemble(benchmark::State& state) {
  const auto alone = make_case(static_cast<std::size_t>(state.range(0)));
  alone->hull.roll_damping.method = RollDampingMethod::kIkeda;
  alone->hull.roll_damping.bilge_keel = BilgeKeel{61.0, 114.0, 0.35};
  StepInputs with_members = alone->inputs;
  with_members.ensemble_members = static_cast<std::size_t>(state.range(1));
  with_members.uncertainty.height_part.fill(0.1);
  with_members.uncertainty.period_part.fill(0.1);
  with_members.uncertainty.direction.fill(0.2);
  with_members.uncertainty.gm = 0.05;
  with_members.uncertainty.roll_damping_part = 0.2;
  const auto advisor = std::make_unique<Advisor>();
  if (!advisor->configure(alone->hull, *nordforsk_merchant(alone->hull), StripMethod{})) {
    state.SkipWithError("the hull or its criteria are refused");
    return;
  }
  turn_about(state, {*advisor, alone->inputs}, {*advisor, with_members});
}
BENCHMARK(StepWithEnsemble)
    ->Args({3, 4})
    ->Args({3, 16})
    ->Args({0, 4})
    ->Args({0, 16})
    ->Unit(benchmark::kMillisecond)
    ->MinTime(2);

// A hundred members: six steps with all sixteen and one with four, less seven steps without. Sixteen places
// are kept on board, each drawn again when its turn comes; a member costs the same whichever it is. Argument:
// wave systems (0: measured).
void SweepAHundredMembers(benchmark::State& state) {
  const auto alone = make_case(static_cast<std::size_t>(state.range(0)));
  alone->hull.roll_damping.method = RollDampingMethod::kIkeda;
  alone->hull.roll_damping.bilge_keel = BilgeKeel{61.0, 114.0, 0.35};
  StepInputs inputs = alone->inputs;
  inputs.uncertainty.height_part.fill(0.1);
  inputs.uncertainty.period_part.fill(0.1);
  inputs.uncertainty.direction.fill(0.2);
  inputs.uncertainty.gm = 0.05;
  inputs.uncertainty.roll_damping_part = 0.2;
  const auto advisor = std::make_unique<Advisor>();
  if (!advisor->configure(alone->hull, *nordforsk_merchant(alone->hull), StripMethod{})) {
    state.SkipWithError("the hull or its criteria are refused");
    return;
  }
  std::vector<double> hundred;
  for (auto _ : state) {
    double sum = 0.0;
    for (std::size_t left = 100; left > 0; left -= inputs.ensemble_members) {
      inputs.ensemble_members = std::min<std::size_t>(left, kEnsembleMembers);
      sum += step_ms(*advisor, inputs) - step_ms(*advisor, alone->inputs);
    }
    hundred.push_back(sum);
  }
  std::sort(hundred.begin(), hundred.end());
  state.counters["members"] = 100.0;
  state.counters["best_ms"] = hundred.front();
  state.counters["p50_ms"] = percentile(hundred, 0.5);
  state.counters["max_ms"] = hundred.back();
}
BENCHMARK(SweepAHundredMembers)->Arg(3)->Arg(0)->Unit(benchmark::kMillisecond)->MinTime(5);

// The cycle by the hull's own sections out of a compiled table, as a ratio to the cycle by Lewis forms; turn
// about in one run. Argument: wave systems (0: measured).
void StepWithHullTable(benchmark::State& state) {
  const auto at = make_case(static_cast<std::size_t>(state.range(0)));
  const CompiledHullTable compiled =
      compile_hull_table(at->hull, HullSections::kLewis, {{9.0, 9.5, 10.0}, {}});
  const Result<HullTable> table = HullTable::view(compiled.words);
  StripMethod by_table;
  by_table.loads = DiffractionLoads::kBoundaryValue;
  const Criteria criteria = *nordforsk_merchant(at->hull);
  const auto one = std::make_unique<Advisor>();
  const auto other = std::make_unique<Advisor>();
  if (!one->configure(at->hull, criteria, StripMethod{}) || !table ||
      !other->configure(at->hull, criteria, by_table, {}, &*table)) {
    state.SkipWithError("the hull or its table is refused");
    return;
  }
  turn_about(state, {*one, at->inputs}, {*other, at->inputs});
}
BENCHMARK(StepWithHullTable)->Arg(3)->Arg(0)->Unit(benchmark::kMillisecond)->MinTime(2);

void StepBySpeeds(benchmark::State& state) {
  const auto at = make_case(3);
  at->hull.grid.speed_to = static_cast<double>(state.range(0) - 1) * at->hull.grid.speed_step;
  at->ship.speed = at->hull.grid.speed_from;
  run(state, *at, every_response(at->hull));
}
BENCHMARK(StepBySpeeds)->Arg(5)->Arg(13)->Arg(25)->Unit(benchmark::kMillisecond);

// The cycle with roll damping found in every cell from the cell's own roll, as a ratio to the cycle with one
// ratio of critical for all; turn about in one run. Arguments: wave systems (0: measured); every response?
void StepWithRollThatDampsItself(benchmark::State& state) {
  const auto linear = make_case(static_cast<std::size_t>(state.range(0)));
  const auto itself = make_case(static_cast<std::size_t>(state.range(0)));
  itself->hull.roll_damping.stabiliser = Stabiliser{.ratio = 0.1, .speed = 5.0};
  itself->hull.roll_damping.bilge_keel = BilgeKeel{61.0, 114.0, 0.35};
  const Criteria criteria =
      state.range(1) != 0 ? every_response(linear->hull) : *nordforsk_merchant(linear->hull);
  const auto one = std::make_unique<Advisor>();
  const auto other = std::make_unique<Advisor>();
  if (!one->configure(linear->hull, criteria, StripMethod{}) ||
      !other->configure(itself->hull, criteria, StripMethod{})) {
    state.SkipWithError("the hull or its criteria are refused");
    return;
  }
  turn_about(state, {*one, linear->inputs}, {*other, itself->inputs});
}
BENCHMARK(StepWithRollThatDampsItself)
    ->Args({3, 0})
    ->Args({3, 1})
    ->Args({0, 0})
    ->Unit(benchmark::kMillisecond)
    ->MinTime(2);

/// What sweep_grid needs, filled for the S-175 on `num_frequencies` of the hull's own range.
struct Sweep {
  Sweep(const Case& at, std::size_t num_frequencies) : criteria(every_response(at.hull)) {
    static_cast<void>(load(at.hull, at.hull.loading, StripMethod{}, loaded).ok());
    choose_frequencies(loaded, transfer);
    std::vector<double> omega;
    for (std::size_t f = 0; f < num_frequencies; ++f) {
      const double place =
          static_cast<double>(f * (kMaxFrequencies - 1)) / static_cast<double>(num_frequencies - 1);
      omega.push_back(transfer.omega[static_cast<std::size_t>(place)]);
    }
    std::vector<double> speeds;
    for (std::size_t v = 0; v < kMaxSpeeds; ++v) {
      speeds.push_back(static_cast<double>(v) * kKnot);
    }
    const auto work = std::make_unique<TransferWorkspace>();
    is_ready = solve_transfer_functions(loaded, speeds, omega, *work, transfer).ok() &&
               list_channels(at.hull, at.hull.loading, loaded.hydrostatics, SwellUp::kOnboard, watch).ok();
    channels = bind_criteria(criteria, watch);
    is_ready = is_ready && (at.inputs.spectrum != nullptr ? place_on_grid(*at.inputs.spectrum, omega, sea)
                                                          : place_on_grid(at.sea, omega, sea));
    list_incident_waves(transfer, watch, waves);
  }
  [[nodiscard]] GridInputs inputs() const {
    return {.transfer = transfer,
            .watch = watch,
            .waves = waves,
            .criteria = criteria,
            .channels = channels,
            .sea = sea};
  }

  bool is_ready = false;
  Criteria criteria;
  LoadedHull loaded;
  TransferFunctions transfer;
  Watch watch;
  IncidentWaves waves;
  CriteriaChannels channels;
  SeaEnergy sea;
  GridWorkspace workspace;
  Grid grid;
};

// Arguments: wave systems (0: measured), frequencies.
void SweepAgainstTheFloor(benchmark::State& state) {
  const auto at = make_case(static_cast<std::size_t>(state.range(0)));
  const auto sweep = std::make_unique<Sweep>(*at, static_cast<std::size_t>(state.range(1)));
  if (!sweep->is_ready) {
    state.SkipWithError("the hull is refused");
    return;
  }
  const GridInputs inputs = sweep->inputs();
  double best = 1e9;
  for (auto _ : state) {
    const double before = bench::processor_seconds();
    benchmark::DoNotOptimize(sweep_grid(inputs, sweep->workspace, sweep->grid).ok());
    best = std::min(best, bench::processor_seconds() - before);
  }
  const bench::SweepWork work = bench::sweep_work(inputs);
  const double flops = bench::peak_flops();
  const double bytes = bench::peak_read_bytes(static_cast<std::size_t>(work.bytes));
  state.counters["Mflop"] = work.flops * 1e-6;
  state.counters["MB_read"] = work.bytes * 1e-6;
  state.counters["Gflop/s"] = work.flops / best * 1e-9;
  state.counters["peak_Gflop/s"] = flops * 1e-9;
  state.counters["share_of_peak"] = work.flops / best / flops;
  state.counters["floor_ms"] = 1e3 * std::max(work.flops / flops, work.bytes / bytes);
  state.counters["best_ms"] = 1e3 * best;
}
BENCHMARK(SweepAgainstTheFloor)->Args({3, 48})->Args({3, 24})->Args({0, 48})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace quickstrip
