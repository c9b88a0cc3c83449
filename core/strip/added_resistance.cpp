#include "core/strip/added_resistance.hpp"

#include <cmath>

#include "core/sea/dispersion.hpp"

namespace quickstrip {
namespace {

// Positions of the hull's very ends, from G.
double aft_end(const LoadedHull& hull) {
  return hull.x[0] - hull.taper_aft;
}
double fore_end(const LoadedHull& hull) {
  return hull.x[hull.num_sections - 1] + hull.taper_fore;
}

// wave - (constant + slope x) along the hull.
void relative_to(const LoadedHull& hull, const AlongHull& wave, Complex constant, Complex slope,
                 AlongHull& out) {
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    out.at[i] = wave.at[i] - (constant + slope * hull.x[i]);
  }
  out.aft = wave.aft - (constant + slope * aft_end(hull));
  out.fore = wave.fore - (constant + slope * fore_end(hull));
}

// Integral over the length of the slope of q times |r|^2: as integral_of_slope().
double slope_times_square(const LoadedHull& hull, const SectionValues& q, const AlongHull& r) {
  const std::size_t last = hull.num_sections - 1;
  double sum = 0.0;
  double square = std::norm(r.at[0]);
  if (hull.taper_aft > 0.0 || hull.method.end_terms) {
    sum += 0.5 * q[0] * (std::norm(r.aft) + square);
  }
  for (std::size_t i = 0; i < last; ++i) {
    const double next = std::norm(r.at[i + 1]);
    sum += 0.5 * (q[i + 1] - q[i]) * (square + next);
    square = next;
  }
  if (hull.taper_fore > 0.0 || hull.method.end_terms) {
    sum -= 0.5 * q[last] * (square + std::norm(r.fore));
  }
  return sum;
}

// Integral over the length of Re(v* (c v)_x), c by section and zero beyond the tapers.
double work_of_slope(const LoadedHull& hull, const ComplexSectionValues& c, const AlongHull& v) {
  const std::size_t last = hull.num_sections - 1;
  const auto work = [](Complex from, Complex to, Complex rise) {
    return 0.5 * (std::conj(from + to) * rise).real();
  };
  double sum = 0.0;
  Complex momentum = c[0] * v.at[0];
  if (hull.taper_aft > 0.0 || hull.method.end_terms) {
    sum += work(v.aft, v.at[0], momentum);
  }
  for (std::size_t i = 0; i < last; ++i) {
    const Complex next = c[i + 1] * v.at[i + 1];
    sum += work(v.at[i], v.at[i + 1], next - momentum);
    momentum = next;
  }
  if (hull.taper_fore > 0.0 || hull.method.end_terms) {
    sum += work(v.at[last], v.fore, -momentum);
  }
  return sum;
}

double swept_work(const LoadedHull& hull, const SectionValues& a33, const SectionValues& b33, double omega_e,
                  const AlongHull& v) {
  const bool modified = hull.method.variant == StripVariant::kModified;
  ComplexSectionValues c;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    c[i] = Complex(a33[i], modified ? -b33[i] / omega_e : 0.0);
  }
  return work_of_slope(hull, c, v);
}

}  // namespace

RadiatedPower radiated_power_of(StripVariant variant) {
  return variant == StripVariant::kModified ? RadiatedPower::kStripWork : RadiatedPower::kPublished;
}

void resistance_wave(const LoadedHull& hull, double omega, EncounterAngle mu, const SectionWaves& sections,
                     ResistanceWave& out) {
  out.omega = omega;
  out.mu = mu;
  elevation_along(hull, omega, mu, out.elevation);
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    out.velocity.at[i] = Complex(0.0, omega * sections.heave_factor[i]) * out.elevation.at[i];
  }
  // At the ends of the tapers: the end section's wave, further on its way.
  const std::size_t last = hull.num_sections - 1;
  out.velocity.aft = Complex(0.0, omega * sections.heave_factor[0]) * out.elevation.aft;
  out.velocity.fore = Complex(0.0, omega * sections.heave_factor[last]) * out.elevation.fore;
}

double added_resistance(const LoadedHull& hull, const ResistanceWave& wave, const MotionTransfer& motion,
                        double speed) {
  const double cos_mu = std::cos(wave.mu.radians);
  if (cos_mu < -kCosineOfBeam) {
    return radiated_energy_resistance(hull, wave, motion, speed, radiated_power_of(hull.method.variant));
  }
  const double behind = integrated_pressure_resistance(hull, wave, motion);
  return cos_mu > kCosineOfBeam ? behind : 0.5 * behind;
}

double radiated_energy_resistance(const LoadedHull& hull, const ResistanceWave& wave,
                                  const MotionTransfer& motion, double speed, RadiatedPower power) {
  const double omega_e = motion.encounter_frequency;
  const Complex heave = motion.motion[2];
  const Complex pitch = motion.motion[4];
  const Complex i_omega_e(0.0, omega_e);
  AlongHull v;  // V_z
  relative_to(hull, wave.velocity, i_omega_e * heave + speed * pitch, -i_omega_e * pitch, v);
  SectionValues a33;
  SectionValues b33;
  section_heave(hull, omega_e, a33, b33);
  double damped = 0.0;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    damped += hull.weight[i] * b33[i] * std::norm(v.at[i]);
  }
  const double swept = power == RadiatedPower::kPublished ? slope_times_square(hull, a33, v)
                                                          : swept_work(hull, a33, b33, omega_e, v);
  const double k = wave_number(wave.omega, hull.gravity);
  return -k * std::cos(wave.mu.radians) / (2.0 * omega_e) * (damped - speed * swept);
}

double integrated_pressure_resistance(const LoadedHull& hull, const ResistanceWave& wave,
                                      const MotionTransfer& motion) {
  AlongHull s;  // relative elevation
  relative_to(hull, wave.elevation, motion.motion[2], -motion.motion[4], s);
  return integrated_pressure_resistance(hull, slope_times_square(hull, hull.half_breadth, s), motion);
}

double integrated_pressure_resistance(const LoadedHull& hull, double slope_times_square,
                                      const MotionTransfer& motion) {
  const double omega_e = motion.encounter_frequency;
  return -0.5 * hull.density * hull.gravity * slope_times_square +
         0.5 * hull.body.mass * omega_e * omega_e * (motion.motion[2] * std::conj(motion.motion[4])).real();
}

double added_resistance(const LoadedHull& hull, double omega, EncounterAngle mu, double speed,
                        const MotionTransfer& motion) {
  SectionWaves sections;
  section_waves(hull, omega, mu, sections);
  ResistanceWave wave;
  resistance_wave(hull, omega, mu, sections, wave);
  return added_resistance(hull, wave, motion, speed);
}

}  // namespace quickstrip
