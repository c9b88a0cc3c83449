// Shipping of water: the relative motion at a freeboard point exceeds the freeboard.
//
// P per wave encounter = exp(-f^2 / 2 m0), m0 of the vertical relative motion.
// Static swell-up lessens the freeboard, dynamic swell-up raises m0: swell_up.hpp.
#pragma once

namespace quickstrip {

/// Per wave encounter. freeboard [m] from the still waterline to the deck edge, > 0.
double wetness_probability(double freeboard, double m0);

/// N = 3600 / (2 pi) sqrt(m2 / m0) P.
double wetnesses_per_hour(double freeboard, double m0, double m2);

}  // namespace quickstrip
