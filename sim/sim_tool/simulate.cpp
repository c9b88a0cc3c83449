// quickstrip-sim simulate HULL (--spectrum ... | --sea FILE) --hours X --seed N: counts what the statistics
// promise.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "core/strip/transfer_functions.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/convert/units.hpp"
#include "quickstrip/wave_spectrum_t.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/quality_text.hpp"
#include "sim/hull_tool/sea_options.hpp"
#include "sim/hull_tool/strip_ship.hpp"
#include "sim/sea_files/utc_time.hpp"
#include "sim/seaway/motion_log.hpp"
#include "sim/seaway/report.hpp"
#include "sim/sim_tool/commands.hpp"

namespace quickstrip::sim_tool {
namespace {

using hull_tool::ChosenSea;
using hull_tool::StripShip;

constexpr std::int64_t kDefaultStart = 1'577'836'800'000'000;  // 2020-01-01T00:00:00Z

struct Options {
  hull_tool::StripOptions strip;
  hull_tool::SeaOptions sea;
  double speed_kn = 0.0;
  std::optional<double> mu_deg;
  std::optional<double> heading_deg;
  double hours = 0.0;
  std::uint64_t seed = 0;
  std::vector<double> roll_deg;
  std::vector<double> accelerations;
  std::vector<double> probabilities;
  bool steps_roll = false;
  std::optional<double> roll_linear;
  std::optional<double> roll_quadratic;
  std::string format = "text";
  std::string log;
  seaway::MotionLogOptions log_options;
};

[[noreturn]] void refuse(const Options& options, Error error) {
  throw InputError{options.strip.file + ": " + message(error)};
}

// A sea of one direction may be given relative to the ship: she then heads north.
void settle_course(Options& options, seaway::Plan& plan) {
  if (options.mu_deg) {
    options.sea.dir_from_deg = degrees(wrap_two_pi(kPi - radians(*options.mu_deg)));
  }
  plan.heading = Heading{wrap_two_pi(radians(options.heading_deg.value_or(0.0)))};
  plan.speed = from_knots(options.speed_kn);
  plan.hours = options.hours;
  plan.steps_roll = options.steps_roll || options.roll_linear.has_value();
}

seaway::Beams beams_of(const Options& options, const StripShip& ship, const ChosenSea& sea) {
  const auto transfer = std::make_unique<TransferFunctions>();
  choose_frequencies(*ship.loaded, *transfer);  // the range of waves that the advisor takes
  const seaway::FrequencyRange range{transfer->omega[0], transfer->omega[transfer->num_frequencies - 1]};
  Result<seaway::Beams> beams =
      sea.is_measured ? seaway::beams_of(sea.measured, range) : seaway::beams_of(sea.systems, range);
  if (!beams) {
    throw InputError{fmt::format("{}: {} (waves of {:.2f} to {:.2f} rad/s are simulated)",
                                 sea.is_measured ? options.sea.sea_file : std::string("--hs-m, --t1-s"),
                                 message(beams.error()), range.lowest, range.highest)};
  }
  return *beams;
}

// The law of roll damping: numbers of the command line, which the advisor then gets too, or what fits the
// hull's.
std::optional<seaway::EquivalentRoll> settle_roll(const Options& options, const seaway::Plan& plan,
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

std::string circumstances(const Options& options, const StripShip& ship, const ChosenSea& sea,
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

seaway::Levels levels_of(const Options& options) {
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

void show_progress(std::size_t done, std::size_t all) {
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  const std::size_t step = all / 100 + 1;
  if (terminal && (done % step == 0 || done == all)) {
    fmt::print(stderr, "\r{} of {} blocks{}", done, all, done == all ? "\n" : "");
  }
}

void run(Options options) {
  const StripShip ship = load_strip_ship(options.strip);
  const Hull& hull = ship.floating->hull;
  Watch watch;
  if (const Status status = list_channels(hull, ship.floating->loading, ship.floating->hydrostatics, watch);
      !status) {
    refuse(options, status.error());
  }
  seaway::Plan plan;
  settle_course(options, plan);
  const auto sea = choose_sea(options.sea);
  const seaway::Beams beams = beams_of(options, ship, *sea);
  const Result<seaway::Simulation> prepared = prepare(*ship.loaded, watch, beams, plan);
  if (!prepared) {
    refuse(options, prepared.error());
  }
  seaway::Simulation simulation = *prepared;
  seaway::Report report;
  report.damping_unit = ratio_roll_damping(*ship.loaded, 1.0);
  report.roll = settle_roll(options, plan, report.damping_unit, *ship.loaded, simulation);
  const seaway::SeaView view{sea->is_measured ? nullptr : &sea->systems,
                             sea->is_measured ? &sea->measured : nullptr};
  const auto said = stated(hull, *ship.loaded, watch, view, plan.heading, plan.speed, ship.quality);
  if (!said) {
    refuse(options, said.error());
  }
  seaway::MotionLog log;
  if (!options.log.empty()) {
    options.log_options.start_utime = sea->is_measured ? sea->utime_us : kDefaultStart;
    options.log_options.spectrum_source = wave_spectrum_t::SOURCE_BUOY;
    require(log.open(options.log, options.log_options, plan, hull, watch, view));
  }
  report.counts = questions_of(watch, *said, levels_of(options));
  const seaway::Outcome outcome = seaway::run(simulation, watch, only_questions(report.counts), options.seed,
                                              [&](std::size_t block, const seaway::Series& series) {
                                                if (!options.log.empty()) {
                                                  require(log.add_block(simulation, block, series));
                                                }
                                                show_progress(block + 1, simulation.num_blocks);
                                              });
  if (!options.log.empty()) {
    require(log.finish());
  }
  report.hull = &hull;
  report.watch = &watch;
  report.simulation = &simulation;
  report.stated = &*said;
  report.outcome = &outcome;
  report.hours = plan.hours;
  report.seed = options.seed;
  report.circumstances = circumstances(options, ship, *sea, beams);
  report.quality = hull_tool::quality_text(said->quality);
  hull_tool::print_result(options.format == "csv" ? csv_of(report) : text_of(report));
}

void add_counting_options(CLI::App& command, Options& options) {
  add_list(command, "--roll-deg", options.roll_deg, {0.01, 90.0}, "levels of roll that are counted [deg]");
  add_list(command, "--acceleration-m-s2", options.accelerations, {1e-4, 50.0},
           "levels of acceleration that are counted [m/s2]");
  add_list(command, "--probability", options.probabilities, {1e-6, 0.9},
           "where no levels are given: those that the advisor says are exceeded with these probabilities;\n"
           "default 0.3,0.1,0.01,0.001");
}

void add_roll_options(CLI::App& command, Options& options) {
  command.add_flag("--quadratic-roll", options.steps_roll,
                   "integrate the hull's own roll damping in time, linear and quadratic part fitted to it");
  CLI::Option* linear =
      add_number(command, "--roll-damping-linear", options.roll_linear, {0.0, 1.0},
                 "integrate this roll damping in time instead: linear part, ratio of critical");
  add_number(command, "--roll-damping-quadratic", options.roll_quadratic, {0.0, 100.0},
             "quadratic part: ratio of critical per rad/s of roll rate, moment = -b |rate| rate")
      ->needs(linear);
}

}  // namespace

void add_simulate(CLI::App& app) {
  CLI::App* const command =
      app.add_subcommand("simulate", "Counts in a simulated seaway what the advisor's statistics promise");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  const hull_tool::SeaOptionHandles sea = add_sea_options(*command, options->sea);
  add_number(*command, "--speed-kn", options->speed_kn, {0.0, 60.0}, "speed [kn]")->required();
  CLI::Option* const mu =
      add_number(*command, "--mu-deg", options->mu_deg, kDirections_deg,
                 "mean wave direction of --spectrum: 0 following, 90 from starboard, 180 head [deg]")
          ->needs(sea.shape)
          ->excludes(sea.dir_from);
  CLI::Option* const heading =
      add_number(*command, "--heading-deg", options->heading_deg, kDirections_deg, "heading, true [deg]")
          ->excludes(mu);
  add_number(*command, "--hours", options->hours, {0.02, seaway::kMostHours}, "simulated time [h]")
      ->required();
  command->add_option("--seed", options->seed, "of the random numbers: the same seed, the same sea")
      ->required()
      ->type_name("N");
  add_counting_options(*command, *options);
  add_roll_options(*command, *options);
  command->add_option("--format", options->format, "text or csv")->check(CLI::IsMember({"text", "csv"}));
  CLI::Option* const log =
      command->add_option("--log", options->log, "LCM log to write: the sea, own ship, motions");
  command->add_option("--prefix", options->log_options.prefix, "of the channel names in the log")
      ->capture_default_str()
      ->needs(log);
  add_number(*command, "--own-ship-period-s", options->log_options.own_ship_period_s, {0.1, 3600.0},
             "own ship in the log every so many seconds; default 10")
      ->needs(log);
  command->callback([options, sea, mu, heading] {
    sea.require_one();
    if (mu->empty() && heading->empty()) {
      throw CLI::RequiredError("--mu-deg or --heading-deg");
    }
    run(*options);
  });
}

}  // namespace quickstrip::sim_tool
