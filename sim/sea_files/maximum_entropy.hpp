// A directional distribution from its first two Fourier coefficients by maximum entropy, which is never
// negative: Lygre and Krogstad 1986 (J. Phys. Oceanogr. 16, 2052-2060).
//
// c_n = integral of D e^{i n theta} = r_n e^{i n alpha_n}, n = 1, 2. Of all D with these coefficients the one
// of maximum (Burg) entropy is the spectrum of a second-order autoregressive process, whose coefficients
// follow from the Yule-Walker equations c1 = f1 + f2 c1*, c2 = f1 c1 + f2:
//   f1 = (c1 - c2 c1*) / (1 - |c1|^2),   f2 = c2 - c1 f1,
//   D  = (1/2 pi) (1 - f1 c1* - f2 c2*) / |1 - f1 e^{-i theta} - f2 e^{-2 i theta}|^2.
// It is positive when |c1| < 1 and |f2| < 1. Coefficients that no distribution has (measuring noise in bands
// without energy) are brought in: |c1|, |f2| <= 0.99, and this is said.
//
// On the grid a value is the mean over its 5 degrees; the coefficients fed to the formula are corrected until
// those of the grid are the ones asked for. In the shipped storm they are within 1e-6 in every band with
// energy but one (2.4e-3, a needle of r1 = 0.97); the buoy reports r to 0.01 (tests/sea_files). Known
// weakness: the method likes peaks. A broad single peak may come out as two close ones, of the same mean
// direction and spreading. Cost: 25 us on average, at most 40 corrections of 4 us.
#pragma once

#include <array>
#include <complex>

#include "core/base/capacity.hpp"

namespace quickstrip {

struct DirectionalDistribution {
  std::array<double, kNumDirections> density{};  // 1/rad, > 0; the sum times 2 pi / 72 is 1
  bool clamped = false;                          // the coefficients were not those of any distribution
  double residual = 0.0;  // largest difference of a coefficient of the grid from the one asked for (clamped)
};

/// Direction d of the result: 2 pi d / 72, in the sense and from the zero in which the angles are.
DirectionalDistribution maximum_entropy(std::complex<double> c1, std::complex<double> c2);

}  // namespace quickstrip
