#include "core/strip/regular_wave_roll.hpp"

#include <algorithm>
#include <cmath>

#include "core/strip/equations_of_motion.hpp"
#include "core/strip/roll_admittance.hpp"
#include "core/strip/roll_damping.hpp"

namespace quickstrip {
namespace {

constexpr int kSteps = 48;  // 2^-48 of the roll at vanishing damping: rounding

}  // namespace

RegularWaveRoll regular_wave_roll(const LoadedHull& hull, const WaveField& field, double speed,
                                  double wave_amplitude) {
  std::array<Complex, 6> load{};
  RegularWaveRoll out;
  out.transfer = motion_transfer(hull, field, speed, load);
  const double base_damping = reference_roll_damping(hull.roll_damping, speed);
  const double base_roll = wave_amplitude * std::abs(out.transfer.motion[3]);
  const double omega =
      std::max(std::fabs(out.transfer.encounter_frequency), encounter_floor(hull, field.omega));
  out.damping = base_damping;
  out.amplitude = base_roll;
  if (!depends_on_amplitude(hull.roll_damping)) {
    return out;
  }
  // |roll| at damping b: that of the base, times |D / (D + i omega (b - base))|.
  const Complex impedance = roll_admittance(hull, omega, speed).impedance;
  const auto damping_at = [&](double amplitude) {
    return added_roll_damping(hull.roll_damping, speed, amplitude, omega);
  };
  const auto roll_at = [&](double damping) {
    return base_roll * std::abs(impedance / (impedance + Complex(0.0, omega * (damping - base_damping))));
  };
  double low = 0.0;
  double high = roll_at(damping_at(0.0));
  for (int step = 0; step < kSteps; ++step) {
    const double middle = 0.5 * (low + high);
    (roll_at(damping_at(middle)) > middle ? low : high) = middle;
  }
  out.amplitude = 0.5 * (low + high);
  out.damping = damping_at(out.amplitude);
  out.outside_range = roll_damping_outside_range(hull.roll_damping, out.amplitude, omega);
  if (base_roll > 0.0) {
    out.transfer = motions_under_load(hull, field.omega, field.mu, speed, load, out.damping);
    const double roll = wave_amplitude * std::abs(out.transfer.motion[3]);
    out.residual = std::fabs(roll / out.amplitude - 1.0);
    out.amplitude = roll;
  }
  return out;
}

RegularWaveRoll regular_wave_roll(const LoadedHull& hull, double omega, EncounterAngle mu, double speed,
                                  double wave_amplitude) {
  WaveField field;
  wave_field(hull, omega, mu, field);
  return regular_wave_roll(hull, field, speed, wave_amplitude);
}

}  // namespace quickstrip
