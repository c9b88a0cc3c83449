// quickstrip-hull times: processor time of the program on board and of the parent for one ship, one speed and
// direction and one sea, step by step.
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "core/response/mean_added_resistance.hpp"
#include "core/response/moments.hpp"
#include "core/strip/added_resistance.hpp"
#include "core/strip/transfer_functions.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/parent_options.hpp"
#include "sim/hull_tool/spectrum_options.hpp"
#include "sim/parent/parent_course.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  StripOptions strip;
  ParentChoice parent{.sections = "close-fit"};
  SpectrumOptions spectrum;
  double speed_kn = 0.0;
  double mu_deg = 135.0;
};

struct Step {
  const char* name;
  double seconds = 0.0;
};

/// Processor time of all threads, of one of as many runs as fill a tenth of a second.
template <typename Work>
double processor_seconds(Work work) {
  constexpr double kEnough = 0.1;
  const std::clock_t start = std::clock();
  for (int runs = 1;; ++runs) {
    work();
    const double spent = static_cast<double>(std::clock() - start) / static_cast<double>(CLOCKS_PER_SEC);
    if (spent > kEnough) {
      return spent / runs;
    }
  }
}

void require(Status status) {
  if (!status) {
    throw InputError{std::string(message(status.error()))};
  }
}

/// One wave on its way through the program on board.
struct WaveWork {
  SectionWaves sections;
  SectionDiffraction diffraction;
  WaveField field;
  SectionHydrodynamics hydrodynamics;
  std::array<Complex, 6> load{};
  MotionTransfer motion;
};

struct Case {
  StripShip ship;
  double speed = 0.0;
  EncounterAngle mu;
  WaveSystem system;
  std::vector<double> omegas;
  Watch watch;
  TransferFunctions transfer;
  TransferWorkspace work;
  SeaEnergy sea;
};

void add_statistics(Case& c, std::vector<Step>& out) {
  SeaState state;
  static_cast<void>(state.systems.push_back(c.system));
  std::vector<ResponseMoments> moments(c.watch.channels.size());
  require(solve_transfer_functions(*c.ship.loaded, std::span(&c.speed, 1), c.work, c.transfer));
  out.push_back(
      {"statistics", processor_seconds([&] {
         require(place_on_grid(state, std::span(c.transfer.omega).first(c.transfer.num_frequencies), c.sea));
         const auto found = response_moments(c.transfer, c.watch, c.sea, Heading{0.0}, c.speed, moments);
         const auto resistance = mean_added_resistance(c.transfer, c.sea, Heading{0.0}, c.speed);
         require(found ? Status() : Status(found.error()));
         require(resistance ? Status() : Status(resistance.error()));
       })});
}

std::vector<Step> quick_steps(const Options& options, Case& c) {
  std::vector<Step> out;
  const LoadedHull& hull = *c.ship.loaded;
  const FloatingHull& floating = *c.ship.floating;
  const StripMethod method = hull.method;
  const HullTable* const table = c.ship.table ? &c.ship.table->view : nullptr;
  const auto again = std::make_unique<LoadedHull>();
  out.push_back({"hull load", processor_seconds([&] {
                   require(load(floating.hull, floating.loading, method, *again, table));
                   if (options.strip.roll_damping_ratio) {
                     set_roll_damping_ratio(*again, *options.strip.roll_damping_ratio);
                   }
                 })});
  std::vector<WaveWork> waves(c.omegas.size());
  const auto each = [&](const char* name, auto work) {
    out.push_back({name, processor_seconds([&] {
                     for (std::size_t f = 0; f < waves.size(); ++f) {
                       work(c.omegas[f], waves[f]);
                     }
                   })});
  };
  bool has_diffraction = false;
  each("Froude-Krilov", [&](double omega, WaveWork& w) { section_waves(hull, omega, c.mu, w.sections); });
  each("diffraction", [&](double omega, WaveWork& w) {
    has_diffraction = section_diffraction(hull, omega, c.mu, w.diffraction);
  });
  each("wave field", [&](double omega, WaveWork& w) {
    wave_field(hull, omega, c.mu, w.sections, has_diffraction ? &w.diffraction : nullptr, w.field);
  });
  each("section coefficients and loads",
       [&](double, WaveWork& w) { w.motion = motion_transfer(hull, w.field, c.speed, w.load); });
  each("ship coefficients and solution",
       [&](double omega, WaveWork& w) { w.motion = motions_under_load(hull, omega, c.mu, c.speed, w.load); });
  out[out.size() - 2].seconds -= out.back().seconds;  // which motion_transfer() does as well
  each("added resistance", [&](double omega, WaveWork& w) {
    ResistanceWave wave;
    resistance_wave(hull, omega, c.mu, w.sections, wave);
    static_cast<void>(added_resistance(hull, wave, w.motion, c.speed));
  });
  add_statistics(c, out);
  return out;
}

