// The six linear equations of motion in two uncoupled sets, surge-heave-pitch and sway-roll-yaw, about G:
// sum_j {-omega_e^2 (M + a) + i omega_e b + c} x_j = X_i. Solved by cofactors, 3 x 3, complex.
#pragma once

#include <array>
#include <complex>

#include "core/base/angles.hpp"
#include "core/base/pair.hpp"
#include "core/strip/hydrodynamic_coefficients.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/motion_transfer.hpp"
#include "core/strip/wave_loads.hpp"

namespace quickstrip {

/// The floor of |omega_e| in coefficients and equations: min(0.42 sqrt(g/L), omega/2) [rad/s]. Below it
/// surge, sway and yaw would grow as 1/omega_e^2 with nothing to restore them; the minimum with omega/2 keeps
/// the long-wave limits (formulas §6). With sign(omega_e) the motions jump where omega_e changes sign.
double encounter_floor(const LoadedHull& hull, double omega);

/// How a wave is met, and the frequency that coefficients and equations see.
struct FlooredEncounter {
  Encounter encounter;
  double floored = 0.0;  // signed, at least the floor [rad/s]
};

/// One wave, met at any speed.
struct MetWave {
  double omega = 0.0;
  double k_cos_mu = 0.0;
  double floor = 0.0;  // encounter_floor()

  [[nodiscard]] FlooredEncounter at(double speed) const;
};
MetWave met_wave(const LoadedHull& hull, double omega, EncounterAngle mu);
MetWave met_wave(const LoadedHull& hull, double omega, double cos_mu);

/// Of the ship herself: inertia, restoring, and surge, which does not depend on frequency.
struct ShipTerms {
  RigidBody body;
  Restoring restoring;
  double a11 = 0.0;  // surge: added mass about G
  double a15 = 0.0;
  double a55 = 0.0;
  double b11_per_speed = 0.0;  // N s2/m2
  bool is_modified = false;    // StripVariant::kModified
};
ShipTerms ship_terms(const LoadedHull& hull);

/// Two sets of equations at once: of two speeds or two waves. Loads and motions in the order of the set.
struct MotionPair {
  Pair omega_e;  // floored
  Pair speed;
  std::array<LengthStencil, 2> integrals;  // at |omega_e|
};
using ThreePair = std::array<ComplexPair, 3>;
/// Surge, heave, pitch.
ThreePair solve_vertical(const ShipTerms& ship, const MotionPair& at, const ThreePair& load);
/// Sway, roll, yaw; `roll_damping`: b44 on top of potential damping [N m s].
ThreePair solve_lateral(const ShipTerms& ship, const MotionPair& at, Pair roll_damping,
                        const ThreePair& load);

/// Motions at G per metre of wave amplitude. `field` is the wave's; speed V >= 0 [m/s].
/// A singular set gives non-finite numbers, which solve_transfer_functions() refuses; potential damping makes
/// that impossible for a hull that load() accepted.
MotionTransfer motion_transfer(const LoadedHull& hull, const WaveField& field, double speed);

/// The same, and the loads that move her; zero where they are forced to zero.
MotionTransfer motion_transfer(const LoadedHull& hull, const WaveField& field, double speed,
                               std::array<Complex, 6>& load);

/// Motions of a ship whose loads are known, in the wave of frequency omega from mu; not forced to zero
/// anywhere. `roll_damping`: b44 on top of potential damping [N m s]; else that of vanishing roll.
MotionTransfer motions_under_load(const LoadedHull& hull, double omega, EncounterAngle mu, double speed,
                                  const std::array<Complex, 6>& load);
MotionTransfer motions_under_load(const LoadedHull& hull, double omega, EncounterAngle mu, double speed,
                                  const std::array<Complex, 6>& load, double roll_damping);

/// The same for one wave alone, all included: costs the field of that wave (about 20 us).
MotionTransfer motion_transfer(const LoadedHull& hull, double omega, EncounterAngle mu, double speed);

}  // namespace quickstrip
