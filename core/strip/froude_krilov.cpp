#include "core/strip/froude_krilov.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
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

// Twice in a change of loading's longest loop: a call would cost a third of it.
[[gnu::always_inline]] inline Kernels kernels(Pair u) {
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
};

// `decay`: of the points, two by two; of an odd last one the second is none.
ContourSums sum_over(ContourView contour, double b, std::span<const Pair> decay) {
  ContourSums out;
  const std::size_t last = contour.z.size() - 1;
  for (std::size_t i = 0; i <= last; i += 2) {
    const std::size_t next = std::min(i + 1, last);
    const Pair y = pair_of(contour.y[i], contour.y[next]);
    const Kernels at = kernels(b * y);
    const Pair pressed = decay[i / 2] * at.sin;
    out.breadth += pressed;
    out.moment += pair_of(contour.z[i], contour.z[next]) * pressed;
    out.roll += decay[i / 2] * at.roll;
  }
  return out;
}

double area_of(ContourView contour) {
  double sum = 0.0;
  for (std::size_t n = 0; n < contour.z.size(); ++n) {
    sum += contour.weight[n] * contour.y[n];
  }
  return sum;
}

double sum_of(Pair x) {
  return x[0] + x[1];
}

}  // namespace

std::size_t contour_decay(ContourView contour, double k, std::span<Pair> out) {
  const std::size_t n = contour.z.size();
  const std::size_t pairs = (n + 1) / 2;
  QS_CHECK(pairs <= out.size());
  for (std::size_t i = 0; i < pairs; ++i) {
    const bool has_second = 2 * i + 1 < n;
    const std::size_t next = has_second ? 2 * i + 1 : 2 * i;
    out[i] = exponential(k * pair_of(contour.z[2 * i], contour.z[next])) *
             pair_of(contour.weight[2 * i], has_second ? contour.weight[next] : Held(0.0));
  }
  return pairs;
}

FroudeKrilov froude_krilov(ContourView contour, double half_breadth, double density, double gravity, double k,
                           EncounterAngle mu) {
  ContourDecay decay;
  const std::size_t pairs = contour_decay(contour, k, decay);
  return froude_krilov(contour, half_breadth, density * gravity, k, std::sin(mu.radians),
                       std::cos(mu.radians), std::span(decay).first(pairs));
}

FroudeKrilov froude_krilov(ContourView contour, double half_breadth, double rho_g, double k, double sin_mu,
                           double cos_mu, std::span<const Pair> decay) {
  const double b = k * sin_mu;
  const double used = std::fabs(b) > kLeastWaveNumber ? b : std::copysign(kLeastWaveNumber, b);
  const ContourSums sums = contour.z.empty() ? ContourSums{} : sum_over(contour, used, decay);
  const Kernels at_waterline = kernels(both(used * half_breadth));
  const double by_b = 1.0 / used;
  const double by_b2 = by_b * by_b * (b / used);
  const double breadth_integral = sum_of(sums.breadth) * by_b;  // of e^{kz} Y S(bY), S(u) = sin(u)/u
  const double moment_integral = sum_of(sums.moment) * by_b;    // of z e^{kz} Y S(bY)
  const double roll_integral = sum_of(sums.roll) * by_b2;       // of e^{kz} W(Y)
  const double area = area_of(contour);
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
