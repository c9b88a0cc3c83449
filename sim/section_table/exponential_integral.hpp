// The exponential integral E1 in the second quadrant, where the wave potentials of a section below the free
// surface need it: t = K (z + i y), z <= 0, y >= 0.
// Relative error 1e-13 over |t| = 1e-9 ... 1e4 (tests/sections). Cost: 0.1 ... 1 us.
#pragma once

#include <complex>

namespace quickstrip {

/// e^t E1(t), principal branch; Re t <= 0, Im t >= 0 (at Im t = 0 the limit from above), t != 0.
/// Scaled, so that neither factor over- or underflows for deep sections at high frequency.
std::complex<double> scaled_exponential_integral(std::complex<double> t);

}  // namespace quickstrip
