// Legendre polynomials of the unit interval: orthogonal, P_n(1) = 1, integral of P_n^2 over [0, 1] =
// 1/(2n+1).
#pragma once

#include <array>

namespace quickstrip {

/// P_0 ... P_3 of 2t - 1, t in [0, 1].
constexpr std::array<double, 4> legendre(double t) {
  const double x = 2.0 * t - 1.0;
  return {1.0, x, 0.5 * (3.0 * x * x - 1.0), 0.5 * x * (5.0 * x * x - 3.0)};
}

}  // namespace quickstrip
