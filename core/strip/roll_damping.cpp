#include "core/strip/roll_damping.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/angles.hpp"
#include "core/base/constants.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

namespace {

constexpr double kEddySpeed = 0.04;                      // formulas §5, of K = omega L / V
constexpr double kFrictionSpeed = 4.1;                   // of V / (omega L)
constexpr double kGreatestWaveFactor = 12.0;             // where others cut it off too (formulas §5)
constexpr double kGreatestFrequency = 1.0;               // omega-hat [Kawahara2009]
constexpr double kGreatestAmplitude = 20.0 * kPi / 180;  // of the rolls that the components were fitted to

using PressureTable = std::array<double, RollAmplitudeNodes::kCount>;

// Parabola through three neighbouring nodes, the next one from each node on: continuous, so that equations in
// it have roots. Beyond the last node, straight on.
double interpolate(const PressureTable& table, double step, double at) {
  constexpr std::size_t kLastFirst = RollAmplitudeNodes::kCount - 3;
  const double place = at / step;
  constexpr auto kEnd = static_cast<double>(RollAmplitudeNodes::kCount - 1);
  if (place >= kEnd) {
    return table.back() + (place - kEnd) * (table[kLastFirst + 2] - table[kLastFirst + 1]);
  }
  const std::size_t first = std::min(static_cast<std::size_t>(place), kLastFirst);
  const double t = place - static_cast<double>(first);
  return 0.5 * (t - 1.0) * (t - 2.0) * table[first] - t * (t - 2.0) * table[first + 1] +
         0.5 * t * (t - 1.0) * table[first + 2];
}

// What Ikeda's wave damping exceeds strip theory's own at this speed by; never less than nothing.
double wave_damping(const RollDampingModel& model, double speed, double omega) {
  if (!(model.draught > 0.0) || !(speed > 0.0)) {
    return 0.0;
  }
  const double step = kWaveNodeStep * model.natural_frequency;
  const double still = std::max(0.0, interpolate(model.wave_still, step, omega));
  const double own = still + speed * interpolate(model.wave_per_speed, step, omega);
  const double factor = ikeda_wave_speed_factor(omega, speed, model.draught, model.gravity);
  return std::max(0.0, std::min(factor, kGreatestWaveFactor) * still - own);
}

// `quadratic`: the amplitude by which damping quadratic in the rate is multiplied.
RollDampingComponents components(const RollDampingModel& model, double speed, double omega, double quadratic,
                                 double pressure) {
  RollDampingComponents out;
  out.constant = model.constant;
  if (!(model.friction > 0.0)) {
    return out;
  }
  const double length_rate = omega * model.lpp;  // V K
  const double eddy_ratio = kEddySpeed * length_rate;
  const double eddy_left = eddy_ratio * eddy_ratio / (speed * speed + eddy_ratio * eddy_ratio);
  out.friction = model.friction * std::sqrt(omega) * (1.0 + kFrictionSpeed * speed / length_rate);
  out.eddy = model.eddy * omega * quadratic * eddy_left;
  out.lift = model.lift * speed;
  out.keel_normal = omega * (model.keel_normal_0 + model.keel_normal_1 * quadratic);
  out.keel_pressure = omega * pressure;
  out.wave = wave_damping(model, speed, omega);
  return out;
}

}  // namespace

double ikeda_wave_speed_factor(double omega, double speed, double draught, double gravity) {
  const double depth = omega * omega * draught / gravity;
  const double om = omega * speed / gravity;  // Omega
  const double a1 = 1.0 + std::pow(depth, -1.2) * std::exp(-2.0 * depth);
  const double a2 = 0.5 + std::exp(-2.0 * depth) / depth;
  return 0.5 * ((a2 + 1.0) + (a2 - 1.0) * std::tanh(20.0 * (om - 0.3)) +
                (2.0 * a1 - a2 - 1.0) * std::exp(-150.0 * (om - 0.25) * (om - 0.25)));
}

RollDampingComponents roll_damping_components(const RollDampingModel& model, double speed, double amplitude,
                                              double omega) {
  return components(model, speed, omega, amplitude,
                    interpolate(model.keel_pressure, RollAmplitudeNodes::kStep, amplitude));
}

double added_roll_damping(const RollDampingModel& model, double speed, double amplitude, double omega) {
  return roll_damping_components(model, speed, amplitude, omega).sum();
}

double added_roll_damping_gaussian(const RollDampingModel& model, double speed, double rms, double omega) {
  // Energy-weighted mean amplitude of a Rayleigh distribution: E[a^3] / E[a^2] = 3/2 sqrt(pi/2) sigma.
  const double mean_amplitude = 1.5 * std::sqrt(0.5 * kPi) * rms;
  return components(model, speed, omega, mean_amplitude,
                    interpolate(model.keel_pressure_gaussian, 0.5 * RollAmplitudeNodes::kStep, rms))
      .sum();
}

double small_roll_damping(const RollDampingModel& model, double speed) {
  return added_roll_damping(model, speed, 0.0, model.natural_frequency);
}

double reference_roll_damping(const RollDampingModel& model, double speed) {
  constexpr double kReferenceAmplitude = radians(3.0);
  return added_roll_damping(model, speed, kReferenceAmplitude, model.natural_frequency);
}

bool depends_on_amplitude(const RollDampingModel& model) {
  return model.friction > 0.0;  // Ikeda's: every hull has friction and eddies
}

std::uint16_t roll_damping_outside_range(const RollDampingModel& model, double amplitude, double omega) {
  unsigned out = model.outside_range;
  if (!depends_on_amplitude(model)) {
    return 0;
  }
  if (!(omega * model.frequency_scale <= kGreatestFrequency)) {
    out |= kOutsideFrequency;
  }
  if (!(amplitude <= kGreatestAmplitude)) {
    out |= kOutsideAmplitude;
  }
  return static_cast<std::uint16_t>(out);
}

RollDampingModel constant_roll_damping(double b44, double natural_frequency) {
  RollDampingModel out;
  out.constant = b44;
  out.natural_frequency = natural_frequency;
  return out;
}

double roll_natural_frequency(const LoadedHull& hull) {
  const double dry = std::sqrt(hull.restoring.c44 / hull.body.ixx);
  // a44 > 0 about O, and about G it stays small beside I_xx: the root lies below the dry frequency unless
  // a44_G is negative, which the upper bracket covers.
  double low = 0.02 * dry;
  double high = 20.0 * dry;
  SectionHydrodynamics section;
  for (int i = 0; i < 40; ++i) {
    const double middle = std::sqrt(low * high);
    section_hydrodynamics(hull, middle, section);
    const double inertia = hull.body.ixx + integral(hull, section[kA44], 0);
    (inertia * middle * middle < hull.restoring.c44 ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

double ratio_roll_damping(const LoadedHull& hull, double ratio) {
  return 2.0 * ratio * hull.restoring.c44 / hull.roll_natural_frequency;
}

}  // namespace quickstrip
