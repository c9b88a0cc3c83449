#include "core/strip/wave_sums.hpp"

#include <algorithm>
#include <cmath>

#include "core/sea/dispersion.hpp"

namespace quickstrip {
namespace {

bool is_solved(const LoadedHull& hull) {
  return hull.method.loads == DiffractionLoads::kBoundaryValue;
}

bool is_modified(const LoadedHull& hull) {
  return hull.method.variant == StripVariant::kModified;
}

// Of kHaskind with radiated waves: loads have speed terms.
bool has_speed_terms(const LoadedHull& hull) {
  return hull.method.loads == DiffractionLoads::kHaskind &&
         hull.method.beam_loads == BeamLoads::kRadiatedWave;
}

// out[From ... To - 1] = sum over the sections of value times column.
template <std::size_t From, std::size_t To, std::size_t N>
void products(const SectionValues& values, const std::array<std::array<Pair, N>, kMaxStations>& columns,
              std::size_t num_sections, std::array<Pair, N>& out) {
  std::array<Pair, To - From> sum{};
  for (std::size_t i = 0; i < num_sections; ++i) {
    const Pair value = both(values[i]);
    for (std::size_t c = From; c < To; ++c) {
      sum[c - From] += value * columns[i][c];
    }
  }
  for (std::size_t c = From; c < To; ++c) {
    out[c] = sum[c - From];
  }
}

template <std::size_t From, std::size_t To, std::size_t N>
void between(const WaveSumsStencil& stencil, std::array<Pair, N> WaveSums::*member, WaveSums& out) {
  const std::array<Pair, N>& v0 = stencil.at[0]->*member;
  const std::array<Pair, N>& v1 = stencil.at[1]->*member;
  const std::array<Pair, N>& v2 = stencil.at[2]->*member;
  for (std::size_t c = From; c < To; ++c) {
    (out.*member)[c] = stencil.weight[0] * v0[c] + stencil.weight[1] * v1[c] + stencil.weight[2] * v2[c];
  }
}

// Diffraction load of coefficients a, b (formulas §6): ordinary  a zdd + (b - V a_x) zd,  modified
// (a + V b_x/(omega omega_e)) zdd + ((omega/omega_e) b - V a_x) zd, with zdd = i omega zd: the wave
// frequency, not the frequency of encounter. V: sums with the velocity, S: against the slope.
struct Diffraction {
  double omega;
  double omega_e;
  double speed;
  bool modified;

  template <std::size_t N>
  [[nodiscard]] Pair of(const std::array<Pair, N>& a, const std::array<Pair, N>& b, std::size_t plain,
                        std::size_t slope) const {
    const Pair inertia = times_i(omega * a[plain]);
    const Pair swept = speed * a[slope];
    if (!modified) {
      return inertia + b[plain] - swept;
    }
    return inertia + omega / omega_e * b[plain] - swept + times_i(speed / omega_e * b[slope]);
  }
};

Diffraction diffraction_at(const LoadedHull& hull, double omega, double omega_e, double speed) {
  return {omega, omega_e, speed, is_modified(hull)};
}

// Oblique weight of the sway, yaw and roll corrections: empirical, chosen on the S-175 (formulas §6).
double oblique_weight(double omega, double omega_e) {
  return std::min(1.0, std::fabs(omega_e) / omega);
}

// The correction is a diffraction load, so its lever is that of [STF1970], x + V / (i omega_e). With the
// oblique weight it stays finite where omega_e vanishes. Here of the weight and the load: w V / (i omega_e)
// X.
Pair by_speed_lever(double weight, double omega_e, double speed, Pair load) {
  return -weight * speed / omega_e * times_i(load);
}

void add_lateral_loads(const LoadedHull& hull, const WaveColumns& wave, const WaveSums& sums, double omega_e,
                       double speed, std::array<Pair, 6>& load) {
  const Diffraction of = diffraction_at(hull, wave.omega, omega_e, speed);
  std::array<Pair, 3> diffracted = {of.of(sums.a22, sums.b22, kSwayV0, kSwayS0),
                                    of.of(sums.a24, sums.b24, kSwayV0, kSwayS0),
                                    of.of(sums.a22, sums.b22, kSwayV1, kSwayS1)};
  if (is_solved(hull)) {
    diffracted[1] += of.of(sums.a22, sums.b22, kRollV, kRollS);
  }
  const double weight = oblique_weight(wave.omega, omega_e);
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t i = 2 * n + 1;
    load[i] = wave.froude_krilov[i] + diffracted[n] + weight * wave.beam_correction[i];
  }
  if (has_speed_terms(hull)) {
    load[5] += by_speed_lever(weight, omega_e, speed, wave.beam_correction[1]);
  }
}

// Columns of a vertical velocity: plain, and against a slope.
template <typename Row>
void set_heave_columns(const std::array<ComplexSectionValues, 2>& velocity,
                       const std::array<ComplexSectionValues, 2>& slope, std::size_t num_sections,
                       std::size_t s0, std::size_t v0, Row& out) {
  for (std::size_t i = 0; i < num_sections; ++i) {
    out[i][s0] = pair_of(slope[0][i]);
    out[i][s0 + 1] = pair_of(slope[1][i]);
    out[i][v0] = pair_of(velocity[0][i]);
    out[i][v0 + 1] = pair_of(velocity[1][i]);
  }
}

// |w|^2 times the weight, and its weights against a slope.
void set_square_column(const LoadedHull& hull, const AlongHull& w, WaveColumns& out) {
  const std::size_t last = hull.num_sections - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const double here = std::norm(w.at[i]);
    const double before = i > 0 ? 0.5 * (std::norm(w.at[i - 1]) + here) : 0.0;
    const double after = i < last ? 0.5 * (here + std::norm(w.at[i + 1])) : 0.0;
    out.heave[i][kHeaveQ] = pair_of(before - after, hull.weight[i] * here);
  }
  if (hull.taper_aft > 0.0 || hull.method.end_terms) {
    out.heave[0][kHeaveQ] += pair_of(0.5 * (std::norm(w.at[0]) + std::norm(w.aft)), 0.0);
  }
  if (hull.taper_fore > 0.0 || hull.method.end_terms) {
    out.heave[last][kHeaveQ] -= pair_of(0.5 * (std::norm(w.at[last]) + std::norm(w.fore)), 0.0);
  }
}

}  // namespace

