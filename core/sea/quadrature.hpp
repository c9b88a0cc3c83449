// Composite Gauss-Legendre quadrature, five points a panel: exact for polynomials up to the ninth degree.
// Cost: 5 calls of f a panel; the number of panels is the caller's bound.
#pragma once

#include <array>
#include <cstddef>

namespace quickstrip {

// Abramowitz and Stegun 1964, table 25.4, n = 5.
inline constexpr std::array<double, 5> kGaussNode = {-0.9061798459386640, -0.5384693101056831, 0.0,
                                                     0.5384693101056831, 0.9061798459386640};
inline constexpr std::array<double, 5> kGaussWeight = {
    0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665, 0.2369268850561891};

/// Calls visit(x, weight) at every point of `panels` equal panels of [from, to].
template <typename Visit>
void for_each_gauss_point(double from, double to, std::size_t panels, Visit visit) {
  const double half = 0.5 * (to - from) / static_cast<double>(panels);
  for (std::size_t p = 0; p < panels; ++p) {
    const double middle = from + half * static_cast<double>(2 * p + 1);
    for (std::size_t i = 0; i < kGaussNode.size(); ++i) {
      visit(middle + half * kGaussNode[i], half * kGaussWeight[i]);
    }
  }
}

template <typename Function>
double integrate(double from, double to, std::size_t panels, Function f) {
  double sum = 0.0;
  for_each_gauss_point(from, to, panels, [&](double x, double weight) { sum += weight * f(x); });
  return sum;
}

}  // namespace quickstrip
