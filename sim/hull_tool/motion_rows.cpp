#include "sim/hull_tool/motion_rows.hpp"

#include <complex>

#include "sim/hull_tool/quality_text.hpp"

namespace quickstrip::hull_tool {

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
