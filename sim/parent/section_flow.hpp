// What a solution of the flow about an oscillating section gives, whichever method found it: added mass,
// damping and radiated waves, and the potentials on the hull from which the loads of any wave follow.
//
// Two-dimensional potential flow, deep water, section symmetric about the centre plane, oscillating about O
// (waterline, centre plane; z up, y to port) with e^{i omega t}. Geometry alone: rho = 1, lengths in m,
// frequency as K = omega^2 / g. Potentials are those of a unit velocity, phi_j,n = n_j on the hull, n out of
// the body into the water, n_2 = n_y, n_3 = n_z, n_4 = y n_z - z n_y (NOTATION.md).
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

namespace quickstrip {

enum SectionMode : std::size_t { kSectionSway, kSectionHeave, kSectionRoll, kNumSectionModes };

/// A point of quadrature on the half contour y >= 0; the other half follows by symmetry (heave even in y,
/// sway and roll odd).
struct FlowPoint {
  double y = 0.0;
  double z = 0.0;      // from the waterline, up [m]
  double ny_ds = 0.0;  // the normal times the length that the point stands for [m]
  double nz_ds = 0.0;
  std::array<std::complex<double>, kNumSectionModes> phi{};
};

struct SectionFlow {
  double wave_number = 0.0;  // K of the oscillation [1/m]
  double a22 = 0.0;          // added mass / rho: m2, m3 (24), m4 (44)
  double a24 = 0.0;
  double a44 = 0.0;
  double a33 = 0.0;
  // b / (rho omega) = h^2: signed amplitudes of the radiated waves, b24 = b22 h4/h2. h2 > 0 in long waves.
  double h2 = 0.0;  // m
  double h4 = 0.0;  // m2
  double h3 = 0.0;  // m
  std::vector<FlowPoint> points;
  bool is_converged = true;  // false: the method's own check of its accuracy failed
};

/// A wave's diffraction load on the section as that of an equivalent motion of the water, v_2 = omega sin mu
/// sway, v_3 = i omega heave per metre of wave amplitude, crest at O at t = 0:
///   X_3 = (i omega a33 + b33) heave v_3,  X_2 = (i omega a22 + b22) sway v_2,
///   X_4 = {(i omega a24 + b24) sway + (i omega a22 + b22) roll_lever} v_2 (about O).
/// Towards long waves heave, sway -> 1 and roll_lever -> 0.
struct DiffractionFactors {
  std::complex<double> heave;
  std::complex<double> sway;
  std::complex<double> roll_lever;  // m
};

/// By Green's theorem from the radiation potentials: D_j = -i omega rho int phi_j V_n ds, V_n the normal
/// velocity of the undisturbed wave e^{kz - i k y sin mu} ([STF1970] eq. 39 f.). `k`: wave
/// number of the wave [1/m], which at speed is not flow.wave_number; sin mu in [-1, 1], its limit at 0
/// included.
DiffractionFactors diffraction_factors(const SectionFlow& flow, double k, double sin_mu);

}  // namespace quickstrip
