#include "core/strip/roll_update.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/angles.hpp"
#include "core/strip/roll_admittance.hpp"
#include "core/strip/roll_damping.hpp"
#include "core/strip/roll_peak.hpp"

namespace quickstrip {
namespace {

constexpr double kHighest = 6.0;  // of the natural frequency
// Where linear roll has lost its meaning altogether: 13 degrees of RMS roll, as harmonic amplitude.
constexpr double kGreatestAmplitude = radians(25.0);
constexpr double kLeastSpan = 2.0;  // between the first and the last level, total damping

RollUpdateTable tabulate(const LoadedHull& hull, double speed, double lowest) {
  RollUpdateTable out;
  out.highest = std::max(kHighest * hull.roll_natural_frequency, 2.0 * lowest);
  out.first = lowest;
  const double step = (out.highest - lowest) / static_cast<double>(kNumRollUpdateNodes - 1);
  out.per_step = 1.0 / step;
  out.stiffness = hull.restoring.c44;
  out.inertia = hull.restoring.c44 / (hull.roll_natural_frequency * hull.roll_natural_frequency);
  for (std::size_t n = 0; n < kNumRollUpdateNodes; ++n) {
    const double omega = out.first + step * static_cast<double>(n);
    const RollAdmittance answer = roll_admittance(hull, omega, speed);
    const double rigid = out.stiffness - omega * omega * out.inertia;
    RollAnswers& node = out.node[n];
    node[kImpedanceRe] = static_cast<float>(answer.impedance.real() - rigid);
    node[kImpedanceIm] = static_cast<float>(answer.impedance.imag());
    node[kSwayRe] = static_cast<float>(answer.sway_per_roll.real());
    node[kSwayIm] = static_cast<float>(answer.sway_per_roll.imag());
    node[kYawRe] = static_cast<float>(answer.yaw_per_roll.real());
    node[kYawIm] = static_cast<float>(answer.yaw_per_roll.imag());
  }
  return out;
}

double stabiliser_damping(const LoadedHull& hull, double speed) {
  if (!hull.stabiliser) {
    return 0.0;
  }
  const double share = std::min(1.0, speed / hull.stabiliser->speed);
  return share * share * ratio_roll_damping(hull, hull.stabiliser->ratio);
}

RollDampingLevels choose_levels(const LoadedHull& hull, double speed) {
  RollDampingLevels out;
  out.added[0] = reference_roll_damping(hull.roll_damping, speed);
  out.stabiliser = stabiliser_damping(hull, speed);
  if (!depends_on_amplitude(hull.roll_damping) && !hull.stabiliser) {
    return out;
  }
  out.count = kRollDampingLevels;
  const double omega = roll_resonance(hull, speed).omega;
  out.own = std::max(0.0, roll_admittance(hull, omega, speed).impedance.imag() / omega - out.added[0]);
  const double first = out.own + out.added[0];
  const double greatest =
      added_roll_damping(hull.roll_damping, speed, kGreatestAmplitude, omega) + out.stabiliser;
  const double last = std::max(out.own + greatest, kLeastSpan * first);
  for (std::size_t l = 1; l < kRollDampingLevels; ++l) {
    const double share = static_cast<double>(l) / static_cast<double>(kRollDampingLevels - 1);
    out.added[l] = first * std::pow(last / first, share) - out.own;
  }
  return out;
}

}  // namespace

RollUpdate roll_update(const LoadedHull& hull, double speed, double lowest) {
  return {choose_levels(hull, speed), tabulate(hull, speed, lowest)};
}

}  // namespace quickstrip
