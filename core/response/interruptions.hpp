// Motion-induced interruptions: how often a person who stands on deck has to stop work, step or hold on so as
// not to tip over (Graham).
//
//   GLFE = (1/3) h phi_dd - a_y -/+ (b/h) a_z    - tipping to port, + to starboard
// tips when GLFE to port rises above (b/h) g, or GLFE to starboard falls below -(b/h) g. a_y, a_z: what an
// accelerometer at the point feels, a_y with its g phi. One complex transfer function a side, then its
// square: phases between roll, sway and heave decide, and make the two sides different.
//   number a minute = sum over both sides of 60/(2 pi) sqrt(m2/m0) exp(-((b/h) g)^2 / (2 m0))
// Assumes: facing fore or aft; feet that neither slip nor step; a person as a rigid body of height 2 h, whose
// own moment of inertia is m h^2/3: that is the first term. It leaves out that the centre of gravity stands h
// above the deck (another h phi_dd, 3 % of g phi at a roll period of 12 s): give the point at the height of
// the centre of gravity where that matters. Gaussian, stationary (short_term.hpp): every upcrossing of the
// level is an interruption, so consecutive ones of one oscillation to the same side are one.
// Source: Graham, R. (1990), Motion-induced interruptions as ship operability criteria, Naval Engineers
// Journal 102(2); h = 1.20 m and b/h = 0.25 as in Bureau Veritas NR 483. Signs derived for NOTATION.md's axes
// and checked against a person in the time domain (tests/response).
#pragma once

#include "core/response/watch.hpp"

namespace quickstrip {

/// Of a standing person.
struct Stance {
  double height = 1.20;            // h, of the centre of gravity above the feet [m]
  double half_width_ratio = 0.25;  // b/h; b is half the distance between the feet
  bool operator==(const Stance&) const = default;
};

/// At the point of `acceleration`, any acceleration channel of it; gravity > 0 [m/s2]. m0 is in (m/s2)^2.
Channel interruption_channel(const Channel& acceleration, const Stance& stance, bool to_starboard,
                             double gravity);

/// To one side: crossings of `level` [m/s2] a minute.
double interruptions_per_minute(double level, double m0, double m2);

}  // namespace quickstrip
