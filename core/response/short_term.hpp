// Short-term statistics of a response from the moments of its spectrum.
//
// Computes: significant amplitude, Rayleigh exceedance, occurrences per hour.
// Assumes: Gaussian and narrow-banded ([Journee1992] §3: "spectra that are not too wide").
// Range: moments >= 0. A response that does not move has period 0 and exceeds nothing.
// Source: [Journee1992] §3; NOTATION.md: m_n = integral of |H|^2 S |omega_e|^n over wave frequency.
// Periods T1 and T2 of a response are those of any spectrum: core/sea/moments.hpp.
#pragma once

#include "core/sea/moments.hpp"

namespace quickstrip {

/// Single amplitude, 2 sqrt(m0).
double significant_amplitude(double m0);

/// P(amplitude > level) = exp(-level^2 / (2 m0)); 1 for level <= 0.
double rayleigh_exceedance(double level, double m0);

/// 3600 / T2: zero up-crossings per hour; 0 without motion.
double oscillations_per_hour(double m0, double m2);

}  // namespace quickstrip
