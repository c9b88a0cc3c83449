// Sections that are the conformal image of a circle, with N coefficients a1, a3 ... a_{2N-1}; Lewis forms are
// N = 2, the circle N = 0. In units of the mapping scale M:
//   w = z + i y = -{Z + sum_n (-1)^n a_{2n-1} Z^{-(2n-1)}},  Z = e^{alpha - i theta},
// on the hull (alpha = 0; theta = 0 at the keel ... pi/2 at the waterline)
//   y =   sin theta - sum_n (-1)^n a_{2n-1} sin (2n-1) theta,
//   z = -{cos theta + sum_n (-1)^n a_{2n-1} cos (2n-1) theta}.
// Signs are those of the Lewis form (core/hull/lewis_section.hpp). Exact; cost under 0.1 us.
#pragma once

#include <array>
#include <complex>
#include <cstddef>

#include "core/base/static_vector.hpp"

namespace quickstrip {

inline constexpr std::size_t kMaxMappingCoefficients = 10;

/// a1, a3, ..., a_{2N-1}, N = 0 ... 10.
using MappingCoefficients = StaticVector<double, kMaxMappingCoefficients>;

MappingCoefficients lewis_mapping(double a1, double a3);

/// (-1)^n a_{2n-1}, n = 1 ... N: what multiplies Z^{-(2n-1)}.
std::array<double, kMaxMappingCoefficients> power_coefficients(const MappingCoefficients& a);

/// g_s, s = 1 ... N, of (y^2 + z^2)/2 = const + sum_s g_s cos 2 s theta.
std::array<double, kMaxMappingCoefficients> radius_harmonics(const MappingCoefficients& a);

/// w = z + i y on the hull, and dw/dtheta.
struct MappedPoint {
  std::complex<double> w;
  std::complex<double> slope;
};
MappedPoint mapped_point(const MappingCoefficients& a, double theta);

double mapped_half_breadth(const MappingCoefficients& a);  // at the waterline
double mapped_draught(const MappingCoefficients& a);       // at the centre plane
double mapped_area(const MappingCoefficients& a);          // immersed, both sides

/// Whether dw/dZ vanishes nowhere on the hull and outside it (the test of Schur and Cohn on the polynomial in
/// Z^{-2}). A contour that does not cross itself, besides, has a flow about it.
bool is_conformal(const MappingCoefficients& a);

}  // namespace quickstrip
