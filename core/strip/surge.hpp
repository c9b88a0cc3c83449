// Surge: potential added mass and viscous damping. A ship is slender: a11 is 2-6 % of the displacement, and
// its wave damping is left out.
#pragma once

namespace quickstrip {

/// a11 / (rho nabla) of a prolate spheroid of length `length` and breadth `breadth` moving along its axis,
/// deeply submerged: alpha / (2 - alpha), alpha = (1 - e^2)/e^3 {ln((1 + e)/(1 - e)) - 2 e} [Lamb1932] art.
/// 114. Stands for the three-dimensional value of the equivalent longitudinal section of [Journee1992] §3,
/// whose details are not published. Range: 0 < breadth < length; tends to 1/2 (the sphere) as breadth ->
/// length, to 0 for a needle.
double spheroid_surge_added_mass_factor(double length, double breadth);

/// Still-water resistance [N] of a merchant ship of `lpp` [m], displaced volume [m3] at V [m/s], after the
/// curve of [Troost1955] that [Journee1992] §3 takes surge damping from:
///   R = C_R rho volume^(2/3) V^2,  10^3 C_R = 3.6 + 15.2 / (log10 lpp + 0.6).
/// The paper's text is damaged at this place. These constants are the reading that gives a plausible
/// resistance (S-175 at 16.1 kn: 524 kN); the line of the parent program as remembered, 0.0152 / (log10 L +
/// 0.6) + 0.0035, is 1.1 % below it. Range: merchant ships, lpp 10 ... 400 m; a slope for damping, not a
/// resistance to power a ship by. lpp in metres enters the logarithm: it does not follow Froude's law.
double still_water_resistance(double lpp, double volume, double density, double speed);

/// dR/dV / V of it [N s2/m2], which does not depend on V: b11 = V times this, in the surge equation alone.
double surge_damping_per_speed(double lpp, double volume, double density);

}  // namespace quickstrip
