#include "core/strip/wave_loads.hpp"

#include <algorithm>
#include <cmath>

#include "core/sea/dispersion.hpp"
#include "core/strip/froude_krilov.hpp"
#include "core/strip/sway_load_phase.hpp"

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

// Signed square root of a radiated-wave relation, sqrt(rho g^2 b / omega): the Haskind amplitude of a load.
double haskind_amplitude(const LoadedHull& hull, double damping, double omega) {
  return std::sqrt(std::max(0.0, hull.density * hull.gravity * hull.gravity * damping / omega));
}

}  // namespace

void beam_sea_correction(const LoadedHull& hull, double omega, BeamSeaCorrection& out) {
  static_assert(sizeof(SectionHydrodynamics) < 8192, "kept on the stack");
  SectionHydrodynamics section;
  section_hydrodynamics(hull, omega, section);
  const double k = wave_number(omega, hull.gravity);
  const bool is_radiated = hull.method.beam_loads == BeamLoads::kRadiatedWave;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    // All on the Lewis form that a and b belong to: then the correction vanishes in long waves, term by term.
    const FroudeKrilov fk = froude_krilov(hull.lewis_contour[i].view(), 0.5 * hull.lewis[i].breadth,
                                          hull.density, hull.gravity, k, EncounterAngle{0.5 * kPi});
    // Equivalent displacements: zeta*_2 = -i factor, zeta*_3 = factor.
    const Complex sway = -kI * fk.horizontal_factor;
    const Complex x2 =
        kI * fk.sway + Complex(-omega * omega * section[kA22][i], omega * section[kB22][i]) * sway;
    const Complex x4 = -kI * fk.roll + hull.g_height * kI * fk.sway +
                       Complex(-omega * omega * section[kA24][i], omega * section[kB24][i]) * sway;
    const Complex x3 =
        fk.heave + Complex(-omega * omega * section[kA33][i], omega * section[kB33][i]) * fk.heave_factor;

    const double h2 = haskind_amplitude(hull, section[kB22][i], omega);
    const Complex x2h = std::polar(h2, is_radiated ? sway_load_phase(hull.lewis[i], k) : std::arg(x2));
    const double lever = section[kB22][i] > 0.0 ? section[kB24][i] / section[kB22][i] : 0.0;
    const double h3 = haskind_amplitude(hull, section[kB33][i], omega);
    const double r = std::clamp(fk.heave - omega * omega * section[kA33][i] * fk.heave_factor, -h3, h3);
    const Complex x3h(r, std::sqrt(std::max(0.0, h3 * h3 - r * r)));

    // The square root is of order omega and would spoil the long-wave limit in oblique seas.
    const double kb = k * hull.lewis[i].breadth / 0.04;
    out.sway[i] = x2h - x2;
    out.roll[i] = lever * x2h - x4;
    out.heave[i] = (x3h - x3) * (1.0 - std::exp(-kb * kb));
  }
}

