// quickstrip-sim simulate HULL (--spectrum ... | --sea FILE) --hours X --seed N: counts what the statistics
// promise.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "core/strip/transfer_functions.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/quality_text.hpp"
#include "sim/sea_files/utc_time.hpp"
#include "sim/seaway/repeated_runs.hpp"
#include "sim/sim_tool/commands.hpp"
#include "sim/sim_tool/simulate_options.hpp"

namespace quickstrip::sim_tool {
namespace {

using hull_tool::ChosenSea;
using hull_tool::StripShip;

[[noreturn]] void refuse(const SimulateOptions& options, Error error) {
  throw InputError{options.strip.file + ": " + message(error)};
}

// A sea of one direction may be given relative to the ship: she then heads north.
void settle_course(SimulateOptions& options, seaway::Plan& plan) {
  if (options.mu_deg) {
    options.sea.dir_from_deg = degrees(wrap_two_pi(kPi - radians(*options.mu_deg)));
  }
  plan.heading = Heading{wrap_two_pi(radians(options.heading_deg.value_or(0.0)))};
  plan.speed = from_knots(options.speed_kn);
  plan.hours = options.hours;
  plan.steps_roll = options.steps_roll || options.roll_linear.has_value();
}

seaway::Beams beams_of(const SimulateOptions& options, const StripShip& ship, const ChosenSea& sea) {
  const auto transfer = std::make_unique<TransferFunctions>();
  choose_frequencies(*ship.loaded, *transfer);  // the range of waves that the advisor takes
  const seaway::FrequencyRange range{transfer->omega[0], transfer->omega[transfer->num_frequencies - 1]};
  Result<seaway::Beams> beams =
      sea.is_measured ? seaway::beams_of(sea.measured, range) : seaway::beams_of(sea.systems, range);
  if (!beams) {
    throw InputError{fmt::format("{}: {}; waves of {:.2f} to {:.2f} rad/s are wanted for this ship",
                                 sea.is_measured ? options.sea.sea_file : std::string("--hs-m, --t1-s"),
                                 beams.error() == Error::kOutOfRange
                                     ? std::string_view("almost no wave energy where it is looked for")
                                     : std::string_view(message(beams.error())),
                                 range.lowest, range.highest)};
  }
  return *beams;
}

// The law of roll damping: numbers of the command line, which the advisor then gets too, or what fits the
// hull's.
std::optional<seaway::EquivalentRoll> settle_roll(const SimulateOptions& options, const seaway::Plan& plan,
                                                  double damping_unit, LoadedHull& hull,
                                                  seaway::Simulation& simulation) {
  if (!plan.steps_roll) {
    return std::nullopt;
  }
  if (!options.roll_linear) {
    return fit_roll_law(hull.roll_damping, plan.speed, simulation);
  }
  simulation.law = {*options.roll_linear * damping_unit, options.roll_quadratic.value_or(0.0) * damping_unit};
  hull.roll_damping = law_model(simulation.law, hull.roll_natural_frequency);
  return equivalent_roll(simulation);
}

std::string circumstances(const SimulateOptions& options, const StripShip& ship, const ChosenSea& sea,
                          const seaway::Beams& beams) {
  const std::string from =
      sea.is_measured
          ? fmt::format("{}, {}, Hs {:.2f} m", options.sea.sea_file, format_utc(sea.utime_us), sea.hs)
          : fmt::format("{}, Hs {:g} m, T1 {:g} s, from {:g} deg, spreading {:g} deg",
                        options.sea.spectrum.shape, sea.hs, options.sea.spectrum.t1, options.sea.dir_from_deg,
                        options.sea.spectrum.spreading_deg);
  return fmt::format("{}: {:g} kn, heading {:g} deg{}; {}; {:.2f} to {:.2f} rad/s in {} directions",
                     ship.floating->hull.name.view(), options.speed_kn, options.heading_deg.value_or(0.0),
                     options.mu_deg ? fmt::format(" (mu {:g} deg)", *options.mu_deg) : std::string(), from,
                     beams.range.lowest, beams.range.highest, beams.beams.size());
}

seaway::Levels levels_of(const SimulateOptions& options) {
  seaway::Levels levels;
  for (const double level : options.roll_deg) {
    levels.roll.push_back(radians(level));
  }
  levels.accelerations = options.accelerations;
  if (!options.probabilities.empty()) {
    levels.probabilities = options.probabilities;
  }
  return levels;
}

void show_progress(std::size_t done, std::size_t all, const char* what) {
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  const std::size_t step = all / 100 + 1;
  if (terminal && (done % step == 0 || done == all)) {
    fmt::print(stderr, "\r{} of {} {}{}", done, all, what, done == all ? "\n" : "");
  }
}

// One run, written into the log when there is to be one.
seaway::Outcome run_logged(const SimulateOptions& options, const seaway::Plan& plan,
                           const seaway::Report& report, const seaway::SeaView& view,
                           seaway::Simulation& simulation) {
  seaway::MotionLog log;
  const bool is_logged = !options.log.empty();
  if (is_logged) {
    require(log.open(options.log, options.log_options, plan, *report.hull, *report.watch, view));
  }
  const auto on_block = [&](std::size_t block, const seaway::Series& series) {
    if (is_logged) {
      require(log.add_block(simulation, block, series));
    }
    show_progress(block + 1, simulation.num_blocks, "blocks");
  };
  seaway::Outcome outcome =
      seaway::run(simulation, *report.watch, only_questions(report.counts), options.seed, on_block);
  if (is_logged) {
    require(log.finish());
  }
  return outcome;
}

void run(SimulateOptions options) {
  const StripShip ship = load_strip_ship(options.strip);
  const Hull& hull = ship.floating->hull;
  Watch watch;
  if (const Status status = list_channels(hull, ship.floating->loading, ship.floating->hydrostatics,
                                          ship.loaded->method.swell_up, watch);
      !status) {
    refuse(options, status.error());
  }
  seaway::Plan plan;
  settle_course(options, plan);
  const auto sea = choose_sea(options.sea);
  const seaway::Beams beams = beams_of(options, ship, *sea);
  const seaway::SeaView view{sea->is_measured ? nullptr : &sea->systems,
                             sea->is_measured ? &sea->measured : nullptr};
  const auto ask = [&] {
    return stated(hull, *ship.loaded, watch, view, plan.heading, plan.speed, ship.quality);
  };
  auto said = ask();
  if (!said) {
    refuse(options, said.error());
  }
  if (!plan.steps_roll) {  // the ship is linear, with the damping that the advisor finds in this sea
    ship.loaded->roll_damping =
        constant_roll_damping(said->roll_damping, ship.loaded->roll_natural_frequency);
  }
  const Result<seaway::Simulation> prepared = prepare(*ship.loaded, watch, beams, plan);
  if (!prepared) {
    refuse(options, prepared.error());
  }
  seaway::Simulation simulation = *prepared;
  seaway::Report report;
  report.damping_unit = ratio_roll_damping(*ship.loaded, 1.0);
  report.roll = settle_roll(options, plan, report.damping_unit, *ship.loaded, simulation);
  if (options.roll_linear) {  // then the advisor is told of it
    said = ask();
    if (!said) {
      refuse(options, said.error());
    }
  }
  report.counts = questions_of(watch, plan.speed, *said, levels_of(options));
  report.hull = &hull;
  report.watch = &watch;
  report.simulation = &simulation;
  report.stated = &*said;
  report.hours = plan.hours;
  report.seed = options.seed;
  report.circumstances = circumstances(options, ship, *sea, beams);
  report.quality = hull_tool::quality_text(said->quality);
  const bool is_csv = options.format == "csv";
  if (options.runs > 1.0) {
    const auto runs = static_cast<std::size_t>(options.runs);
    const auto repeated = repeat_runs(simulation, watch, report.counts, options.seed, runs,
                                      [&](std::size_t done) { show_progress(done, runs, "runs"); });
    hull_tool::print_result(is_csv ? csv_of(report, repeated) : text_of(report, repeated));
    return;
  }
  if (sea->is_measured) {
    options.log_options.start_utime = sea->utime_us;
  }
  const seaway::Outcome outcome = run_logged(options, plan, report, view, simulation);
  report.outcome = &outcome;
  hull_tool::print_result(is_csv ? csv_of(report) : text_of(report));
}

}  // namespace

void add_simulate(CLI::App& app) {
  CLI::App* const command =
      app.add_subcommand("simulate", "Counts in a simulated seaway what the advisor's statistics promise");
  const auto options = std::make_shared<SimulateOptions>();
  const SimulateHandles handles = add_simulate_options(*command, options);
  command->callback([options, handles] {
    handles.check();
    run(*options);
  });
}

}  // namespace quickstrip::sim_tool
