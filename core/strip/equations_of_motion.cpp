#include "core/strip/equations_of_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/sea/dispersion.hpp"

namespace quickstrip {
namespace {

// A quantity of two, where it is needed.
using Moments = std::array<Pair, 3>;  // of x^n, n = 0, 1, 2

enum IntegralKind { kPlain, kSlope };

template <IntegralKind Kind, std::size_t Count>
Moments moments_of(const std::array<LengthStencil, 2>& stencil, StripQuantity q) {
  Moments out{};
  const auto value = [&](std::size_t lane, std::size_t node, std::size_t n) {
    const LengthIntegrals& at = *stencil[lane].at[node];
    return Kind == kPlain ? at.plain[q][n] : at.slope[q][n];
  };
  for (std::size_t n = 0; n < Count; ++n) {
    for (std::size_t node = 0; node < 3; ++node) {
      out[n] += pair_of(stencil[0].weight[node], stencil[1].weight[node]) *
                pair_of(value(0, node, n), value(1, node, n));
    }
  }
  return out;
}

// Impedances Z = integral of p_k {A D^2 p_j + B D p_j}, D = i omega_e - V d/dx, of one pair of sectional a, b
// (formulas §4.1, §4.3): ordinary A = a, B = b - V a_x; modified A = a - i b/omega_e, B = -V (a_x - i
// b_x/omega_e). hydrodynamic_coefficients() has the same as a and b.
template <std::size_t Count>
struct Impedance {
  Pair omega_e;
  Pair speed;
  std::array<ComplexPair, 3> inertia{};  // A
  std::array<ComplexPair, 3> drag{};     // B