void wave_field(const LoadedHull& hull, double omega, EncounterAngle mu, const BeamSeaCorrection* correction,
                WaveField& out) {
  const double k = wave_number(omega, hull.gravity);
  const double sin_mu = std::sin(mu.radians);
  const double cos_mu = std::cos(mu.radians);
  out.omega = omega;
  out.mu = mu;
  out.froude_krilov = {};
  out.beam_correction = {};
  std::array<ComplexSectionValues, 2> heave_at{};
  std::array<ComplexSectionValues, 2> sway_at{};
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const FroudeKrilov fk =
        froude_krilov(hull.wave_contour[i].view(), hull.half_breadth[i], hull.density, hull.gravity, k, mu);
    const double x = hull.x[i];
    const Complex crest = std::polar(1.0, -k * x * cos_mu);
    const Complex weighted = hull.weight[i] * crest;
    const Complex x1 = weighted * kI * fk.surge * (1.0 + hull.surge_added_mass_factor);
    const Complex x2 = weighted * kI * fk.sway;
    const Complex x3 = weighted * fk.heave;
    out.froude_krilov[0] += x1;
    out.froude_krilov[1] += x2;
    out.froude_krilov[2] += x3;
    out.froude_krilov[3] += -kI * weighted * fk.roll + (hull.g_height + hull.roll_lever_shift) * x2;
    out.froude_krilov[4] += -x * x3 - hull.centroid_below_g[i] * x1;
    out.froude_krilov[5] += x * x2;

    // Orbital velocities: zd_3 = i omega factor, zd_2 = i omega (-i sin mu factor).
    heave_at[0][i] = kI * omega * fk.heave_factor * crest;
    sway_at[0][i] = omega * sin_mu * fk.horizontal_factor * crest;
    heave_at[1][i] = x * heave_at[0][i];
    sway_at[1][i] = x * sway_at[0][i];
    if (correction != nullptr) {
      const Complex dx2 = weighted * sin_mu * correction->sway[i];
      const Complex dx3 = weighted * sin_mu * sin_mu * correction->heave[i];
      out.beam_correction[1] += dx2;
      out.beam_correction[2] += dx3;
      out.beam_correction[3] += weighted * sin_mu * correction->roll[i];
      out.beam_correction[4] -= x * dx3;
      out.beam_correction[5] += x * dx2;
    }
  }
  // At the ends of the tapers: the end section's wave, further on its way.
  const std::size_t last = hull.num_sections - 1;
  const Complex on_aft = std::polar(1.0, k * hull.taper_aft * cos_mu);
  const Complex on_fore = std::polar(1.0, -k * hull.taper_fore * cos_mu);
  const std::array<double, 2> arm_aft = {1.0, hull.x[0] - hull.taper_aft};
  const std::array<double, 2> arm_fore = {1.0, hull.x[last] + hull.taper_fore};
  for (std::size_t n = 0; n < 2; ++n) {
    for (std::size_t i = 0; i < hull.num_sections; ++i) {
      out.heave_velocity[n][i] = hull.weight[i] * heave_at[n][i];
      out.sway_velocity[n][i] = hull.weight[i] * sway_at[n][i];
    }
    slope_weights(hull, heave_at[n],
                  {arm_aft[n] * on_aft * heave_at[0][0], arm_fore[n] * on_fore * heave_at[0][last]},
                  out.heave_velocity_slope[n]);
    slope_weights(hull, sway_at[n],
                  {arm_aft[n] * on_aft * sway_at[0][0], arm_fore[n] * on_fore * sway_at[0][last]},
                  out.sway_velocity_slope[n]);
  }
}

std::array<Complex, 6> wave_loads(const LoadedHull& hull, const WaveField& field,
                                  const SectionHydrodynamics& section, double omega_e, double speed) {
  const auto heave = [&](std::size_t n) {
    return diffraction(hull, section[kA33], section[kB33], field.heave_velocity[n],
                       field.heave_velocity_slope[n], field.omega, omega_e, speed);
  };
  const auto sway = [&](std::size_t n, StripQuantity a, StripQuantity b) {
    return diffraction(hull, section[a], section[b], field.sway_velocity[n], field.sway_velocity_slope[n],
                       field.omega, omega_e, speed);
  };
  std::array<Complex, 6> load = field.froude_krilov;
  load[1] += sway(0, kA22, kB22);
  load[2] += heave(0);
  load[3] += sway(0, kA24, kB24);
  load[4] -= heave(1);
  load[5] += sway(1, kA22, kB22);
  // Oblique weight of the sway, yaw and roll corrections: empirical, chosen on the S-175 (formulas §6).
  const double lateral = std::min(1.0, std::fabs(omega_e) / field.omega);
  const std::array<double, 6> weight = {0.0, lateral, 1.0, lateral, 1.0, lateral};
  for (std::size_t i = 0; i < 6; ++i) {
    load[i] += weight[i] * field.beam_correction[i];
  }
  if (hull.method.beam_loads == BeamLoads::kRadiatedWave) {
    // The correction is a diffraction load, so its lever is that of [STF1970], x + V / (i omega_e). With the
    // weight it stays finite where omega_e vanishes; heave's square root over omega needs a second guard of
    // the long-wave limit.
    const Complex lever = lateral * speed / (kI * omega_e);
    const double kb = wave_number(field.omega, hull.gravity) * hull.breadth / 0.2;
    load[4] -= lever * (1.0 - std::exp(-kb * kb)) * field.beam_correction[2];
    load[5] += lever * field.beam_correction[1];
  }
  return load;
}

}  // namespace quickstrip
