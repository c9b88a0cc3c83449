// quickstrip-hull roll-damping: every component of the roll damping beyond potential theory, by speed,
// amplitude and frequency.
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/strip/hydrodynamic_coefficients.hpp"
#include "core/strip/ikeda_damping.hpp"
#include "core/strip/roll_damping.hpp"
#include "msgs/cli/list_option.hpp"
#include "msgs/convert/units.hpp"
#include "sim/hull_tool/commands.hpp"
#include "sim/hull_tool/csv.hpp"
#include "sim/hull_tool/strip_ship.hpp"

namespace quickstrip::hull_tool {
namespace {

constexpr const char* kHeader =
    "speed_kn,amplitude_deg,omega_rad_s,omega_hat,b_constant,b_friction,b_eddy,b_lift,b_keel_normal,"
    "b_keel_pressure,b_wave,b_added,b_potential,b_constant_hat,b_friction_hat,b_eddy_hat,b_lift_hat,"
    "b_keel_normal_hat,b_keel_pressure_hat,b_wave_hat,b_added_hat,b_potential_hat,added_ratio_of_critical,"
    "ikeda_wave_speed_factor,b_wave_ikeda,outside_range";

struct Options {
  StripOptions strip;
  std::vector<double> speeds_kn;
  std::vector<double> amplitudes_deg;
  std::vector<double> omegas;
};

struct Row {
  double speed_kn = 0.0;
  double amplitude_deg = 0.0;
  double omega = 0.0;
};

std::string range_text(unsigned outside) {
  struct Word {
    unsigned bit;
    const char* text;
  };
  constexpr std::array<Word, 9> kWords = {{{kOutsideBlockCoefficient, "block_coefficient"},
                                           {kOutsideMidshipCoefficient, "midship_coefficient"},
                                           {kOutsideBreadthDraught, "breadth_to_draught"},
                                           {kOutsideCentreOfGravity, "centre_of_gravity"},
                                           {kOutsideKeelBreadth, "keel_breadth"},
                                           {kOutsideKeelLength, "keel_length"},
                                           {kOutsideSectionFullness, "section_fullness"},
                                           {kOutsideFrequency, "frequency"},
                                           {kOutsideAmplitude, "amplitude"}}};
  std::string out;
  for (const Word& word : kWords) {
    if ((outside & word.bit) != 0) {
      out.append(out.empty() ? "" : "+").append(word.text);
    }
  }
  return out;
}

void add_row(const LoadedHull& hull, const Row& row, Csv& csv) {
  const double speed = from_knots(row.speed_kn);
  const double amplitude = radians(row.amplitude_deg);
  const RollDampingComponents b = roll_damping_components(hull.roll_damping, speed, amplitude, row.omega);
  const double still = hydrodynamic_coefficients(hull, row.omega, 0.0).b[3][3];
  const double potential = hydrodynamic_coefficients(hull, row.omega, speed).b[3][3];
  const double factor =
      ikeda_wave_speed_factor(row.omega, speed, hull.hydrostatics.draught_at_lcb, hull.gravity);
  const double time = std::sqrt(hull.breadth / (2.0 * hull.gravity));
  const double unit = hull.body.mass * hull.breadth * hull.breadth / time;
  const double critical = 2.0 * hull.restoring.c44 / hull.roll_natural_frequency;
  csv.add(row.speed_kn).add(row.amplitude_deg).add(row.omega).add(row.omega * time);
  const std::array<double, 9> parts = {b.constant,      b.friction, b.eddy,  b.lift,   b.keel_normal,
                                       b.keel_pressure, b.wave,     b.sum(), potential};
  for (const double part : parts) {
    csv.add(part);
  }
  for (const double part : parts) {
    csv.add(part / unit);
  }
  csv.add(b.sum() / critical);
  csv.add(factor).add(still * factor - potential);
  csv.add(range_text(roll_damping_outside_range(hull.roll_damping, amplitude, row.omega)));
  csv.end_row();
}

void run(const Options& options) {
  const StripShip ship = load_strip_ship(options.strip);
  const std::vector<double> omegas =
      options.omegas.empty() ? std::vector<double>{ship.loaded->roll_natural_frequency} : options.omegas;
  Csv csv(kHeader);
  for (const double speed_kn : options.speeds_kn) {
    for (const double amplitude_deg : options.amplitudes_deg) {
      for (const double omega : omegas) {
        add_row(*ship.loaded, {speed_kn, amplitude_deg, omega}, csv);
      }
    }
  }
  print_result(csv.text());
}

}  // namespace

void add_roll_damping(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("roll-damping", "Components of roll damping: friction, eddies, lift, bilge keels");
  const auto options = std::make_shared<Options>();
  add_strip_options(*command, options->strip);
  add_list(*command, "--speed-kn", options->speeds_kn, {0.0, 60.0}, "speeds [kn]")->required();
  add_list(*command, "--amplitude-deg", options->amplitudes_deg, {0.0, 45.0}, "roll amplitudes [deg]")
      ->required();
  add_list(*command, "--omega", options->omegas, {1e-3, 20.0},
           "roll frequencies [rad/s]; default: the natural one");
  command->footer(
      "Equivalent linear b44 [N m s] by equal energy over a harmonic roll; hats by rho nabla B^2 sqrt(2g/B). "
      "b_potential: strip theory's own b44 at this speed, about G. Ikeda's factor of speed on that at V = 0 "
      "makes b_wave_ikeda more; b_wave is what of it is applied.");
  command->callback([options] {
    refuse_too_many("--speed-kn, --amplitude-deg, --omega",
                    {options->speeds_kn.size(), options->amplitudes_deg.size(), options->omegas.size() + 1});
    run(*options);
  });
}

}  // namespace quickstrip::hull_tool
