// Motion sickness incidence: the share of unadapted people who vomit, from the vertical motion of the place
// where they are.
//
//   1974, two hours:  Phi([log10(a/g) - mu] / 0.4),  mu = -0.819 + 2.32 (log10 omega)^2, omega in rad/s
//   1976, time t:     Phi(z_a) Phi(z_t'), z_a = (log10(a/g) - mu_a) / 0.47,
//                     mu_a = 0.87 + 4.36 log10 f + 2.73 (log10 f)^2, f in Hz (worst at 0.16 Hz)
//                     z_t' = ((log10 t - 1.46)/0.76 + 0.75 z_a) / sqrt(1 - 0.75^2), t in minutes
// a: mean of |vertical acceleration|, sqrt(2/pi) = 0.798 times its RMS; omega = sqrt(m4/m2) of the vertical
// displacement: the RMS acceleration over the RMS velocity.
// Our choice of a: the same mean in both. The models are fits to the same experiments, and at 120 minutes
// they agree to 2 % of people in the same a; with the RMS in place of the mean, as the paper of 1976 may be
// read, the incidence would be up to 9 % of people higher.
// Trap: with omega converted to Hz in the polynomial of 1974, as one public toolbox has it, 0.1 g at 0.16 Hz
// would make 0.002 % of people sick in place of 33 %.
// Range: experiments of 0.083 ... 0.7 Hz, 0.03 ... 0.55 g RMS and two hours; formulas fall off smoothly
// outside. Valid for a mean of people: crews adapt in days.
// Cost: one logarithm and two erfc.
// Sources: O'Hanlon and McCauley (1974), Aerospace Medicine 45; McCauley et al. (1976), Human Factors
// Research TR 1733-2; the form with 0.798 and omega as in Lloyd, Seakeeping (1989).
#pragma once

#include "core/response/watch.hpp"

namespace quickstrip {

/// RMS vertical acceleration [m/s2] and the frequency that goes with it [rad/s], >= 0.
struct VerticalShaking {
  double rms_acceleration = 0.0;
  double frequency = 0.0;
};

/// Share of people, 0 ... 1. exposure [s]; 0: the model of 1974. Nothing that moves makes nobody sick.
double motion_sickness(const VerticalShaking& shaking, double exposure);

/// The factor on the motion at which that share becomes `limit`, in (0, 1); infinite where nothing moves.
/// Closed form but for the quantile of Phi (or of the product of 1976): Newton on a concave function, which
/// cannot overshoot twice; some 5 steps, at most 60.
double motion_sickness_margin(const VerticalShaking& shaking, double exposure, double limit);

/// Vertical velocity at the point of `acceleration`, any acceleration channel of it: m0 is the variance of
/// the velocity, m2 that of the acceleration. gravity > 0 [m/s2].
Channel motion_sickness_channel(const Channel& acceleration, double gravity);

/// Of that channel's moments.
VerticalShaking vertical_shaking(double m0, double m2);

}  // namespace quickstrip
