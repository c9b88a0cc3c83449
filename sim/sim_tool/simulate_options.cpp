#include "sim/sim_tool/simulate_options.hpp"

#include "msgs/cli/list_option.hpp"

namespace quickstrip::sim_tool {
namespace {

std::uint64_t seed_of(const std::string& text) {
  constexpr std::size_t kMostDigits = 18;
  const bool is_number = !text.empty() && text.size() <= kMostDigits &&
                         text.find_first_not_of("0123456789") == std::string::npos;
  if (!is_number) {
    throw CLI::ValidationError("--seed", text + ": wanted: a whole number, 0 or more, of at most 18 digits");
  }
  return std::stoull(text);
}

void add_counting_options(CLI::App& command, SimulateOptions& options) {
  add_list(command, "--roll-deg", options.roll_deg, {0.01, 90.0}, "levels of roll that are counted [deg]");
  add_list(command, "--acceleration-m-s2", options.accelerations, {1e-4, 50.0},
           "levels of acceleration that are counted [m/s2]");
  add_list(command, "--probability", options.probabilities, {1e-6, 0.9},
           "where no levels are given: those that the advisor says are exceeded with these probabilities;\n"
           "default 0.3,0.1,0.01,0.001");
}

void add_roll_options(CLI::App& command, SimulateOptions& options) {
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

void SimulateHandles::check() const {
  sea.require_one();
  if (mu->empty() && heading->empty()) {
    throw CLI::RequiredError("--mu-deg or --heading-deg");
  }
}

SimulateHandles add_simulate_options(CLI::App& command, const std::shared_ptr<SimulateOptions>& options) {
  add_strip_options(command, options->strip);
  const hull_tool::SeaOptionHandles sea = add_sea_options(command, options->sea);
  add_number(command, "--speed-kn", options->speed_kn, {0.0, 60.0}, "speed [kn]")->required();
  CLI::Option* const mu =
      add_number(command, "--mu-deg", options->mu_deg, kDirections_deg,
                 "mean wave direction of --spectrum: 0 following, 90 from starboard, 180 head [deg]")
          ->needs(sea.shape)
          ->excludes(sea.dir_from);
  CLI::Option* const heading =
      add_number(command, "--heading-deg", options->heading_deg, kDirections_deg, "heading, true [deg]")
          ->excludes(mu);
  add_number(command, "--hours", options->hours, {0.02, seaway::kMostHours}, "simulated time [h]")
      ->required();
  command
      .add_option_function<std::string>(
          "--seed", [options](const std::string& text) { options->seed = seed_of(text); },
          "of the random numbers: the same seed, the same sea")
      ->required()
      ->type_name("N");
  CLI::Option* const runs =
      add_number(command, "--runs", options->runs, {1.0, 10'000.0},
                 "repeat with seeds N, N + 1, ...: how often the intervals hold what the "
                 "advisor states");
  add_counting_options(command, *options);
  add_roll_options(command, *options);
  command.add_option("--format", options->format, "text or csv")->check(CLI::IsMember({"text", "csv"}));
  CLI::Option* const log =
      command.add_option("--log", options->log, "LCM log to write: the sea, own ship, motions")
          ->excludes(runs);
  command.add_option("--prefix", options->log_options.prefix, "of the channel names in the log")
      ->capture_default_str()
      ->needs(log);
  add_number(command, "--own-ship-period-s", options->log_options.own_ship_period_s, {0.1, 3600.0},
             "own ship in the log every so many seconds; default 10")
      ->needs(log);
  return {sea, mu, heading};
}

}  // namespace quickstrip::sim_tool
