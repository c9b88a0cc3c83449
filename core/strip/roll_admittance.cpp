#include "core/strip/roll_admittance.hpp"

#include "core/strip/hydrodynamic_coefficients.hpp"

namespace quickstrip {

RollAdmittance roll_admittance(const LoadedHull& hull, double omega_e, double speed) {
  using Complex = std::complex<double>;
  HydrodynamicCoefficients c = hydrodynamic_coefficients(hull, omega_e, speed);
  c.b[3][3] += reference_roll_damping(hull.roll_damping, speed);
  const auto z = [&](std::size_t i, std::size_t j, double inertia, double stiffness) {
    return Complex(stiffness - omega_e * omega_e * (inertia + c.a[i][j]), omega_e * c.b[i][j]);
  };
  const Complex sway = z(1, 1, hull.body.mass, 0.0);
  const Complex yaw = z(5, 5, hull.body.izz, 0.0);
  const Complex sway_yaw = z(1, 5, 0.0, 0.0);
  const Complex yaw_sway = z(5, 1, 0.0, 0.0);
  const Complex to_sway = z(1, 3, 0.0, 0.0);
  const Complex to_yaw = z(5, 3, 0.0, 0.0);
  const Complex det = sway * yaw - sway_yaw * yaw_sway;
  RollAdmittance out;
  out.sway_per_roll = (sway_yaw * to_yaw - yaw * to_sway) / det;
  out.yaw_per_roll = (yaw_sway * to_sway - sway * to_yaw) / det;
  out.impedance = z(3, 3, hull.body.ixx, hull.restoring.c44) + z(3, 1, 0.0, 0.0) * out.sway_per_roll +
                  z(3, 5, 0.0, 0.0) * out.yaw_per_roll;
  return out;
}

}  // namespace quickstrip
