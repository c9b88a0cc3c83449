#include "core/strip/hydrodynamic_coefficients.hpp"

#include <complex>
#include <span>

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

// Integrals over the length of one pair of sectional a, b: [power of x].
struct PairIntegrals {
  const std::array<double, 3>& a;
  const std::array<double, 3>& b;
  const std::array<double, 3>& a_slope;
  const std::array<double, 3>& b_slope;
};

PairIntegrals pair_of(const LengthIntegrals& integrals, StripQuantity a, StripQuantity b) {
  return {integrals.plain[a], integrals.plain[b], integrals.slope[a], integrals.slope[b]};
}

// Displacement of a strip per unit of a motion: sign * x^power (heave 1, pitch -x, sway 1, yaw x).
struct Shape {
  double sign;
  std::size_t power;  // 0 or 1
};

// Z = integral of p_k {A D^2 p_j + B D p_j}, D = i omega_e - V d/dx:
// ordinary A = a, B = b - V a_x; modified A = a - i b/omega_e, B = -V (a_x - i b_x/omega_e).
Complex impedance(const PairIntegrals& pair, StripVariant variant, Shape k, Shape j, double omega_e,
                  double speed) {
  constexpr Complex i(0.0, 1.0);
  const bool modified = variant == StripVariant::kModified;
  const auto inertia = [&](std::size_t n) {
    return modified ? Complex(pair.a[n], -pair.b[n] / omega_e) : Complex(pair.a[n]);
  };
  const auto drag = [&](std::size_t n) {
    return modified ? -speed * Complex(pair.a_slope[n], -pair.b_slope[n] / omega_e)
                    : Complex(pair.b[n] - speed * pair.a_slope[n]);
  };
  const double w2 = omega_e * omega_e;
  Complex z = 0.0;
  if (j.power == 0) {  // D p = i omega_e, D^2 p = -omega_e^2
    z = -w2 * inertia(k.power) + i * omega_e * drag(k.power);
  } else {  // D x = i omega_e x - V, D^2 x = -omega_e^2 x - 2 i omega_e V
    z = -w2 * inertia(k.power + 1) - 2.0 * i * omega_e * speed * inertia(k.power) +
        i * omega_e * drag(k.power + 1) - speed * drag(k.power);
  }
  return k.sign * j.sign * z;
}

struct MotionShape {
  std::size_t motion;  // index into the six motions
  Shape shape;
};

void add_impedances(HydrodynamicCoefficients& out, const PairIntegrals& pair, StripVariant variant,
                    std::span<const MotionShape> forces, std::span<const MotionShape> motions, double omega_e,
                    double speed) {
  for (const MotionShape& k : forces) {
    for (const MotionShape& j : motions) {
      const Complex z = impedance(pair, variant, k.shape, j.shape, omega_e, speed);
      out.a[k.motion][j.motion] += -z.real() / (omega_e * omega_e);
      out.b[k.motion][j.motion] += z.imag() / omega_e;
    }
  }
}

// a11' = factor rho A along the strip's own surge x - bG theta (formulas §4.4); no speed terms, no wave
// damping.
void add_surge(const LoadedHull& hull, HydrodynamicCoefficients& out) {
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    const double a11 = hull.surge_added_mass_factor * hull.density * hull.area[i] * hull.weight[i];
    const double lever = hull.centroid_below_g[i];
    out.a[0][0] += a11;
    out.a[0][4] -= a11 * lever;
    out.a[4][0] -= a11 * lever;
    out.a[4][4] += a11 * lever * lever;
  }
}

}  // namespace

HydrodynamicCoefficients hydrodynamic_coefficients(const LoadedHull& hull, const LengthIntegrals& integrals,
                                                   double omega_e, double speed) {
  constexpr std::array<MotionShape, 2> kVertical = {{{2, {1.0, 0}}, {4, {-1.0, 1}}}};
  constexpr std::array<MotionShape, 2> kSwayYaw = {{{1, {1.0, 0}}, {5, {1.0, 1}}}};
  constexpr std::array<MotionShape, 1> kRoll = {{{3, {1.0, 0}}}};
  const StripVariant variant = hull.method.variant;

  const PairIntegrals heave = pair_of(integrals, kA33, kB33);
  const PairIntegrals sway = pair_of(integrals, kA22, kB22);
  const PairIntegrals coupled = pair_of(integrals, kA24, kB24);
  const PairIntegrals roll = pair_of(integrals, kA44, kB44);

  HydrodynamicCoefficients out;
  add_impedances(out, heave, variant, kVertical, kVertical, omega_e, speed);
  add_impedances(out, sway, variant, kSwayYaw, kSwayYaw, omega_e, speed);
  add_impedances(out, coupled, variant, kSwayYaw, kRoll, omega_e, speed);
  add_impedances(out, coupled, variant, kRoll, kSwayYaw, omega_e, speed);
  add_impedances(out, roll, variant, kRoll, kRoll, omega_e, speed);
  add_surge(hull, out);
  return out;
}

HydrodynamicCoefficients hydrodynamic_coefficients(const LoadedHull& hull, double omega_e, double speed) {
  LengthIntegrals integrals;
  length_integrals(hull, omega_e, integrals);
  return hydrodynamic_coefficients(hull, integrals, omega_e, speed);
}

}  // namespace quickstrip
