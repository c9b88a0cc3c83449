// quickstrip-hull hydrodynamics: added mass and damping of the ship at speed, about G.
#include <memory>
#include <vector>

#include "core/strip/hydrodynamic_coefficients.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/strip_ship.hpp"

namespace quickstrip::hull_tool {
namespace {

struct Options {
  StripOptions strip;
  std::vector<double> speeds_kn;
  std::vector<double> omegas_e;
};

void run(const Options& options) {
  const StripShip ship = load_strip_ship(options.strip);
  Csv csv("speed_kn,omega_e_rad_s,i,j,a_si,b_si");
  for (const double speed_kn : options.speeds_kn) {
    for (const double omega_e : options.omegas_e) {
      const HydrodynamicCoefficients h =
          hydrodynamic_coefficients(*ship.loaded, omega_e, from_knots(speed_kn));
      for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = i % 2; j < 6; j += 2) {  // two uncoupled sets: {1,3,5} and {2,4,6}
          csv.add(speed_kn).add(omega_e).add(static_cast<int>(i) + 1).add(static_cast<int>(j) + 1);
          csv.add(h.a[i][j]).add(h.b[i][j]);
          csv.end_row();
        }
      }
    }
  }
  print_result(csv.text());
}

}  // namespace

void add_hydrodynamics(CLI::App& app) {
  CLI::App* command = app.add_subcommand("hydrodynamics", "Added mass and damping at speed, about G, SI");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  add_list(*command, "--speed-kn", options->speeds_kn, {0.0, 60.0}, "speeds [kn]")->required();
  add_list(*command, "--omega-e", options->omegas_e, {1e-3, 100.0}, "frequencies of encounter [rad/s]")
      ->required();
  command->footer(
      "Potential flow only: the added roll damping is not in b44. The V theta and V psi terms stand in a, "
      "SEAWAY's habit.");
  command->callback([options] {
    refuse_too_many("--speed-kn, --omega-e", {options->speeds_kn.size(), options->omegas_e.size(), 18});
    run(*options);
  });
}

}  // namespace quickstrip::hull_tool
