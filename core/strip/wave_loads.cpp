#include "core/strip/wave_loads.hpp"

#include <algorithm>
#include <cmath>

#include "core/sea/dispersion.hpp"
#include "core/strip/boundary_value.hpp"
#include "core/strip/froude_krilov.hpp"

namespace quickstrip {
namespace {

constexpr Complex kI(0.0, 1.0);

// Values of g at the hull's very ends, beyond the first and the last section by the tapers.
struct EndValues {
  Complex aft;
  Complex fore;
};

// Weights that turn values g(x_i) into the integral of a_x g over the length, given the a_i: the sum of a_i
// times the result. Summation by parts of the trapezoidal rule; at an end without taper a jumps, which end
// terms include.
void slope_weights(const LoadedHull& hull, const ComplexSectionValues& g, const EndValues& end,
                   ComplexSectionValues& out) {
  const std::size_t last = hull.num_sections - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const Complex before = i > 0 ? 0.5 * (g[i - 1] + g[i]) : Complex(0.0);
    const Complex after = i < last ? 0.5 * (g[i] + g[i + 1]) : Complex(0.0);
    out[i] = before - after;
  }
  if (hull.taper_aft > 0.0 || hull.method.end_terms) {
    out[0] += 0.5 * (g[0] + end.aft);
  }
  if (hull.taper_fore > 0.0 || hull.method.end_terms) {
    out[last] -= 0.5 * (g[last] + end.fore);
  }
}

// Two partial sums, in a fixed order: half the latency of one.
Complex dot(const LoadedHull& hull, const SectionValues& a, const ComplexSectionValues& q) {
  Complex even = 0.0;
  Complex odd = 0.0;
  std::size_t i = 0;
  for (; i + 1 < hull.num_sections; i += 2) {
    even += a[i] * q[i];
    odd += a[i + 1] * q[i + 1];
  }
  if (i < hull.num_sections) {
    even += a[i] * q[i];
  }
  return even + odd;
}

// Diffraction load of coefficients a, b under the velocity gathered in Q and R (formulas §6):
// ordinary  a zdd + (b - V a_x) zd,  modified  (a + V b_x/(omega omega_e)) zdd + ((omega/omega_e) b - V a_x)
// zd, with zdd = i omega zd: the wave frequency, not the frequency of encounter.
Complex diffraction(const LoadedHull& hull, const SectionValues& a, const SectionValues& b,
                    const ComplexSectionValues& velocity, const ComplexSectionValues& velocity_slope,
                    double omega, double omega_e, double speed) {
  const Complex inertia = kI * omega * dot(hull, a, velocity);
  const Complex slope = speed * dot(hull, a, velocity_slope);
  const Complex drag = dot(hull, b, velocity);
  if (hull.method.variant == StripVariant::kOrdinary) {
    return inertia + drag - slope;
  }
  return inertia + omega / omega_e * drag - slope + kI * speed / omega_e * dot(hull, b, velocity_slope);
}

// Of each section's place: crest there, and beyond the ends of the tapers.
struct Phases {
  ComplexSectionValues at{};
  Complex on_aft;   // from the first section on
  Complex on_fore;  // from the last
  double sin_mu = 0.0;
};

void phases(const LoadedHull& hull, double k, EncounterAngle mu, Phases& out) {
  const double along = k * std::cos(mu.radians);
  out.sin_mu = std::sin(mu.radians);
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    out.at[i] = std::polar(1.0, -along * hull.x[i]);
  }
  out.on_aft = std::polar(1.0, along * hull.taper_aft);
  out.on_fore = std::polar(1.0, -along * hull.taper_fore);
}

// Weighted velocities, plain and times x, and their weights against a slope. `at`: orbital velocity by
// section.
void set_velocity(const LoadedHull& hull, const Phases& phase, const ComplexSectionValues& at,
                  std::array<ComplexSectionValues, 2>& velocity,
                  std::array<ComplexSectionValues, 2>& velocity_slope) {
  // At the ends of the tapers: the end section's wave, further on its way.
  const std::size_t last = hull.num_sections - 1;
  const double x_aft = hull.x[0] - hull.taper_aft;
  const double x_fore = hull.x[last] + hull.taper_fore;
  const EndValues end{phase.on_aft * at[0], phase.on_fore * at[last]};
  ComplexSectionValues times_x;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    times_x[i] = hull.x[i] * at[i];
    velocity[0][i] = hull.weight[i] * at[i];
    velocity[1][i] = hull.weight[i] * times_x[i];
  }
  slope_weights(hull, at, end, velocity_slope[0]);
  slope_weights(hull, times_x, {x_aft * end.aft, x_fore * end.fore}, velocity_slope[1]);
}

