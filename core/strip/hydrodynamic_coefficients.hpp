// Added mass and damping of the ship at speed, six degrees of freedom, about G, by ordinary or modified strip
// theory.
//
// A strip's relative displacement is p_j(x) xi_j, its velocity v = (d/dt - V d/dx) of that; the force on the
// strip is
//   ordinary  -[(d/dt - V d/dx){a v} + b v],   modified  -(d/dt - V d/dx){(a - i b/omega_e) v}
// (formulas §4.1, §4.3); here both are written once, as impedances Z_kj = -omega_e^2 a_kj + i omega_e b_kj,
// and a_kj, b_kj are their parts. The V theta and V psi terms stand in added mass, SEAWAY's habit; the
// motions do not depend on where they stand. Potential flow only: added roll damping is the equation of
// motion's.
#pragma once

#include <array>

#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

using Matrix6 = std::array<std::array<double, 6>, 6>;

struct HydrodynamicCoefficients {
  Matrix6 a{};  // kg, kg m, kg m2
  Matrix6 b{};  // N s/m, N s, N m s
};

/// `integrals`: at |omega_e|. omega_e: signed, not zero [rad/s]; speed V >= 0 [m/s].
HydrodynamicCoefficients hydrodynamic_coefficients(const LoadedHull& hull, const LengthIntegrals& integrals,
                                                   double omega_e, double speed);

/// The same, with the integrals of this frequency.
HydrodynamicCoefficients hydrodynamic_coefficients(const LoadedHull& hull, double omega_e, double speed);

}  // namespace quickstrip
