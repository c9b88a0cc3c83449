// quickstrip-hull motions: transfer functions of the six motions at G.
#include <memory>
#include <vector>

#include "core/advice/quality.hpp"
#include "core/strip/added_resistance.hpp"
#include "core/strip/regular_wave_roll.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/motion_rows.hpp"
#include "sim/hull_tool/strip_ship.hpp"

namespace quickstrip::hull_tool {
namespace {

constexpr double kUnitWave = 1.0;  // m

struct Options {
  StripOptions strip;
  WaveOptions waves;
};

// What this wave adds to the ship's own quality. Without a given amplitude, roll is per metre and knows no
// extremes unless its damping depends on it.
std::uint32_t roll_quality(const Options& options, const LoadedHull& hull, const RegularWaveRoll& wave) {
  const bool knows_amplitude = options.waves.amplitude || depends_on_amplitude(hull.roll_damping);
  const bool is_extreme = knows_amplitude && !(wave.amplitude <= kGreatestRegularRoll);
  return (wave.transfer.low_encounter ? kQualityLowEncounter : 0u) |
         (is_extreme ? kQualityExtremeMotion : 0u) |
         (wave.outside_range != 0 ? kQualityRollDampingRange : 0u) |
         (wave.residual <= kRegularRollResidualLimit ? 0u : kQualityRollNotConverged);
}

void run(const Options& options) {
  const std::vector<GivenWave> waves = given_waves(options.waves);
  const StripShip ship = load_strip_ship(options.strip);
  const LoadedHull& hull = *ship.loaded;
  Csv csv(kMotionHeader);
  for (const GivenWave& given : waves) {
    const double speed = from_knots(given.speed_kn);
    const EncounterAngle mu{wrap_pi(radians(given.mu_deg))};
    const RegularWaveRoll wave =
        regular_wave_roll(hull, given.omega, mu, speed, options.waves.amplitude.value_or(kUnitWave));
    add_motion_row(
        given, wave.transfer, added_resistance(hull, given.omega, mu, speed, wave.transfer),
        ship.quality | speed_quality(speed, hull.lpp, hull.gravity) | roll_quality(options, hull, wave), csv);
  }
  print_result(csv.text());
}

}  // namespace

void add_motions(CLI::App& app) {
  CLI::App* command = app.add_subcommand("motions", "Motions at G per metre of wave: amplitudes and phases");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  add_wave_options(*command, options->waves);
  command->footer(
      "response = amp cos(omega_e t + phase) for a wave crest at G at t = 0; m/m and rad/m; roll starboard "
      "down +, pitch bow down +, yaw bow to port +. added_resistance_n_m2 per metre of amplitude squared, + "
      "aft: radiated energy ahead of the beam, integrated pressure behind it. Roll damping by equal energy "
      "of the roll in this wave; quality: extreme_motion above 20 degrees of roll.");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