void arrange_lateral(const LoadedHull& hull, const WaveField& field, WaveColumns& out) {
  out.omega = field.omega;
  for (std::size_t i = 0; i < 6; ++i) {
    out.froude_krilov[i] = pair_of(field.froude_krilov[i]);
    out.beam_correction[i] = pair_of(field.beam_correction[i]);
  }
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    out.sway[i][kSwayS1] = pair_of(field.sway_velocity_slope[1][i]);
    out.sway[i][kSwayS0] = pair_of(field.sway_velocity_slope[0][i]);
    out.sway[i][kSwayV0] = pair_of(field.sway_velocity[0][i]);
    out.sway[i][kSwayV1] = pair_of(field.sway_velocity[1][i]);
  }
  if (is_solved(hull)) {
    for (std::size_t i = 0; i < hull.num_sections; ++i) {
      out.sway[i][kRollV] = pair_of(field.roll_velocity[i]);
      out.sway[i][kRollS] = pair_of(field.roll_velocity_slope[i]);
    }
  }
}

void arrange(const LoadedHull& hull, const WaveField& field, const ResistanceWave* wave, WaveColumns& out) {
  arrange_lateral(hull, field, out);
  // Heave's square root over omega needs a second guard of the long-wave limit.
  const double kb = wave_number(field.omega, hull.gravity) * hull.breadth / 0.2;
  out.heave_guard = has_speed_terms(hull) ? 1.0 - std::exp(-kb * kb) : 0.0;
  const std::size_t n = hull.num_sections;
  if (is_solved(hull)) {
    set_heave_columns(field.heave_velocity, field.heave_velocity_slope, n, kSolvedS0, kSolvedV0, out.solved);
  } else {
    set_heave_columns(field.heave_velocity, field.heave_velocity_slope, n, kHeaveS0, kHeaveV0, out.heave);
  }
  if (wave == nullptr) {
    return;
  }
  if (is_solved(hull)) {  // then that of the undisturbed wave is another
    std::array<ComplexSectionValues, 2> velocity;
    std::array<ComplexSectionValues, 2> slope;
    weigh_velocity(hull, wave->velocity, velocity, slope);
    set_heave_columns(velocity, slope, n, kHeaveS0, kHeaveV0, out.heave);
  }
  set_square_column(hull, wave->velocity, out);
}

