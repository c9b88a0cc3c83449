// Short-term statistics of a response from the moments of its spectrum.
//
// Computes: significant amplitude, Rayleigh exceedance, occurrences per hour, the most probable maximum,
// bandwidth and what it does to the distribution of maxima.
// Assumes: Gaussian and stationary. What is counted by zero up-crossings (one amplitude for each: "per wave
// encounter") needs no more than that: of a Gaussian response, level a is crossed upwards exp(-a^2/2m0) times
// as often as zero, whatever the bandwidth ([Rice1945]); so are rates per hour and the most probable maximum
// of a duration. What "spectra that are not too wide" ([Journee1992] §3) is needed for is that an amplitude
// is a maximum: a wide-banded response has maxima that are no crests. Of its positive maxima a high level is
// exceeded by 2 alpha / (1 + alpha) of what Rayleigh says, alpha = sqrt(1 - epsilon^2), and the mean of the
// highest third is below 2 sqrt(m0): both err on the safe side.
// Range: moments >= 0. A response that does not move has period 0 and exceeds nothing.
// Sources: [Journee1992] §3; [CartwrightLonguetHiggins1956] for maxima; NOTATION.md: m_n = integral of
// |H|^2 S |omega_e|^n over wave frequency.
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

/// T4 = 2 pi sqrt(m2 / m4): mean time between maxima [s]; 0 where nothing moves.
double crest_period(double m2, double m4);

/// epsilon = sqrt(1 - m2^2 / (m0 m4)), 0 narrow ... 1 wide; 0 where nothing moves. m4 is an integral to the
/// highest wave frequency: of a response that follows short waves (relative motion), whose m4 has no limit,
/// so does epsilon depend on that frequency.
double bandwidth(double m0, double m2, double m4);

/// Above it the positive maxima exceed a high level less than 0.8 times as often as Rayleigh says (alpha <
/// 2/3): a quarter, the factor within which probabilities are to hold.
inline constexpr double kWideBandwidth = 0.745356;  // sqrt(5)/3

/// Share of the positive maxima above `level` >= 0, for any bandwidth.
double maxima_exceedance(double level, double m0, double epsilon);

/// sqrt(2 m0 ln(T/T2)): the amplitude that the largest of a duration most probably has [s]; 0 where the
/// duration is shorter than T2. With the number of positive maxima and their own distribution in place of
/// zero up-crossings and Rayleigh's it is the same, whatever the bandwidth ([Ochi1973], epsilon < 0.9).
double most_probable_maximum(double m0, double m2, double duration);

}  // namespace quickstrip
