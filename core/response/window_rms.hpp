// How far the RMS of a window of measured motion may lie from the RMS of the process: a record of some
// minutes is a sample.
//
// The variance of a Gaussian record of length T about the variance of its process is, as a part of its
// square, (2/T) integral of rho^2 over all lags, rho the autocorrelation [BendatPiersol2010]. Of a spectrum
// like a bell about omega_1 with standard deviation s that is sqrt(pi) / (s T); of a resonance of damping
// ratio z at omega it is 1 / (z omega T). s follows from the periods: s / omega_1 = sqrt((T1/T2)^2 - 1). The
// wider one is taken. Relative deviation of the RMS: half the root. Range: T of ten periods and more; at
// most 1.
#pragma once

namespace quickstrip {

/// Relative standard deviation of the RMS of `window` [s]. t1, t2: mean and zero-crossing period [s];
/// damping_ratio: of the resonance that makes the response, 0 where there is none. 1 where nothing moves.
double window_rms_deviation(double t1, double t2, double window, double damping_ratio = 0.0);

}  // namespace quickstrip