// The orbital velocity at the surface made that of an equivalent motion, by section. A slope then acts on the
// coefficient and the factor together: the momentum of the restrained section's own flow.
void scale_velocity(const LoadedHull& hull, const ComplexSectionValues& factor,
                    std::array<ComplexSectionValues, 2>& velocity,
                    std::array<ComplexSectionValues, 2>& velocity_slope) {
  for (std::size_t n = 0; n < 2; ++n) {
    for (std::size_t i = 0; i < hull.num_sections; ++i) {
      velocity[n][i] *= factor[i];
      velocity_slope[n][i] *= factor[i];
    }
  }
}

void set_longitudinal(const LoadedHull& hull, const Phases& phase, const SectionWaves& sections,
                      const SectionDiffraction* diffraction, WaveField& out) {
  const bool is_solved = diffraction != nullptr && hull.method.loads == DiffractionLoads::kBoundaryValue;
  ComplexSectionValues velocity;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const double x = hull.x[i];
    const Complex weighted = hull.weight[i] * phase.at[i];
    const Complex x1 = weighted * kI * sections.surge[i] * (1.0 + hull.surge_added_mass_factor);
    const Complex x3 = weighted * sections.heave[i];
    out.froude_krilov[0] += x1;
    out.froude_krilov[2] += x3;
    out.froude_krilov[4] += -x * x3 - hull.centroid_below_g[i] * x1;
    const double factor = is_solved ? 1.0 : sections.heave_factor[i];
    velocity[i] = kI * out.omega * factor * phase.at[i];  // zd_3 = i omega factor
    if (diffraction != nullptr && !is_solved) {
      const Complex dx3 = weighted * phase.sin_mu * phase.sin_mu * diffraction->heave[i];
      out.beam_correction[2] += dx3;
      out.beam_correction[4] -= x * dx3;
    }
  }
  set_velocity(hull, phase, velocity, out.heave_velocity, out.heave_velocity_slope);
  if (is_solved) {
    scale_velocity(hull, diffraction->heave, out.heave_velocity, out.heave_velocity_slope);
  }
}

void set_lateral(const LoadedHull& hull, const Phases& phase, const SectionWaves& sections,
                 const SectionDiffraction* diffraction, WaveField& out) {
  const bool is_solved = diffraction != nullptr && hull.method.loads == DiffractionLoads::kBoundaryValue;
  ComplexSectionValues velocity;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const double x = hull.x[i];
    const Complex weighted = hull.weight[i] * phase.at[i];
    const Complex x2 = weighted * kI * sections.sway[i];
    out.froude_krilov[1] += x2;
    out.froude_krilov[3] += -kI * weighted * sections.roll[i] + (hull.g_height + hull.roll_lever_shift) * x2;
    out.froude_krilov[5] += x * x2;
    // zd_2 = i omega (-i sin mu factor).
    const double factor = is_solved ? 1.0 : sections.horizontal_factor[i];
    velocity[i] = out.omega * phase.sin_mu * factor * phase.at[i];
    if (diffraction != nullptr && !is_solved) {
      const Complex dx2 = weighted * phase.sin_mu * diffraction->sway[i];
      out.beam_correction[1] += dx2;
      out.beam_correction[3] += weighted * phase.sin_mu * diffraction->roll[i];
      out.beam_correction[5] += x * dx2;
    }
  }
  set_velocity(hull, phase, velocity, out.sway_velocity, out.sway_velocity_slope);
  if (is_solved) {
    for (std::size_t i = 0; i < hull.num_sections; ++i) {
      out.roll_velocity[i] = out.sway_velocity[0][i] * diffraction->roll[i];
      out.roll_velocity_slope[i] = out.sway_velocity_slope[0][i] * diffraction->roll[i];
    }
    scale_velocity(hull, diffraction->sway, out.sway_velocity, out.sway_velocity_slope);
  }
}

void start_field(double omega, EncounterAngle mu, WaveField& out) {
  out.omega = omega;
  out.mu = mu;
  out.froude_krilov = {};
  out.beam_correction = {};
}

// Oblique weight of the sway, yaw and roll corrections: empirical, chosen on the S-175 (formulas §6).
double oblique_weight(const WaveField& field, double omega_e) {
  return std::min(1.0, std::fabs(omega_e) / field.omega);
}

// The correction is a diffraction load, so its lever is that of [STF1970], x + V / (i omega_e). With the
// oblique weight it stays finite where omega_e vanishes.
Complex speed_lever(double omega_e, double speed) {
  return speed / (kI * omega_e);
}

bool is_corrected(const LoadedHull& hull) {
  return hull.method.loads == DiffractionLoads::kHaskind &&
         hull.method.beam_loads == BeamLoads::kRadiatedWave;
}

