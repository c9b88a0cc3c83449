// Moments of a spectrum and the periods that follow from them; the energy that hat functions take.
// m_n = integral of omega^n S(omega). Gauss panels no wider than 1/20 of omega_p (at higher frequencies of
// omega): relative error below 1e-9 of m0 (tests/sea, against closed forms). No state.
// Sources: formulas of [Journee1992] §4; names of periods in core/NOTATION.md.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "core/base/capacity.hpp"
#include "core/base/constants.hpp"
#include "core/sea/spectrum.hpp"

namespace quickstrip {

using DensityTerms = std::array<double, kDensityTerms>;

/// Hs = 4 sqrt(m0) [m].
inline double significant_wave_height(double m0) {
  return 4.0 * std::sqrt(m0);
}
/// T1 = 2 pi m0 / m1 [s], of a sea or of a response; 0 where nothing moves.
inline double mean_period(double m0, double m1) {
  return m1 > 0.0 ? kTwoPi * m0 / m1 : 0.0;
}
/// T2 = 2 pi sqrt(m0 / m2) [s]; 0 where nothing moves.
inline double zero_crossing_period(double m0, double m2) {
  return m2 > 0.0 ? kTwoPi * std::sqrt(m0 / m2) : 0.0;
}

/// m_n of the whole spectrum, tail to infinity; n = 0, 1 or 2.
double moment(const Spectrum& spectrum, int n);

/// m_n of what lies between two frequencies, 0 <= from <= to; any n. At most 4,096 panels: `to` up to about
/// 1e4 omega_p.
double moment_between(const Spectrum& spectrum, int n, double from, double to);

/// energy[i] = integral of S times the hat function of node omega[i], a half hat at the two ends [m2]. omega
/// strictly increasing, both spans of one length. The sum is the energy between the end nodes.
/// Cost: about 500 densities an ordinary grid, at most 320 an interval.
void hat_energies(const Spectrum& spectrum, std::span<const double> omega, std::span<double> energy);

/// Density between two frequencies as a cubic, by least squares: sum of terms[l] P_l(t) with t from 0 to 1
/// over the interval (core/base/legendre.hpp) [m2 s]. Moments 0 ... 3 over the interval are kept. Cost: as
/// hat_energies, an interval.
DensityTerms density_terms(const Spectrum& spectrum, double from, double to);

}  // namespace quickstrip
