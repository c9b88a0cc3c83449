#include "core/strip/wave_loads.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/pair_functions.hpp"
#include "core/sea/dispersion.hpp"
#include "core/strip/boundary_value.hpp"
#include "core/strip/froude_krilov.hpp"
#include "core/strip/wave_sums.hpp"

namespace quickstrip {
namespace {

constexpr Complex kI(0.0, 1.0);

// Weights that turn values g(x_i) into the integral of a_x g over the length, given the a_i: the sum of a_i
// times the result. Summation by parts of the trapezoidal rule; at an end without taper a jumps, which end
// terms include.
void slope_weights(const LoadedHull& hull, const AlongHull& along, ComplexSectionValues& out) {
  const ComplexSectionValues& g = along.at;
  const std::size_t last = hull.num_sections - 1;
  for (std::size_t i = 1; i < last; ++i) {
    out[i] = 0.5 * (g[i - 1] - g[i + 1]);
  }
  out[0] = -0.5 * (g[0] + g[1]);
  out[last] = 0.5 * (g[last - 1] + g[last]);
  if (hull.taper_aft > 0.0 || hull.method.end_terms) {
    out[0] += 0.5 * (g[0] + along.aft);
  }
  if (hull.taper_fore > 0.0 || hull.method.end_terms) {
    out[last] -= 0.5 * (g[last] + along.fore);
  }
}

// At the ends of the tapers: the end section's wave, further on its way; |elevation| = 1.
void set_ends(const LoadedHull& hull, const AlongHull& elevation, AlongHull& velocity) {
  const std::size_t last = hull.num_sections - 1;
  velocity.aft = velocity.at[0] * std::conj(elevation.at[0]) * elevation.aft;
  velocity.fore = velocity.at[last] * std::conj(elevation.at[last]) * elevation.fore;
}

// The orbital velocity at the surface made that of an equivalent motion, by section. A slope then acts on the
// coefficient and the factor together: the momentum of the restrained section's own flow.
void scale_velocity(const LoadedHull& hull, const HeldComplexValues& factor,
                    std::array<ComplexSectionValues, 2>& velocity,
                    std::array<ComplexSectionValues, 2>& velocity_slope) {
  for (std::size_t n = 0; n < 2; ++n) {
    for (std::size_t i = 0; i < hull.num_sections; ++i) {
      velocity[n][i] *= Complex(factor[i]);
      velocity_slope[n][i] *= Complex(factor[i]);
    }
  }
}

void set_longitudinal(const LoadedHull& hull, const AlongHull& elevation, const SectionWaves& sections,
                      const SectionDiffraction* diffraction, WaveField& out) {
  const bool is_solved = diffraction != nullptr && hull.method.loads == DiffractionLoads::kBoundaryValue;
  AlongHull velocity;
  const double sin_mu = std::sin(out.mu.radians);
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const double x = hull.x[i];
    const Complex weighted = hull.weight[i] * elevation.at[i];
    const Complex x1 = weighted * kI * sections.surge[i] * (1.0 + hull.surge_added_mass_factor);
    const Complex x3 = weighted * sections.heave[i];
    out.froude_krilov[0] += x1;
    out.froude_krilov[2] += x3;
    out.froude_krilov[4] += -x * x3 - hull.centroid_below_g[i] * x1;
    const double factor = is_solved ? Held(1.0) : sections.heave_factor[i];
    velocity.at[i] = kI * out.omega * factor * elevation.at[i];  // zd_3 = i omega factor
    if (diffraction != nullptr && !is_solved) {
      const Complex dx3 = weighted * sin_mu * sin_mu * diffraction->heave[i];
      out.beam_correction[2] += dx3;
      out.beam_correction[4] -= x * dx3;
    }
  }
  set_ends(hull, elevation, velocity);
  weigh_velocity(hull, velocity, out.heave_velocity, out.heave_velocity_slope);
  if (is_solved) {
    scale_velocity(hull, diffraction->heave, out.heave_velocity, out.heave_velocity_slope);
  }
}

void set_lateral(const LoadedHull& hull, const AlongHull& elevation, const SectionWaves& sections,
                 const SectionDiffraction* diffraction, WaveField& out) {
  const bool is_solved = diffraction != nullptr && hull.method.loads == DiffractionLoads::kBoundaryValue;
  AlongHull velocity;
  const double sin_mu = std::sin(out.mu.radians);
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const double x = hull.x[i];
    const Complex weighted = hull.weight[i] * elevation.at[i];
    const Complex x2 = weighted * kI * sections.sway[i];
    out.froude_krilov[1] += x2;
    out.froude_krilov[3] += -kI * weighted * sections.roll[i] + (hull.g_height + hull.roll_lever_shift) * x2;
    out.froude_krilov[5] += x * x2;
    // zd_2 = i omega (-i sin mu factor).
    const double factor = is_solved ? Held(1.0) : sections.horizontal_factor[i];
    velocity.at[i] = out.omega * sin_mu * factor * elevation.at[i];
    if (diffraction != nullptr && !is_solved) {
      const Complex dx2 = weighted * sin_mu * diffraction->sway[i];
      out.beam_correction[1] += dx2;
      out.beam_correction[3] += weighted * sin_mu * diffraction->roll[i];
      out.beam_correction[5] += x * dx2;
    }
  }
  set_ends(hull, elevation, velocity);
  weigh_velocity(hull, velocity, out.sway_velocity, out.sway_velocity_slope);
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

}  // namespace

