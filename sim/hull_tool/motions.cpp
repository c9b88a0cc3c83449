// quickstrip-hull motions: transfer functions of the six motions at G.
#include <memory>
#include <optional>
#include <vector>

#include "core/advice/quality.hpp"
#include "core/strip/added_resistance.hpp"
#include "core/strip/regular_wave_roll.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/motion_rows.hpp"
#include "sim/hull_tool/strip_ship.hpp"

namespace quickstrip::hull_tool {
namespace {

constexpr double kUnitWave = 1.0;  // m

struct Options {
  StripOptions strip;
  std::vector<double> speeds_kn;
  std::vector<double> mus_deg;
  std::vector<double> omegas;
  std::optional<double> wave_amplitude;
};

// What this wave adds to the ship's own quality. Without a given amplitude, roll is per metre and knows no
// extremes unless its damping depends on it.
std::uint32_t roll_quality(const Options& options, const LoadedHull& hull, const RegularWaveRoll& wave) {
  const bool knows_amplitude = options.wave_amplitude || depends_on_amplitude(hull.roll_damping);
  const bool is_extreme = knows_amplitude && !(wave.amplitude <= kGreatestRegularRoll);
  return (wave.transfer.low_encounter ? kQualityLowEncounter : 0u) |
         (is_extreme ? kQualityExtremeMotion : 0u) |
         (wave.outside_range != 0 ? kQualityRollDampingRange : 0u) |
         (wave.residual <= kRegularRollResidualLimit ? 0u : kQualityRollNotConverged);
}

void run(const Options& options) {
  const StripShip ship = load_strip_ship(options.strip);
  Csv csv(kMotionHeader);
  for (const double speed_kn : options.speeds_kn) {
    const double speed = from_knots(speed_kn);
    for (const double mu_deg : options.mus_deg) {
      for (const double omega : options.omegas) {
        const EncounterAngle mu{wrap_pi(radians(mu_deg))};
        const RegularWaveRoll wave =
            regular_wave_roll(*ship.loaded, omega, mu, speed, options.wave_amplitude.value_or(kUnitWave));
        add_motion_row({speed_kn, mu_deg, omega}, wave.transfer,
                       added_resistance(*ship.loaded, omega, mu, speed, wave.transfer),
                       ship.quality | speed_quality(speed, ship.loaded->lpp, ship.loaded->gravity) |
                           roll_quality(options, *ship.loaded, wave),
                       csv);
      }
    }
  }
  print_result(csv.text());
}

}  // namespace

void add_motions(CLI::App& app) {
  CLI::App* command = app.add_subcommand("motions", "Motions at G per metre of wave: amplitudes and phases");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  add_list(*command, "--speed-kn", options->speeds_kn, {0.0, 60.0}, "speeds [kn]")->required();
  add_list(*command, "--mu-deg", options->mus_deg, kDirections_deg,
           "wave directions: 0 following, 90 from starboard, 180 head [deg]")
      ->required();
  add_list(*command, "--omega", options->omegas, {1e-3, 20.0}, "wave frequencies [rad/s]")->required();
  add_number(*command, "--wave-amplitude-m", options->wave_amplitude, {1e-6, 30.0},
             "wave amplitude [m], for roll damping that depends on roll; default 1");
  command->footer(
      "response = amp cos(omega_e t + phase) for a wave crest at G at t = 0; m/m and rad/m; roll starboard "
      "down +, pitch bow down +, yaw bow to port +. added_resistance_n_m2 per metre of amplitude squared, + "
      "aft: radiated energy ahead of the beam, integrated pressure behind it. Roll damping by equal energy "
      "of "
      "the roll in this wave; quality: extreme_motion above 20 degrees of roll.");
  command->callback([options] {
    refuse_too_many("--speed-kn, --mu-deg, --omega",
                    {options->speeds_kn.size(), options->mus_deg.size(), options->omegas.size()});
    run(*options);
  });
}

}  // namespace quickstrip::hull_tool
