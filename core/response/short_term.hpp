// Short-term statistics of a response from the moments of its spectrum.
//
// Computes: significant amplitude, mean and zero-crossing periods, Rayleigh exceedance, occurrences per hour.
// Assumes: Gaussian and narrow-banded ([Journee1992] §3: "spectra that are not too wide").
// Range: moments >= 0. A response that does not move has period 0 and exceeds nothing.
// Source: [Journee1992] §3; NOTATION.md: m_n = integral of |H|^2 S |omega_e|^n over wave frequency.
#pragma once

namespace quickstrip {

/// Single amplitude, 2 sqrt(m0).
double significant_amplitude(double m0);

/// P(amplitude > level) = exp(-level^2 / (2 m0)); 1 for level <= 0.
double rayleigh_exceedance(double level, double m0);

/// T1 = 2 pi m0 / m1 [s]; 0 without motion.
double mean_period(double m0, double m1);

/// T2 = 2 pi sqrt(m0 / m2) [s]; 0 without motion.
double zero_crossing_period(double m0, double m2);

/// 3600 / T2: zero up-crossings per hour; 0 without motion.
double oscillations_per_hour(double m0, double m2);

}  // namespace quickstrip
