#include "core/strip/froude_krilov.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/pair_functions.hpp"

namespace quickstrip {
namespace {

// Below it both kernels are their limits to the last digit, linear in b the one of roll.
constexpr double kLeastWaveNumber = 1e-9;  // 1/m

// sin u and sin u - u cos u, of which the latter is u^3 (1/3 - u^2/30 + ...): the series where the difference
// loses digits, next term u^4/840 < 1e-11 at u = 0.01 of the leading 1/3.
struct Kernels {
  Pair sin;
  Pair roll;
};

Kernels kernels(Pair u) {
  const SinCos at = sin_cos(u);
  const Pair u2 = u * u;
  return {at.sin,
          choose(magnitude(u) < both(1e-2), u * u2 * (1.0 / 3.0 - u2 * (1.0 / 30.0)), at.sin - u * at.cos)};
}

// Sums over a contour, two points side by side: of e^{kz} sin bY, times z, of e^{kz} (sin bY - bY cos bY),
// and of y alone.
struct ContourSums {
  Pair breadth{};
  Pair moment{};
  Pair roll{};
  Pair area{};
};

ContourSums sum_over(ContourView contour, double k, double b) {
  ContourSums out;
  const auto add = [&](Pair z, Pair y, Pair weight) {
    const Kernels at = kernels(b * y);
    const Pair decay = exponential(k * z) * weight;
    const Pair pressed = decay * at.sin;
    out.breadth += pressed;
    out.moment += z * pressed;
    out.roll += decay * at.roll;
    out.area += weight * y;
  };
  const std::size_t n = contour.z.size();
  for (std::size_t i = 0; i + 1 < n; i += 2) {
    add(pair_of(contour.z[i], contour.z[i + 1]), pair_of(contour.y[i], contour.y[i + 1]),
        pair_of(contour.weight[i], contour.weight[i + 1]));
  }
  if (n % 2 == 1) {
    add(both(contour.z[n - 1]), both(contour.y[n - 1]), pair_of(contour.weight[n - 1], 0.0));
  }
  return out;
}

double sum_of(Pair x) {
  return x[0] + x[1];
}

}  // namespace

FroudeKrilov froude_krilov(ContourView contour, double half_breadth, double density, double gravity, double k,
                           EncounterAngle mu) {
  const double sin_mu = std::sin(mu.radians);
  const double cos_mu = std::cos(mu.radians);
  const double b = k * sin_mu;
  const double used = std::fabs(b) > kLeastWaveNumber ? b : std::copysign(kLeastWaveNumber, b);
  const ContourSums sums = sum_over(contour, k, used);
  const Kernels at_waterline = kernels(both(used * half_breadth));
  const double by_b = 1.0 / used;
  const double by_b2 = by_b * by_b * (b / used);
  const double breadth_integral = sum_of(sums.breadth) * by_b;  // of e^{kz} Y S(bY), S(u) = sin(u)/u
  const double moment_integral = sum_of(sums.moment) * by_b;    // of z e^{kz} Y S(bY)
  const double roll_integral = sum_of(sums.roll) * by_b2;       // of e^{kz} W(Y)
  const double area = sum_of(sums.area);
  const double rho_g = density * gravity;
  FroudeKrilov out;
  out.sway = 2.0 * rho_g * k * sin_mu * breadth_integral;
  out.surge = 2.0 * rho_g * k * cos_mu * breadth_integral;
  out.heave = 2.0 * rho_g * (at_waterline.sin[0] * by_b - k * breadth_integral);
  out.roll =
      rho_g * (2.0 * at_waterline.roll[0] * by_b2 - 2.0 * k * roll_integral + 2.0 * b * moment_integral);
  out.horizontal_factor = area > 0.0 ? breadth_integral / area : 0.0;
  // A bulb's narrow waterline says nothing about the wave at its depth: there the factor leaves [0, 1].
  out.heave_factor = half_breadth > 0.0 ? std::clamp(out.heave / (2.0 * rho_g * half_breadth), 0.0, 1.0)
                                        : out.horizontal_factor;
  return out;
}

}  // namespace quickstrip