std::vector<Step> parent_steps(const Options& options, const Case& c) {
  std::vector<Step> out;
  StripMethod method = c.ship.loaded->method;
  method.contour = WaveContour::kOffsets;
  if (method.loads != DiffractionLoads::kClassic) {
    method.loads = DiffractionLoads::kBoundaryValue;
  }
  std::unique_ptr<ParentShip> parent;
  out.push_back({"hull load and sections",
                 processor_seconds([&] { parent = load_parent(options.strip, options.parent, method); })});
  std::unique_ptr<ParentCourse> course;
  out.push_back({"flows with loads and solution", processor_seconds([&] {
                   course = std::make_unique<ParentCourse>(*parent, c.mu, c.speed, c.omegas);
                 })});
  const Result<Spectrum> spectrum = spectrum_of(c.system);
  require(spectrum ? Status() : Status(spectrum.error()));
  out.push_back(
      {"statistics", processor_seconds([&] { static_cast<void>(course->respond(*spectrum, c.watch)); })});
  return out;
}

double sum_of(const std::vector<Step>& steps) {
  double sum = 0.0;
  for (const Step& step : steps) {
    sum += step.seconds;
  }
  return sum;
}

void add_rows(const char* program, const std::vector<Step>& steps, double parent_seconds, Csv& csv) {
  const double sum = sum_of(steps);
  const auto add = [&](const char* name, double seconds) {
    csv.add(program).add(name).add(1e3 * seconds).add(100.0 * seconds / sum);
    csv.add(100.0 * seconds / parent_seconds);
    csv.end_row();
  };
  for (const Step& step : steps) {
    add(step.name, step.seconds);
  }
  add("all", sum);
}

void run(const Options& options) {
  const auto c = std::make_unique<Case>();
  c->ship = load_strip_ship(options.strip);
  c->speed = from_knots(options.speed_kn);
  c->mu = {wrap_pi(radians(options.mu_deg))};
  c->system = options.spectrum.sea_from(WaveFrom{wrap_two_pi(kPi - c->mu.radians)}).systems[0];
  const FloatingHull& floating = *c->ship.floating;
  const LoadedHull& loaded = *c->ship.loaded;
  require(list_channels(floating.hull, floating.loading, floating.hydrostatics, loaded.method.swell_up,
                        c->watch));
  choose_frequencies(loaded, c->transfer);
  c->omegas.assign(c->transfer.omega.begin(),
                   c->transfer.omega.begin() + static_cast<std::ptrdiff_t>(c->transfer.num_frequencies));
  const std::vector<Step> quick = quick_steps(options, *c);
  const std::vector<Step> parent = parent_steps(options, *c);
  Csv csv("program,step,milliseconds,percent_of_program,percent_of_parent");
  add_rows("quick", quick, sum_of(parent), csv);
  add_rows("parent", parent, sum_of(parent), csv);
  print_result(csv.text());
}

}  // namespace

void add_times(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("times", "Processor time of the program on board and of the parent, step by step");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  add_parent_choice(*command, "--sections", options->parent, "the parent's sections; default close-fit");
  add_spectrum_options(*command, options->spectrum, true);
  add_number(*command, "--speed-kn", options->speed_kn, {0.0, 60.0}, "speed [kn]")->required();
  add_number(*command, "--mu-deg", options->mu_deg, kDirections_deg,
             "wave direction: 0 following, 90 from starboard, 180 head [deg]; default 135");
  command->footer(
      "One speed, direction and sea, all frequencies of the program on board, both programs the same. The "
      "parent with pressures on the real contours and the same loads (boundary values where METHOD has "
      "haskind).");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
