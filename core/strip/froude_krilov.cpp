#include "core/strip/froude_krilov.hpp"

#include <algorithm>
#include <cmath>

namespace quickstrip {
namespace {

// sin(u)/u; below 1e-4 its series is exact to 1e-17.
double sinc(double u) {
  return std::fabs(u) < 1e-4 ? 1.0 - u * u / 6.0 : std::sin(u) / u;
}

// W(Y) = sin(bY)/b^2 - Y cos(bY)/b = Y^3 b (1/3 - (bY)^2/30 + ...); the series where the difference loses
// digits: next term (bY)^4/840 < 1e-11 at bY = 0.01 of the leading 1/3.
double roll_kernel(double b, double y) {
  const double u = b * y;
  if (std::fabs(u) < 1e-2) {
    return y * y * y * b * (1.0 / 3.0 - u * u / 30.0);
  }
  return (std::sin(u) - u * std::cos(u)) / (b * b);
}

}  // namespace

FroudeKrilov froude_krilov(ContourView contour, double half_breadth, double density, double gravity, double k,
                           EncounterAngle mu) {
  const double sin_mu = std::sin(mu.radians);
  const double cos_mu = std::cos(mu.radians);
  const double b = k * sin_mu;
  double breadth_integral = 0.0;  // of e^{kz} Y S(bY)
  double moment_integral = 0.0;   // of z e^{kz} Y S(bY)
  double roll_integral = 0.0;     // of e^{kz} W(Y)
  double area = 0.0;
  for (std::size_t n = 0; n < contour.z.size(); ++n) {
    const double decay = std::exp(k * contour.z[n]) * contour.weight[n];
    const double pressed = decay * contour.y[n] * sinc(b * contour.y[n]);
    breadth_integral += pressed;
    moment_integral += contour.z[n] * pressed;
    roll_integral += decay * roll_kernel(b, contour.y[n]);
    area += contour.weight[n] * contour.y[n];
  }
  const double rho_g = density * gravity;
  FroudeKrilov out;
  out.sway = 2.0 * rho_g * k * sin_mu * breadth_integral;
  out.surge = 2.0 * rho_g * k * cos_mu * breadth_integral;
  out.heave = 2.0 * rho_g * (half_breadth * sinc(b * half_breadth) - k * breadth_integral);
  out.roll =
      rho_g * (2.0 * roll_kernel(b, half_breadth) - 2.0 * k * roll_integral + 2.0 * b * moment_integral);
  out.horizontal_factor = area > 0.0 ? breadth_integral / area : 0.0;
  // A bulb's narrow waterline says nothing about the wave at its depth: there the factor leaves [0, 1].
  out.heave_factor = half_breadth > 0.0 ? std::clamp(out.heave / (2.0 * rho_g * half_breadth), 0.0, 1.0)
                                        : out.horizontal_factor;
  return out;
}

}  // namespace quickstrip
