#include "sim/hull_tool/motion_rows.hpp"

#include <complex>

#include "msgs/cli/list_option.hpp"
#include "sim/hull_tool/quality_text.hpp"

namespace quickstrip::hull_tool {

void add_wave_options(CLI::App& command, WaveOptions& options) {
  add_list(command, "--speed-kn", options.speeds_kn, {0.0, 60.0}, "speeds [kn]")->required();
  add_list(command, "--mu-deg", options.mus_deg, kDirections_deg,
           "wave directions: 0 following, 90 from starboard, 180 head [deg]")
      ->required();
  add_list(command, "--omega", options.omegas, {1e-3, 20.0}, "wave frequencies [rad/s]")->required();
  add_number(command, "--wave-amplitude-m", options.amplitude, {1e-6, 30.0},
             "wave amplitude [m], for roll damping that depends on roll; default 1");
}

std::vector<GivenWave> given_waves(const WaveOptions& options) {
  refuse_too_many("--speed-kn, --mu-deg, --omega",
                  {options.speeds_kn.size(), options.mus_deg.size(), options.omegas.size()});
  std::vector<GivenWave> waves;
  for (const double speed_kn : options.speeds_kn) {
    for (const double mu_deg : options.mus_deg) {
      for (const double omega : options.omegas) {
        waves.push_back({speed_kn, mu_deg, omega});
      }
    }
  }
  return waves;
}

void add_motion_row(const GivenWave& wave, const MotionTransfer& transfer, double added_resistance,
                    std::uint32_t quality, Csv& csv) {
  csv.add(wave.speed_kn).add(wave.mu_deg).add(wave.omega).add(transfer.encounter_frequency);
  for (const std::complex<double>& motion : transfer.motion) {
    csv.add(std::abs(motion)).add(std::arg(motion));
  }
  csv.add(added_resistance).add(quality_text(quality));
  csv.end_row();
}

}  // namespace quickstrip::hull_tool
