// How the ship answers a roll moment: sway, roll and yaw, coupled, at one speed and frequency of encounter.
//
// With sway and yaw eliminated the roll equation is D x_4 = F_4, D the Schur complement of the lateral set;
// sway and yaw follow roll in ratios that know nothing of the roll damping. More damping b makes D + i
// omega_e b of D: motions at another damping are a rank-one update of solved ones.
// Depends on omega_e and V only, not on the wave. Negative omega_e: the complex conjugates. Source: equations
// of motion [Journee1992] §3. Cost: one set of coefficients, 0.6 us; no state.
#pragma once

#include <complex>

#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

struct RollAdmittance {
  std::complex<double> impedance;      // D [N m a rad], the hull's own (small-roll) damping included
  std::complex<double> sway_per_roll;  // of the answer to a roll moment [m/rad]
  std::complex<double> yaw_per_roll;   // [rad/rad]

  /// Roll of a unit moment [rad/(N m)].
  [[nodiscard]] std::complex<double> roll() const { return 1.0 / impedance; }
};

/// omega_e signed, not zero [rad/s]; V >= 0 [m/s].
RollAdmittance roll_admittance(const LoadedHull& hull, double omega_e, double speed);

}  // namespace quickstrip
