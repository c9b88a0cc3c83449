// Wave spectra over frequency: Bretschneider, mean JONSWAP, Neumann, from a height and any period.
//
// Each shape is a function of x = omega / omega_p only, divided by its own zeroth moment, so that the height
// and the period that went in are those of the spectrum, exactly and at any scale:
//   Bretschneider  x^-5 exp(-5/4 x^-4)                      [Journee1992] §4, ITTC 7.5-02-07-01
//   JONSWAP        the same times gamma^exp(-(x-1)^2 / 2 s^2), s = 0.07 below the peak, 0.09 above
//   Neumann        x^-6 exp(-3 x^-2)
// The period ratios T1/Tp and T2/Tp follow from the moments: closed forms (gamma functions), for JONSWAP plus
// the integral of what gamma adds. They are those of the whole spectrum, tail to infinity included: T2 of a
// measured or cut spectrum is longer (0.15 % at 20 omega_p). JONSWAP by T1 therefore keeps the real T1;
// 0.658 times the Bretschneider of that T1 would lengthen it by 8 %.
// Range: hs in (0, 60] m, period in (0, 100] s, gamma in [1, 20]. Error of the ratios below 1e-10
// (tests/sea). Cost: 320 exponentials for a JONSWAP, one a density.
#pragma once

#include "core/base/result.hpp"
#include "core/sea/sea_state.hpp"

namespace quickstrip {

/// A spectrum with its height and period settled.
struct Spectrum {
  SpectrumShape shape = SpectrumShape::kBretschneider;
  double m0 = 0.0;              // m2
  double peak_frequency = 0.0;  // omega_p [rad/s]
  double peakedness = 1.0;      // gamma
  double shape_moment = 1.0;    // integral of the shape over x
};

/// Direction and spreading of the system are not looked at. Errors: kNotFinite, kOutOfRange.
Result<Spectrum> spectrum_of(const WaveSystem& system);

/// S(omega) [m2 s], single-sided; 0 for omega <= 0.
double density(const Spectrum& spectrum, double omega);

/// Period of that kind divided by Tp. gamma in [1, 20], read for JONSWAP only. Errors: kNotFinite,
/// kOutOfRange.
Result<double> period_over_peak_period(SpectrumShape shape, double gamma, PeriodKind kind);

/// Moment of the shape in x, integral of x^n f(x) from 0 to infinity; n = 0, 1 or 2. gamma in [1, 20].
double shape_moment(SpectrumShape shape, double gamma, int n);

}  // namespace quickstrip