  Impedance(const MotionPair& at, StripQuantity a, StripQuantity b, bool is_modified)
      : omega_e(at.omega_e), speed(at.speed) {
    const Moments a_plain = moments_of<kPlain, Count>(at.integrals, a);
    const Moments b_plain = moments_of<kPlain, Count>(at.integrals, b);
    const Moments a_slope = moments_of<kSlope, Count>(at.integrals, a);
    const Moments b_slope = is_modified ? moments_of<kSlope, Count>(at.integrals, b) : Moments{};
    for (std::size_t n = 0; n < Count; ++n) {
      inertia[n] = {a_plain[n], is_modified ? -b_plain[n] / omega_e : Pair{}};
      drag[n] = {is_modified ? -speed * a_slope[n] : b_plain[n] - speed * a_slope[n],
                 is_modified ? speed * b_slope[n] / omega_e : Pair{}};
    }
  }
  // Displacement p_j = 1: D p = i omega_e, D^2 p = -omega_e^2.
  [[nodiscard]] ComplexPair of_shift(std::size_t k) const {
    const Pair w2 = omega_e * omega_e;
    return {-w2 * inertia[k].re - omega_e * drag[k].im, -w2 * inertia[k].im + omega_e * drag[k].re};
  }
  // p_j = x: D x = i omega_e x - V, D^2 x = -omega_e^2 x - 2 i omega_e V.
  [[nodiscard]] ComplexPair of_turn(std::size_t k) const {
    const Pair twice = 2.0 * omega_e * speed;
    return of_shift(k + 1) + ComplexPair{twice * inertia[k].im - speed * drag[k].re,
                                         -twice * inertia[k].re - speed * drag[k].im};
  }
};

// Cramer's rule: 42 ns against 400 ns of a pivoted decomposition, residual 1e-15 for these well-scaled sets.
using Matrix = std::array<ThreePair, 3>;

ThreePair solve(const Matrix& m, const ThreePair& f) {
  const ComplexPair c0 = m[1][1] * m[2][2] - m[1][2] * m[2][1];
  const ComplexPair c1 = m[1][2] * m[2][0] - m[1][0] * m[2][2];
  const ComplexPair c2 = m[1][0] * m[2][1] - m[1][1] * m[2][0];
  const ComplexPair d0 = m[0][2] * m[2][1] - m[0][1] * m[2][2];
  const ComplexPair d1 = m[0][0] * m[2][2] - m[0][2] * m[2][0];
  const ComplexPair d2 = m[0][1] * m[2][0] - m[0][0] * m[2][1];
  const ComplexPair e0 = m[0][1] * m[1][2] - m[0][2] * m[1][1];
  const ComplexPair e1 = m[0][2] * m[1][0] - m[0][0] * m[1][2];
  const ComplexPair e2 = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  const ComplexPair by_det = inverse(m[0][0] * c0 + m[0][1] * c1 + m[0][2] * c2);
  return {(c0 * f[0] + d0 * f[1] + e0 * f[2]) * by_det, (c1 * f[0] + d1 * f[1] + e1 * f[2]) * by_det,
          (c2 * f[0] + d2 * f[1] + e2 * f[2]) * by_det};
}

// The same where the first unknown couples with the third alone, by a real number.
ThreePair solve_surge(const Matrix& m, Pair coupling, const ThreePair& f) {
  const ComplexPair inner = m[1][1] * m[2][2] - m[1][2] * m[2][1];
  const Pair square = coupling * coupling;
  const ComplexPair c1 = coupling * m[1][2];
  const ComplexPair d0 = coupling * m[2][1];
  const ComplexPair d1 = m[0][0] * m[2][2] - ComplexPair{square, Pair{}};
  const ComplexPair d2 = -(m[0][0] * m[2][1]);
  const ComplexPair e0 = -(coupling * m[1][1]);
  const ComplexPair e1 = -(m[0][0] * m[1][2]);
  const ComplexPair e2 = m[0][0] * m[1][1];
  const ComplexPair by_det = inverse(m[0][0] * inner - square * m[1][1]);
  return {(inner * f[0] + d0 * f[1] + e0 * f[2]) * by_det, (c1 * f[0] + d1 * f[1] + e1 * f[2]) * by_det,
          (e0 * f[0] + d2 * f[1] + e2 * f[2]) * by_det};
}

double floored_frequency(double omega_e, double floor) {
  const double magnitude = std::max(std::fabs(omega_e), floor);
  return omega_e < 0.0 ? -magnitude : magnitude;
}

ThreePair both_of(const std::array<Complex, 6>& load, std::size_t first) {
  ThreePair out;
  for (std::size_t r = 0; r < 3; ++r) {
    out[r] = {both(load[first + 2 * r].real()), both(load[first + 2 * r].imag())};
  }
  return out;
}

void solve_motions(const LoadedHull& hull, double omega_e, double speed, const std::array<Complex, 6>& load,
                   double roll_damping, std::array<Complex, 6>& motion) {
  LengthIntegrals integrals;
  length_integrals(hull, omega_e, integrals);
  const LengthStencil alone{{&integrals, &integrals, &integrals}, {1.0, 0.0, 0.0}};
  const MotionPair at{both(omega_e), both(speed), {alone, alone}};
  const ShipTerms ship = ship_terms(hull);
  const ThreePair vertical = solve_vertical(ship, at, both_of(load, 0));
  const ThreePair lateral = solve_lateral(ship, at, both(roll_damping), both_of(load, 1));
  for (std::size_t r = 0; r < 3; ++r) {
    motion[2 * r] = lane(vertical[r], 0);
    motion[2 * r + 1] = lane(lateral[r], 0);
  }
}

}  // namespace

// Surge: a11' = factor rho A along the strip's own surge x - bG theta (formulas §4.4); no speed terms, no
// wave damping.
ShipTerms ship_terms(const LoadedHull& hull) {
  ShipTerms out;
  out.body = hull.body;
  out.restoring = hull.restoring;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const double a11 = hull.surge_added_mass_factor * hull.density * hull.area[i] * hull.weight[i];
    const double lever = hull.centroid_below_g[i];
    out.a11 += a11;
    out.a15 -= a11 * lever;
    out.a55 += a11 * lever * lever;
  }
  out.b11_per_speed = hull.surge_damping_per_speed;
  out.is_modified = hull.method.variant == StripVariant::kModified;
  return out;
}

MetWave met_wave(const LoadedHull& hull, double omega, EncounterAngle mu) {
  return met_wave(hull, omega, std::cos(mu.radians));
}

MetWave met_wave(const LoadedHull& hull, double omega, double cos_mu) {
  return {omega, wave_number(omega, hull.gravity) * cos_mu, encounter_floor(hull, omega)};
}

FlooredEncounter MetWave::at(double speed) const {
  FlooredEncounter out;
  out.encounter.frequency = omega - k_cos_mu * speed;
  out.encounter.is_low = std::fabs(out.encounter.frequency) < floor;
  out.floored = floored_frequency(out.encounter.frequency, floor);
  return out;
}