void add_lateral_loads(const LoadedHull& hull, const WaveField& field, const SectionHydrodynamics& section,
                       double omega_e, double speed, std::array<Complex, 6>& load) {
  const auto sway = [&](std::size_t n, StripQuantity a, StripQuantity b) {
    return diffraction(hull, section[a], section[b], field.sway_velocity[n], field.sway_velocity_slope[n],
                       field.omega, omega_e, speed);
  };
  std::array<Complex, 3> diffracted = {sway(0, kA22, kB22), sway(0, kA24, kB24), sway(1, kA22, kB22)};
  if (hull.method.loads == DiffractionLoads::kBoundaryValue) {
    diffracted[1] += diffraction(hull, section[kA22], section[kB22], field.roll_velocity,
                                 field.roll_velocity_slope, field.omega, omega_e, speed);
  }
  const double weight = oblique_weight(field, omega_e);
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t i = 2 * n + 1;
    load[i] = field.froude_krilov[i] + diffracted[n] + weight * field.beam_correction[i];
  }
  if (is_corrected(hull)) {
    load[5] += weight * speed_lever(omega_e, speed) * field.beam_correction[1];
  }
}

}  // namespace

bool section_diffraction(const LoadedHull& hull, double omega, EncounterAngle mu, SectionDiffraction& out) {
  switch (hull.method.loads) {
    case DiffractionLoads::kHaskind:
      beam_sea_correction(hull, omega, out);
      return true;
    case DiffractionLoads::kBoundaryValue:
      boundary_value_motions(hull, {&omega, 1}, mu, {&out, 1});
      return true;
    case DiffractionLoads::kClassic:
      break;
  }
  return false;
}

void section_waves(const LoadedHull& hull, double omega, EncounterAngle mu, SectionWaves& out) {
  const double k = wave_number(omega, hull.gravity);
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const FroudeKrilov fk =
        froude_krilov(hull.wave_contour[i].view(), hull.half_breadth[i], hull.density, hull.gravity, k, mu);
    out.surge[i] = fk.surge;
    out.sway[i] = fk.sway;
    out.heave[i] = fk.heave;
    out.roll[i] = fk.roll;
    out.heave_factor[i] = fk.heave_factor;
    out.horizontal_factor[i] = fk.horizontal_factor;
  }
}

void wave_field(const LoadedHull& hull, double omega, EncounterAngle mu, const SectionWaves& sections,
                const SectionDiffraction* diffraction, WaveField& out) {
  Phases phase;
  phases(hull, wave_number(omega, hull.gravity), mu, phase);
  start_field(omega, mu, out);
  set_longitudinal(hull, phase, sections, diffraction, out);
  set_lateral(hull, phase, sections, diffraction, out);
}

void lateral_wave_field(const LoadedHull& hull, double omega, EncounterAngle mu, const SectionWaves& sections,
                        const SectionDiffraction* diffraction, WaveField& out) {
  Phases phase;
  phases(hull, wave_number(omega, hull.gravity), mu, phase);
  start_field(omega, mu, out);
  set_lateral(hull, phase, sections, diffraction, out);
}

void wave_field(const LoadedHull& hull, double omega, EncounterAngle mu, WaveField& out) {
  SectionDiffraction diffraction;
  const bool has_diffraction = section_diffraction(hull, omega, mu, diffraction);
  SectionWaves sections;
  section_waves(hull, omega, mu, sections);
  wave_field(hull, omega, mu, sections, has_diffraction ? &diffraction : nullptr, out);
}

std::array<Complex, 6> wave_loads(const LoadedHull& hull, const WaveField& field,
                                  const SectionHydrodynamics& section, double omega_e, double speed) {
  const auto heave = [&](std::size_t n) {
    return diffraction(hull, section[kA33], section[kB33], field.heave_velocity[n],
                       field.heave_velocity_slope[n], field.omega, omega_e, speed);
  };
  std::array<Complex, 6> load{};
  load[0] = field.froude_krilov[0];
  load[2] = field.froude_krilov[2] + heave(0) + field.beam_correction[2];
  load[4] = field.froude_krilov[4] - heave(1) + field.beam_correction[4];
  if (is_corrected(hull)) {
    // Heave's square root over omega needs a second guard of the long-wave limit.
    const double kb = wave_number(field.omega, hull.gravity) * hull.breadth / 0.2;
    load[4] -= oblique_weight(field, omega_e) * speed_lever(omega_e, speed) * (1.0 - std::exp(-kb * kb)) *
               field.beam_correction[2];
  }
  add_lateral_loads(hull, field, section, omega_e, speed, load);
  return load;
}

std::array<Complex, 6> lateral_wave_loads(const LoadedHull& hull, const WaveField& field,
                                          const SectionHydrodynamics& section, double omega_e, double speed) {
  std::array<Complex, 6> load{};
  add_lateral_loads(hull, field, section, omega_e, speed, load);
  return load;
}

}  // namespace quickstrip
