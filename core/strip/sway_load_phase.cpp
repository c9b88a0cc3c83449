#include "core/strip/sway_load_phase.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/constants.hpp"
#include "core/hull/lewis_limits.hpp"

namespace quickstrip {
namespace {

// I1(z) / z, 0 <= z <= 3.75, within 8e-9 [AbramowitzStegun1964] 9.8.3.
double bessel_i1_by_z(double z) {
  const double t = z / 3.75;
  const double u = t * t;
  return 0.5 +
         u * (0.87890594 +
              u * (0.51498869 + u * (0.15084934 + u * (0.02658733 + u * (0.00301532 + u * 0.00032411)))));
}

// z K1(z), 0 < z <= 2 within 8e-9 and above within 2.2e-7 z^0.5 e^-z [AbramowitzStegun1964] 9.8.7, 9.8.8.
double z_bessel_k1(double z) {
  if (z <= 2.0) {
    const double u = 0.25 * z * z;
    return z * z * std::log(0.5 * z) * bessel_i1_by_z(z) + 1.0 +
           u * (0.15443144 +
                u * (-0.67278579 +
                     u * (-0.18156897 + u * (-0.01919402 + u * (-0.00110404 - u * 0.00004686)))));
  }
  const double v = 2.0 / z;
  return std::sqrt(z) * std::exp(-z) *
         (1.25331414 +
          v * (0.23498619 +
               v * (-0.03655620 + v * (0.01504268 + v * (-0.00780353 + v * (0.00325614 - v * 0.00068245))))));
}

// P(z) = 2 I1 / (z^2 K1): by how much the plate's tan gamma exceeds its long-wave form. Beyond z = 3.5 the
// tangent is above 600 and what it is no longer matters.
double plate_factor(double z) {
  const double inside = std::clamp(z, 1e-9, 3.5);
  return 2.0 * bessel_i1_by_z(inside) / z_bessel_k1(inside);
}

// Of flared sides, see the header.
double flare_term(double h0, double sigma) {
  const double slope = h0 * std::sqrt(h0);
  return slope / (slope + 0.85) * std::max(0.0, 1.0 - sigma);
}

}  // namespace

double sway_load_phase(const LewisSection& section, double k) {
  const double kb = 0.5 * k * section.breadth;
  const double mean_depth = section.area / section.breadth;  // sigma T
  const double d2 = low_frequency_radiation(section.a1, section.a3).sway * section.scale * section.scale;
  const double upright = kb + k * k * d2 * plate_factor(k * mean_depth);
  const double gamma = std::atan(upright / (1.0 + flare_term(section.h0, section.sigma) * upright));
  return 0.5 * kPi + kb - gamma;
}

}  // namespace quickstrip