ThreePair solve_vertical(const ShipTerms& ship, const MotionPair& at, const ThreePair& load) {
  const Impedance<3> heave(at, kA33, kB33, ship.is_modified);
  const Pair w2 = at.omega_e * at.omega_e;
  const Pair surge_pitch = -w2 * ship.a15;
  Matrix m;
  m[0][0] = {-w2 * (ship.body.mass + ship.a11), at.omega_e * at.speed * ship.b11_per_speed};
  m[1][1] = heave.of_shift(0);
  m[1][2] = -heave.of_turn(0);
  m[2][1] = -heave.of_shift(1);
  m[2][2] = heave.of_turn(1);
  m[1][1].re += ship.restoring.c33 - w2 * ship.body.mass;
  m[1][2].re += ship.restoring.c35;
  m[2][1].re += ship.restoring.c35;
  m[2][2].re += ship.restoring.c55 - w2 * (ship.body.iyy + ship.a55);
  return solve_surge(m, surge_pitch, load);
}

ThreePair solve_lateral(const ShipTerms& ship, const MotionPair& at, Pair roll_damping,
                        const ThreePair& load) {
  const Impedance<3> sway(at, kA22, kB22, ship.is_modified);
  const Impedance<2> coupled(at, kA24, kB24, ship.is_modified);
  const Impedance<1> roll(at, kA44, kB44, ship.is_modified);
  const Pair w2 = at.omega_e * at.omega_e;
  Matrix m;
  m[0] = {sway.of_shift(0), coupled.of_shift(0), sway.of_turn(0)};
  m[1] = {coupled.of_shift(0), roll.of_shift(0), coupled.of_turn(0)};
  m[2] = {sway.of_shift(1), coupled.of_shift(1), sway.of_turn(1)};
  m[0][0].re -= w2 * ship.body.mass;
  m[1][1].re += ship.restoring.c44 - w2 * ship.body.ixx;
  m[1][1].im += at.omega_e * roll_damping;
  m[2][2].re -= w2 * ship.body.izz;
  return solve(m, load);
}

double encounter_floor(const LoadedHull& hull, double omega) {
  return std::min(0.42 * std::sqrt(hull.gravity / hull.lpp), 0.5 * omega);
}

MotionTransfer motions_under_load(const LoadedHull& hull, double omega, EncounterAngle mu, double speed,
                                  const std::array<Complex, 6>& load, double roll_damping) {
  const FlooredEncounter met = met_wave(hull, omega, mu).at(speed);
  MotionTransfer out;
  out.encounter_frequency = met.encounter.frequency;
  out.low_encounter = met.encounter.is_low;
  solve_motions(hull, met.floored, speed, load, roll_damping, out.motion);
  return out;
}

MotionTransfer motions_under_load(const LoadedHull& hull, double omega, EncounterAngle mu, double speed,
                                  const std::array<Complex, 6>& load) {
  return motions_under_load(hull, omega, mu, speed, load, reference_roll_damping(hull.roll_damping, speed));
}

MotionTransfer motion_transfer(const LoadedHull& hull, const WaveField& field, double speed,
                               std::array<Complex, 6>& load) {
  const FlooredEncounter met = met_wave(hull, field.omega, field.mu).at(speed);
  MotionTransfer out;
  out.encounter_frequency = met.encounter.frequency;
  out.low_encounter = met.encounter.is_low;
  if (met.encounter.is_low && hull.method.low_encounter == LowEncounterRule::kPaper) {
    load = {};
    return out;  // loads forced to zero [Journee1992] §2
  }
  SectionHydrodynamics section;
  section_hydrodynamics(hull, met.floored, section);
  load = wave_loads(hull, field, section, met.floored, speed);
  solve_motions(hull, met.floored, speed, load, reference_roll_damping(hull.roll_damping, speed), out.motion);
  return out;
}

MotionTransfer motion_transfer(const LoadedHull& hull, const WaveField& field, double speed) {
  std::array<Complex, 6> load;
  return motion_transfer(hull, field, speed, load);
}

MotionTransfer motion_transfer(const LoadedHull& hull, double omega, EncounterAngle mu, double speed) {
  WaveField field;
  wave_field(hull, omega, mu, field);
  return motion_transfer(hull, field, speed);
}

}  // namespace quickstrip
