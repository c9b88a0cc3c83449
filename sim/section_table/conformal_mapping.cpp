#include "sim/section_table/conformal_mapping.hpp"

#include <cmath>

#include "core/base/check.hpp"
#include "core/base/constants.hpp"

namespace quickstrip {

MappingCoefficients lewis_mapping(double a1, double a3) {
  MappingCoefficients a;
  QS_CHECK(a.push_back(a1) && a.push_back(a3));
  return a;
}

std::array<double, kMaxMappingCoefficients> power_coefficients(const MappingCoefficients& a) {
  std::array<double, kMaxMappingCoefficients> c{};
  for (std::size_t n = 1; n <= a.size(); ++n) {
    c[n - 1] = n % 2 == 1 ? -a[n - 1] : a[n - 1];
  }
  return c;
}

std::array<double, kMaxMappingCoefficients> radius_harmonics(const MappingCoefficients& a) {
  // |w|^2 of the powers Z^1 and Z^{-(2n-1)}: differences of their exponents.
  const std::array<double, kMaxMappingCoefficients> c = power_coefficients(a);
  std::array<double, kMaxMappingCoefficients> g{};
  for (std::size_t s = 1; s <= a.size(); ++s) {
    g[s - 1] = c[s - 1];
    for (std::size_t m = 1; m + s <= a.size(); ++m) {
      g[s - 1] += c[m + s - 1] * c[m - 1];
    }
  }
  return g;
}

MappedPoint mapped_point(const MappingCoefficients& a, double theta) {
  const std::complex<double> turn = std::polar(1.0, theta);
  const std::complex<double> twice = turn * turn;
  const std::array<double, kMaxMappingCoefficients> c = power_coefficients(a);
  double y = turn.imag();
  double z = -turn.real();
  double dy = turn.real();
  double dz = turn.imag();
  std::complex<double> harmonic = turn;  // e^{i (2n-1) theta}
  for (std::size_t n = 1; n <= a.size(); ++n) {
    const double frequency = 2.0 * static_cast<double>(n) - 1.0;
    y -= c[n - 1] * harmonic.imag();
    z -= c[n - 1] * harmonic.real();
    dy -= frequency * c[n - 1] * harmonic.real();
    dz += frequency * c[n - 1] * harmonic.imag();
    harmonic *= twice;
  }
  return {{z, y}, {dz, dy}};
}

double mapped_half_breadth(const MappingCoefficients& a) {
  double total = 1.0;
  for (const double coefficient : a.span()) {
    total += coefficient;
  }
  return total;
}

double mapped_draught(const MappingCoefficients& a) {
  double total = 1.0;
  for (const double c : power_coefficients(a)) {
    total += c;
  }
  return total;
}

double mapped_area(const MappingCoefficients& a) {
  double total = 1.0;
  for (std::size_t n = 1; n <= a.size(); ++n) {
    total -= (2.0 * static_cast<double>(n) - 1.0) * a[n - 1] * a[n - 1];
  }
  return 0.5 * kPi * total;
}

bool is_conformal(const MappingCoefficients& a) {
  // -dw/dZ = 1 - sum_n (2n-1) c_n u^n, u = Z^{-2}: no zero in |u| <= 1.
  const std::array<double, kMaxMappingCoefficients> c = power_coefficients(a);
  std::array<double, kMaxMappingCoefficients + 1> p{};
  p[0] = 1.0;
  for (std::size_t n = 1; n <= a.size(); ++n) {
    p[n] = -(2.0 * static_cast<double>(n) - 1.0) * c[n - 1];
  }
  for (std::size_t degree = a.size(); degree > 0; --degree) {
    if (!(std::abs(p[degree]) < std::abs(p[0]))) {
      return false;
    }
    const std::array<double, kMaxMappingCoefficients + 1> q = p;
    for (std::size_t k = 0; k < degree; ++k) {
      p[k] = (q[0] * q[k] - q[degree] * q[degree - k]) / (q[0] * q[0]);
    }
  }
  return true;
}

}  // namespace quickstrip
