// quickstrip-hull parent: motions at G by the parent program, with the columns of `motions`.
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/advice/quality.hpp"
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
  WaveOptions waves;
};

std::uint32_t quality_of(const LoadedHull& hull, const ParentResponse& response) {
  const bool is_extreme =
      depends_on_amplitude(hull.roll_damping) && !(response.roll_amplitude <= kGreatestRegularRoll);
  return speed_quality(response.wave.speed, hull.lpp, hull.gravity) |
         (response.transfer.low_encounter ? kQualityLowEncounter : 0u) |
         (is_extreme ? kQualityExtremeMotion : 0u);
}

void run(const Options& options) {
  const std::vector<GivenWave> given = given_waves(options.waves);
  const std::unique_ptr<ParentShip> ship = load_parent(options.strip, options.parent);
  std::vector<ParentWave> waves;
  for (const GivenWave& wave : given) {
    waves.push_back({wave.omega, {wrap_pi(radians(wave.mu_deg))}, from_knots(wave.speed_kn)});
  }
  std::vector<ParentResponse> responses;
  try {
    responses = ship->solve(waves, options.waves.amplitude.value_or(1.0));
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
  add_wave_options(*command, options->waves);
  command->footer(
      "The columns of `motions`, which see. --loads boundary-value needs no hull table here: the diffraction "
      "of every section is solved.");
  command->callback([options] { run(*options); });
}

}  // namespace quickstrip::hull_tool
