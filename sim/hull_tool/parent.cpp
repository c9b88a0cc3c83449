// quickstrip-hull parent: motions at G by the parent program, with the columns of `motions`.
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/advice/quality.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/cli/run_tool.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/motion_rows.hpp"
#include "sim/hull_tool/parent_options.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  StripOptions strip;
  ParentChoice parent{.sections = "close-fit"};
  std::vector<double> speeds_kn;
  std::vector<double> mus_deg;
  std::vector<double> omegas;
  double wave_amplitude = 1.0;
};

std::uint32_t quality_of(const LoadedHull& hull, const ParentResponse& response) {
  const bool is_extreme =
      depends_on_amplitude(hull.roll_damping) && !(response.roll_amplitude <= kGreatestRegularRoll);
  return speed_quality(response.wave.speed, hull.lpp, hull.gravity) |
         (response.transfer.low_encounter ? kQualityLowEncounter : 0u) |
         (is_extreme ? kQualityExtremeMotion : 0u);
}

void run(const Options& options) {
  const std::unique_ptr<ParentShip> ship = load_parent(options.strip, options.parent);
  std::vector<GivenWave> given;
  std::vector<ParentWave> waves;
  for (const double speed_kn : options.speeds_kn) {
    for (const double mu_deg : options.mus_deg) {
      for (const double omega : options.omegas) {
        given.push_back({speed_kn, mu_deg, omega});
        waves.push_back({omega, {wrap_pi(radians(mu_deg))}, from_knots(speed_kn)});
      }
    }
  }
  std::vector<ParentResponse> responses;
  try {
    responses = ship->solve(waves, options.wave_amplitude);
  } catch (const std::invalid_argument& error) {
    throw InputError{options.strip.file + ": " + error.what()};
  }
  Csv csv(kMotionHeader);
  for (std::size_t i = 0; i < given.size(); ++i) {
    add_motion_row(given[i], responses[i].transfer, responses[i].added_resistance,
                   quality_of(ship->hull(), responses[i]), csv);
  }
  print_result(csv.text());
}

}  // namespace

void add_parent(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "parent", "Motions at G, the flow about every section solved at every frequency: no table");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  add_parent_choice(*command, "--sections", options->parent,
                    "sections: their contours by conformal mapping (bulbs by Frank's method), all by Frank's "
                    "method, or their Lewis forms; default close-fit");
  add_list(*command, "--speed-kn", options->speeds_kn, {0.0, 60.0}, "speeds [kn]")->required();
  add_list(*command, "--mu-deg", options->mus_deg, kDirections_deg,
           "wave directions: 0 following, 90 from starboard, 180 head [deg]")
      ->required();
  add_list(*command, "--omega", options->omegas, {1e-3, 20.0}, "wave frequencies [rad/s]")->required();
  add_number(*command, "--wave-amplitude-m", options->wave_amplitude, {1e-6, 30.0},
             "wave amplitude [m], for roll damping that depends on roll; default 1");
  command->footer(
      "The columns of `motions`, which see. --loads boundary-value needs no hull table here: the diffraction "
      "of every section is solved.");
  command->callback([options] {
    refuse_too_many("--speed-kn, --mu-deg, --omega",
                    {options->speeds_kn.size(), options->mus_deg.size(), options->omegas.size()});
    run(*options);
  });
}

}  // namespace quickstrip::hull_tool
