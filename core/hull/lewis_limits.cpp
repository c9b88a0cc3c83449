#include "core/hull/lewis_limits.hpp"

#include <cmath>

#include "core/base/constants.hpp"

namespace quickstrip {

LewisAddedMass lateral_added_mass_at_zero(double a1, double a3) {
  const double f = a1 * (1.0 + a3);
  const double moment =
      (1.0 - a1) * (4.0 / 3.0 * f + 16.0 / 15.0 * a3) + a3 * (4.0 / 5.0 * f - 16.0 / 7.0 * a3);
  return {.a22 = 0.5 * kPi * ((1.0 - a1) * (1.0 - a1) + 3.0 * a3 * a3),
          .a24 = -2.0 * moment,
          .a44 = 16.0 / kPi * (f * f + 8.0 / 9.0 * a3 * f + 16.0 / 9.0 * a3 * a3)};
}

LewisAddedMass lateral_added_mass_at_infinity(double a1, double a3) {
  const double f = a1 * (1.0 + a3);
  const double draught = 1.0 - a1 + a3;
  const double moment = f * ((1.0 - a1) / 3.0 + 0.6 * a3) + 2.0 * a3 * ((1.0 - a1) / 15.0 - 3.0 * a3 / 7.0);
  return {.a22 = 2.0 / kPi * (draught * draught + 16.0 / 3.0 * a3 * a3),
          .a24 = -4.0 * moment,
          .a44 = kPi * (f * f + 2.0 * a3 * a3)};
}

double heave_added_mass_at_infinity(double a1, double a3) {
  return 0.5 * kPi * ((1.0 + a1) * (1.0 + a1) + 3.0 * a3 * a3);
}

double heave_added_mass_constant(double a1, double a3) {
  // Terms fall as m^-5: the tail after 60 is below 1e-9 of the sum.
  constexpr int kTerms = 60;
  double sum = 0.0;
  for (int m = 1; m <= kTerms; ++m) {
    const double square = 4.0 * m * m;
    const double term = (1.0 + a1) / (square - 1.0) + 9.0 * a3 / (square - 9.0);
    sum += term * term / m;
  }
  return 4.0 / kPi * sum;
}

LewisRadiation low_frequency_radiation(double a1, double a3) {
  const LewisAddedMass at_zero = lateral_added_mass_at_zero(a1, a3);
  const double breadth = 2.0 * (1.0 + a1 + a3);
  const double area = 0.5 * kPi * (1.0 - a1 * a1 - 3.0 * a3 * a3);
  // First moment of the area below the waterline, 2 integral of y z' dz' over the quarter contour: with
  // y = p s1 - a3 s3 and depth = r c1 + a3 c3 (s, c of theta and 3 theta), by the integral of y^2 ... below.
  const double p = 1.0 + a1;
  const double r = 1.0 - a1;
  // A zbar = 2 integral y depth (-d depth) = integral depth^2 dy (by parts); products of three harmonics.
  const auto triple = [](int i, int j, int k) {
    // integral over 0 ... pi/2 of cos i theta cos j theta cos k theta, i + j + k odd
    const auto one = [](int n) {
      const int m = n < 0 ? -n : n;
      return (m % 4 == 1 ? 1.0 : -1.0) / m;
    };
    return 0.25 * (one(i + j + k) + one(i + j - k) + one(i - j + k) + one(i - j - k));
  };
  const double moment =
      p * (r * r * triple(1, 1, 1) + 2.0 * r * a3 * triple(1, 3, 1) + a3 * a3 * triple(3, 3, 1)) -
      3.0 * a3 * (r * r * triple(1, 1, 3) + 2.0 * r * a3 * triple(1, 3, 3) + a3 * a3 * triple(3, 3, 3));
  return {.heave = breadth,
          .sway = area + at_zero.a22,
          .roll = moment - breadth * breadth * breadth / 12.0 + at_zero.a24};
}

}  // namespace quickstrip