void weigh_velocity(const LoadedHull& hull, const AlongHull& velocity,
                    std::array<ComplexSectionValues, 2>& weighted,
                    std::array<ComplexSectionValues, 2>& against_slope) {
  const std::size_t last = hull.num_sections - 1;
  AlongHull times_x;
  for (std::size_t i = 0; i <= last; ++i) {
    times_x.at[i] = hull.x[i] * velocity.at[i];
    weighted[0][i] = hull.weight[i] * velocity.at[i];
    weighted[1][i] = hull.weight[i] * times_x.at[i];
  }
  times_x.aft = (hull.x[0] - hull.taper_aft) * velocity.aft;
  times_x.fore = (hull.x[last] + hull.taper_fore) * velocity.fore;
  slope_weights(hull, velocity, against_slope[0]);
  slope_weights(hull, times_x, against_slope[1]);
}

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
  WaveDecays none;
  section_waves(hull, omega, mu, 0, none, out);
}

void section_waves(const LoadedHull& hull, double omega, EncounterAngle mu, std::size_t f, WaveDecays& decays,
                   SectionWaves& out) {
  const double k = wave_number(omega, hull.gravity);
  const double sin_mu = std::sin(mu.radians);
  const double cos_mu = std::cos(mu.radians);
  const double rho_g = hull.density * hull.gravity;
  ContourDecay own;
  std::size_t used = 0;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const ContourView contour = hull.wave_contour[i].view();
    const std::span<Pair> kept = decays.place(f, used, (contour.z.size() + 1) / 2);
    if (!decays.is_filled || kept.empty()) {
      contour_decay(contour, k, kept.empty() ? std::span<Pair>(own) : kept);
    }
    const FroudeKrilov fk = froude_krilov(contour, hull.half_breadth[i], rho_g, k, sin_mu, cos_mu,
                                          kept.empty() ? std::span<const Pair>(own) : kept);
    used += kept.size();
    out.surge[i] = fk.surge;
    out.sway[i] = fk.sway;
    out.heave[i] = fk.heave;
    out.roll[i] = fk.roll;
    out.heave_factor[i] = fk.heave_factor;
    out.horizontal_factor[i] = fk.horizontal_factor;
  }
}

void elevation_along(const LoadedHull& hull, double omega, EncounterAngle mu, AlongHull& out) {
  const double along = wave_number(omega, hull.gravity) * std::cos(mu.radians);
  const std::size_t last = hull.num_sections - 1;
  for (std::size_t i = 0; i <= last; i += 2) {
    const std::size_t next = std::min(i + 1, last);
    const SinCos at = sin_cos(-along * pair_of(hull.x[i], hull.x[next]));
    out.at[i] = {at.cos[0], at.sin[0]};
    out.at[next] = {at.cos[1], at.sin[1]};
  }
  out.aft = complex_of(turn(-along * (hull.x[0] - hull.taper_aft)));
  out.fore = complex_of(turn(-along * (hull.x[last] + hull.taper_fore)));
}

void wave_field(const LoadedHull& hull, double omega, EncounterAngle mu, const AlongHull& elevation,
                const SectionWaves& sections, const SectionDiffraction* diffraction, WaveField& out) {
  start_field(omega, mu, out);
  set_longitudinal(hull, elevation, sections, diffraction, out);
  set_lateral(hull, elevation, sections, diffraction, out);
}

void wave_field(const LoadedHull& hull, double omega, EncounterAngle mu, const SectionWaves& sections,
                const SectionDiffraction* diffraction, WaveField& out) {
  AlongHull elevation;
  elevation_along(hull, omega, mu, elevation);
  wave_field(hull, omega, mu, elevation, sections, diffraction, out);
}

void lateral_wave_field(const LoadedHull& hull, double omega, EncounterAngle mu, const SectionWaves& sections,
                        const SectionDiffraction* diffraction, WaveField& out) {
  AlongHull elevation;
  elevation_along(hull, omega, mu, elevation);
  start_field(omega, mu, out);
  set_lateral(hull, elevation, sections, diffraction, out);
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
  WaveColumns columns;
  arrange(hull, field, nullptr, columns);
  WaveSums sums;
  sum_up(hull, columns, section, sums);
  const std::array<Pair, 6> load = loads_of(hull, columns, sums, omega_e, speed);
  std::array<Complex, 6> out{};
  std::transform(load.begin(), load.end(), out.begin(), [](Pair x) { return complex_of(x); });
  return out;
}

}  // namespace quickstrip
