// Propeller emergence: the vertical relative motion at the propeller exceeds the depth of the blade tip.
//
// P per wave encounter = exp(-h^2 / 2 m0), m0 of the vertical relative motion on the centre line at the
// propeller; h from the still waterline down to the upper blade tip.
// Assumes: Gaussian; the ship's stern wave, sinkage and trim under way left out (a stern wave would help),
// the dynamic swell-up as a factor on relative motion (swell_up.hpp). Source: [Journee1992] §3 for the
// statistics; the event as in operability criteria (operations: 0.1 to 0.25 of encounters).
#pragma once

namespace quickstrip {

/// Per wave encounter. depth [m] of the blade tip, >= 0: 0 when it is out of the water at rest, always.
double emergence_probability(double depth, double m0);

/// N = 3600 / (2 pi) sqrt(m2 / m0) P.
double emergences_per_hour(double depth, double m0, double m2);

}  // namespace quickstrip
