// Potential surge terms. A ship is slender: a11 is 2-6 % of the displacement, and its wave damping is left
// out.
#pragma once

namespace quickstrip {

/// a11 / (rho nabla) of a prolate spheroid of length `length` and breadth `breadth` moving along its axis,
/// deeply submerged: alpha / (2 - alpha), alpha = (1 - e^2)/e^3 {ln((1 + e)/(1 - e)) - 2 e} [Lamb1932] art.
/// 114. Stands for the three-dimensional value of the equivalent longitudinal section of [Journee1992] §3,
/// whose details are not published. Range: 0 < breadth < length; tends to 1/2 (the sphere) as breadth ->
/// length, to 0 for a needle.
double spheroid_surge_added_mass_factor(double length, double breadth);

}  // namespace quickstrip