void sum_up_lateral(const LoadedHull& hull, const WaveColumns& columns, const SectionHydrodynamics& section,
                    WaveSums& out) {
  const std::size_t n = hull.num_sections;
  if (is_solved(hull)) {
    products<kSwayS1, kSwayColumns>(section[kA22], columns.sway, n, out.a22);
  } else {
    products<kSwayS1, kRollV>(section[kA22], columns.sway, n, out.a22);
  }
  products<kSwayS0, kSwayV1>(section[kA24], columns.sway, n, out.a24);
  if (is_modified(hull)) {
    products<kSwayS1, kSwayColumns>(section[kB22], columns.sway, n, out.b22);
    products<kSwayS0, kSwayV1>(section[kB24], columns.sway, n, out.b24);
  } else {
    if (is_solved(hull)) {
      products<kSwayV0, kRollS>(section[kB22], columns.sway, n, out.b22);
    } else {
      products<kSwayV0, kRollV>(section[kB22], columns.sway, n, out.b22);
    }
    products<kSwayV0, kSwayV1>(section[kB24], columns.sway, n, out.b24);
  }
}

void sum_up(const LoadedHull& hull, const WaveColumns& columns, const SectionHydrodynamics& section,
            WaveSums& out) {
  const std::size_t n = hull.num_sections;
  products<kHeaveS0, kHeaveColumns>(section[kA33], columns.heave, n, out.a33);
  if (is_solved(hull)) {
    products<kSolvedS0, kSolvedColumns>(section[kA33], columns.solved, n, out.solved_a33);
    products<kSolvedS0, kSolvedColumns>(section[kB33], columns.solved, n, out.solved_b33);
  }
  if (is_modified(hull)) {
    products<kHeaveS0, kHeaveColumns>(section[kB33], columns.heave, n, out.b33);
  } else {
    products<kHeaveQ, kHeaveColumns>(section[kB33], columns.heave, n, out.b33);
  }
  sum_up_lateral(hull, columns, section, out);
}

void interpolate_lateral(const LoadedHull& hull, const WaveSumsStencil& stencil, WaveSums& out) {
  if (is_modified(hull) || is_solved(hull)) {
    between<kSwayS1, kSwayColumns>(stencil, &WaveSums::a22, out);
    between<kSwayS1, kSwayColumns>(stencil, &WaveSums::b22, out);
    between<kSwayS0, kSwayV1>(stencil, &WaveSums::b24, out);
  } else {
    between<kSwayS1, kRollV>(stencil, &WaveSums::a22, out);
    between<kSwayV0, kRollV>(stencil, &WaveSums::b22, out);
    between<kSwayV0, kSwayV1>(stencil, &WaveSums::b24, out);
  }
  between<kSwayS0, kSwayV1>(stencil, &WaveSums::a24, out);
}

void interpolate(const LoadedHull& hull, const WaveSumsStencil& stencil, WaveSums& out) {
  between<kHeaveS0, kHeaveColumns>(stencil, &WaveSums::a33, out);
  if (is_modified(hull)) {
    between<kHeaveS0, kHeaveColumns>(stencil, &WaveSums::b33, out);
  } else {
    between<kHeaveQ, kHeaveColumns>(stencil, &WaveSums::b33, out);
  }
  if (is_solved(hull)) {
    between<kSolvedS0, kSolvedColumns>(stencil, &WaveSums::solved_a33, out);
    between<kSolvedS0, kSolvedColumns>(stencil, &WaveSums::solved_b33, out);
  }
  interpolate_lateral(hull, stencil, out);
}

std::array<Pair, 6> lateral_loads_of(const LoadedHull& hull, const WaveColumns& wave, const WaveSums& sums,
                                     double omega_e, double speed) {
  std::array<Pair, 6> load{};
  add_lateral_loads(hull, wave, sums, omega_e, speed, load);
  return load;
}

std::array<Pair, 6> loads_of(const LoadedHull& hull, const WaveColumns& wave, const WaveSums& sums,
                             double omega_e, double speed) {
  const Diffraction of = diffraction_at(hull, wave.omega, omega_e, speed);
  const bool solved = is_solved(hull);
  const Pair heave = solved ? of.of(sums.solved_a33, sums.solved_b33, kSolvedV0, kSolvedS0)
                            : of.of(sums.a33, sums.b33, kHeaveV0, kHeaveS0);
  const Pair pitch = solved ? of.of(sums.solved_a33, sums.solved_b33, kSolvedV1, kSolvedS1)
                            : of.of(sums.a33, sums.b33, kHeaveV1, kHeaveS1);
  std::array<Pair, 6> load{};
  load[0] = wave.froude_krilov[0];
  load[2] = wave.froude_krilov[2] + heave + wave.beam_correction[2];
  load[4] = wave.froude_krilov[4] - pitch + wave.beam_correction[4];
  if (has_speed_terms(hull)) {
    load[4] -= by_speed_lever(wave.heave_guard * oblique_weight(wave.omega, omega_e), omega_e, speed,
                              wave.beam_correction[2]);
  }
  add_lateral_loads(hull, wave, sums, omega_e, speed, load);
  return load;
}

}  // namespace quickstrip
