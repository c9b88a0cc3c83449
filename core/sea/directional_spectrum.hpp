// What a measured directional spectrum means: piecewise linear in frequency between its bands, nothing
// outside them; in direction one value a sector of 2 pi / N. Its energy is therefore the trapezoidal sum over
// frequency times the sum over directions. No state; cost one pass over the cells.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/result.hpp"
#include "core/sea/sea_state.hpp"

namespace quickstrip {

/// Refuses: fewer than 3 bands or 4 directions; frequencies not positive or not increasing; directions that
/// are not evenly spaced round the whole circle (either sense, any start); density negative or not finite; no
/// energy at all. Errors: kNotFinite, kOutOfRange, kEmptySpectrum.
Status check_spectrum(const DirectionalSpectrum& spectrum);

/// Trapezoidal weights of the bands [rad/s]: the integral of each band's hat function.
using BandWidths = std::array<double, kMaxSpectrumFrequencies>;
BandWidths band_widths(std::span<const double> frequencies);

/// Variance of the sea surface [m2].
double zeroth_moment(const DirectionalSpectrum& spectrum);

}  // namespace quickstrip
