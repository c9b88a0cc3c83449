// How long a cycle takes, over many: S-175, 72 headings x 25 speeds, three wave systems, every response, roll
// damping found in every cell from its own roll, IMO zones (part of every cycle).
//
//   cycle_times [--cycles N] [--fifo] [--case NAME]   the least, p50, p99, p99.9 and the longest, of the wall
//       clock and of processor time, beside a spin of known work of the same length in the same run (after
//       every cycle; in a long run 5,000 in all): what the machine does to a program whose time cannot vary.
//       --fifo: real-time scheduling, where permitted.
//   cycle_times --inputs [--cycles N]    whether the time depends on the data: each case turn about with the
//       ordinary one, medians of processor time and their ratio.
// A single case under `valgrind --tool=callgrind --toggle-collect='quickstrip::Advisor::step*'` counts its
// instructions (tests/bench/count_instructions).
#include <sched.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/advisor.hpp"
#include "tests/bench/cycle_case.hpp"
#include "tests/bench/machine_peak.hpp"

namespace quickstrip::bench {
namespace {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Times {
  std::vector<double> wall;
  std::vector<double> processor;

  /// Rests for a tenth of what it took: a SCHED_FIFO program that never does is stopped by Linux for 50 ms in
  /// every second (sched_rt_runtime_us), and that is not the cycle's doing.
  template <typename Work>
  void take(const Work& work) {
    const double wall_before = wall_seconds();
    const double before = processor_seconds();
    work();
    processor.push_back(1e3 * (processor_seconds() - before));
    wall.push_back(1e3 * (wall_seconds() - wall_before));
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(0.1 * wall.back()));
  }
};

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void print_row(const char* what, const std::vector<double>& ms) {
  std::printf("%-28s %9zu %9.3f %9.3f %9.3f %9.3f %9.3f %10.2f\n", what, ms.size(), percentile(ms, 0.0),
              percentile(ms, 0.5), percentile(ms, 0.99), percentile(ms, 0.999), percentile(ms, 1.0),
              percentile(ms, 1.0) / percentile(ms, 0.5));
}

/// Registers only: what it takes beyond its least is the machine's doing.
double spin(int rounds) {
  std::array<double, 24> x{};
  volatile double factor = 0.999999;
  const double f = factor;
  for (int i = 0; i < rounds; ++i) {
    for (double& value : x) {
      value = value * f + 1e-9;
    }
  }
  return x[0] + x[23];
}

int rounds_of(double ms) {
  constexpr int kTrial = 20000;
  volatile double sink = 0.0;
  double least = 1e9;
  for (int i = 0; i < 20; ++i) {
    const double before = processor_seconds();
    sink = spin(kTrial);
    least = std::min(least, 1e3 * (processor_seconds() - before));
  }
  static_cast<void>(sink);
  return static_cast<int>(kTrial * ms / least);
}

/// Seas and ships that might cost another time than the ordinary one.
struct Named {
  const char* name;
  void (*change)(Case& at);
};

void set_heights(Case& at, double hs) {
  for (WaveSystem& system : at.sea.systems) {
    system.hs = hs;
  }
}

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

const std::array<Named, 17> kCases = {{
    {"ordinary", [](Case&) {}},
    {"hs 0.001 m", [](Case& at) { set_heights(at, 1e-3); }},
    {"hs 1e-15 m", [](Case& at) { set_heights(at, 1e-15); }},
    {"hs 1e-30 m", [](Case& at) { set_heights(at, 1e-30); }},
    {"hs 1e-100 m", [](Case& at) { set_heights(at, 1e-100); }},
    {"hs 1e-155 m: its square is denormal", [](Case& at) { set_heights(at, 1e-155); }},
    {"hs 1e-300 m: its square is 0", [](Case& at) { set_heights(at, 1e-300); }},
    {"hs denormal", [](Case& at) { set_heights(at, 5e-324); }},
    {"one system ordinary, two denormal",
     [](Case& at) {
       set_heights(at, 1e-155);
       at.sea.systems[0].hs = 3.0;
     }},
    {"hs 30 m", [](Case& at) { set_heights(at, 30.0); }},
    {"tp 1 s",
     [](Case& at) {
       for (WaveSystem& s : at.sea.systems) {
         s.period = 1.0;
       }
     }},
    {"tp 40 s",
     [](Case& at) {
       for (WaveSystem& s : at.sea.systems) {
         s.period = 40.0;
       }
     }},
    {"following sea, omega_e near 0",
     [](Case& at) {
       for (WaveSystem& s : at.sea.systems) {
         s.from = WaveFrom{radians(255.0)};
         s.spreading = radians(3.0);
         s.period = 8.0;
       }
     }},
    {"hs 0 (refused)", [](Case& at) { set_heights(at, 0.0); }},
    {"hs nan (refused)", [](Case& at) { set_heights(at, kNone); }},
    {"hs infinite (refused)", [](Case& at) { set_heights(at, kInfinite); }},
    {"heading nan (refused)", [](Case& at) { at.ship.heading.radians = kNone; }},
}};

std::unique_ptr<Case> rolling_case() {
  auto out = make_case(3);
  out->hull.roll_damping.method = RollDampingMethod::kIkeda;
  out->hull.roll_damping.bilge_keel = BilgeKeel{61.0, 114.0, 0.35};
  return out;
}

void step(Advisor& advisor, const Case& at) {
  volatile double margin = advisor.step(at.inputs).advice.present.margin;
  static_cast<void>(margin);
}

bool is_configured(Advisor& advisor, const Case& at) {
  return advisor.configure(at.hull, every_response(at.hull), StripMethod{}).ok();
}

const char* go_real_time() {
  sched_param parameter{};
  parameter.sched_priority = 50;
  if (sched_setscheduler(0, SCHED_FIFO, &parameter) != 0) {
    return "SCHED_FIFO is not permitted here: ordinary priority";
  }
  return mlockall(MCL_CURRENT | MCL_FUTURE) == 0 ? "SCHED_FIFO 50, memory locked" : "SCHED_FIFO 50";
}

// Either kind of row sees the other's caches: the spin touches no memory, so the cycle finds its own.
int time_cycles(Advisor& advisor, const Case& at, std::size_t cycles) {
  for (int i = 0; i < 3; ++i) {
    step(advisor, at);
  }
  Times probe;
  for (int i = 0; i < 20; ++i) {
    probe.take([&] { step(advisor, at); });
  }
  const int rounds = rounds_of(percentile(probe.processor, 0.5));
  Times cycle;
  Times spun;
  volatile double sink = 0.0;
  constexpr std::size_t kMostSpins = 5000;
  const std::size_t cycles_a_spin = (cycles + kMostSpins - 1) / kMostSpins;
  for (std::size_t i = 0; i < cycles; ++i) {
    cycle.take([&] { step(advisor, at); });
    if (i % cycles_a_spin == 0) {
      spun.take([&] { sink = spin(rounds); });
    }
  }
  static_cast<void>(sink);
  std::printf("%-28s %9s %9s %9s %9s %9s %9s %10s\n", "[ms]", "number", "least", "p50", "p99", "p99.9",
              "longest", "by p50");
  print_row("cycle, wall clock", cycle.wall);
  print_row("spin of known work, wall", spun.wall);
  print_row("cycle, processor", cycle.processor);
  print_row("spin, processor", spun.processor);
  return 0;
}

int compare_inputs(Advisor& advisor, const Case& ordinary, std::size_t cycles) {
  std::printf("%-36s %12s %12s %8s\n", "", "median [ms]", "ordinary", "ratio");
  for (const Named& named : kCases) {
    const auto other = rolling_case();
    named.change(*other);
    Times one;
    Times two;
    for (std::size_t i = 0; i < cycles; ++i) {
      one.take([&] { step(advisor, ordinary); });
      two.take([&] { step(advisor, *other); });
    }
    const double median = percentile(two.processor, 0.5);
    const double base = percentile(one.processor, 0.5);
    std::printf("%-36s %12.3f %12.3f %8.3f\n", named.name, median, base, median / base);
  }
  return 0;
}

struct Options {
  std::size_t cycles = 200;
  bool fifo = false;
  bool inputs = false;
  std::string name = "ordinary";
  bool understood = true;
};

Options read(int argc, char** argv) {
  Options out;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--fifo") {
      out.fifo = true;
    } else if (word == "--inputs") {
      out.inputs = true;
    } else if (word == "--cycles" && has_value) {
      out.cycles = std::strtoul(argv[++i], nullptr, 10);
    } else if (word == "--case" && has_value) {
      out.name = argv[++i];
    } else {
      out.understood = false;
    }
  }
  out.understood = out.understood && out.cycles > 0;
  return out;
}

int run(const Options& options) {
  const auto at = rolling_case();
  const auto* const named =
      std::find_if(kCases.begin(), kCases.end(), [&](const Named& n) { return options.name == n.name; });
  if (named == kCases.end()) {
    std::fprintf(stderr, "no such case; there are:\n");
    for (const Named& n : kCases) {
      std::fprintf(stderr, "  %s\n", n.name);
    }
    return 2;
  }
  const auto advisor = std::make_unique<Advisor>();
  if (!is_configured(*advisor, *at)) {
    std::fprintf(stderr, "the hull or its criteria are refused\n");
    return 1;
  }
  std::printf("%s\n", options.fifo ? go_real_time() : "ordinary priority");
  if (options.inputs) {
    return compare_inputs(*advisor, *at, options.cycles);
  }
  named->change(*at);
  return time_cycles(*advisor, *at, options.cycles);
}

}  // namespace
}  // namespace quickstrip::bench

int main(int argc, char** argv) {
  const quickstrip::bench::Options options = quickstrip::bench::read(argc, argv);
  if (!options.understood) {
    std::fprintf(stderr, "use: cycle_times [--cycles N] [--fifo] [--inputs] [--case NAME]\n");
    return 2;
  }
  return quickstrip::bench::run(options);
}
