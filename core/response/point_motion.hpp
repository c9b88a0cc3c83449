// Motions and accelerations of a point fixed to the ship, from the six motions of G.
//
// Computes: complex amplitudes per metre of wave amplitude, times e^{i omega_e t}.
// Assumes: rigid ship, small angles (products of motions left out).
// Error: that of the motions; the algebra is exact.
// Cost: some ten complex products, no memory.
// Source: NOTATION.md (local motions); [Journee1992] §3: longitudinal and lateral accelerations in the
// ship-bound system get a component of gravity.
#pragma once

#include <complex>

#include "core/strip/motion_transfer.hpp"

namespace quickstrip {

/// Relative to G: x forward, y to port, z up [m].
struct Position {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

/// Along the ship-fixed axes: m/m for displacements, (m/s2)/m for accelerations.
struct PointMotion {
  std::complex<double> x;
  std::complex<double> y;
  std::complex<double> z;
};

/// X = x - y_b psi + z_b theta; Y = y + x_b psi - z_b phi; Z = z - x_b theta + y_b phi.
PointMotion point_displacement(const MotionTransfer& transfer, const Position& position);

/// What an accelerometer fixed to the ship feels: a_x = Xdd - g theta, a_y = Ydd + g phi, a_z = Zdd (static g
/// left out). gravity > 0 [m/s2].
PointMotion point_acceleration(const MotionTransfer& transfer, const Position& position, double gravity);

}  // namespace quickstrip
