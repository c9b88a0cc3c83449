// Phase of the sway (and roll) load of a beam wave on a restrained section: that of the wave which the
// section radiates in sway, by the Haskind relation. Amplitudes of radiated waves follow from damping; their
// phase does not, and it differs from section to section: the yaw moment in beam seas hangs on that.
//
//   X2 = |X2| e^{i phase},  phase = pi/2 + kb - gamma,  b = B/2,
//   cot gamma = 1 / {kb + k^2 D2 P(k sigma T)} + c,  D2 = A + a22(0)/rho,  P(z) = 2 I1(z) / (z^2 K1(z)),
//   c = H0^1.5 / (H0^1.5 + 0.85) max(0, 1 - sigma).
// Long waves to the second order in k, and the vertical plate at every k [Ursell1947] (tan gamma = pi I1/K1),
// come out exactly; short waves act on the weather side alone (gamma = pi/2). c, for flared sides, is fitted
// to the multipole solution over 3,000 sections, 0.06 <= H0 <= 6, sigma from the re-entrant limit to 1.05
// times the conventional one, k T 0.01 ... 5.
// Assumes deep water and Lewis sections. Error against that solution: below H0 = 1.5 90 % within 0.03 rad,
// the worst 0.07; to H0 = 8 90 % within 0.08, the worst 0.15 (tests/strip). Cost: some 60 ns.
#pragma once

#include "core/hull/lewis_section.hpp"

namespace quickstrip {

/// For the crest at the section at t = 0 and e^{i omega t}, waves from starboard. k > 0 [rad/m].
double sway_load_phase(const LewisSection& section, double k);

}  // namespace quickstrip
