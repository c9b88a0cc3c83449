// Added resistance in regular waves: the mean longitudinal force that a wave adds, from the ship's heave and
// pitch. Per metre of wave amplitude squared [N/m2], + aft.
//
// Head to beam waves (mu > 90 degrees): the energy that the ship radiates [GerritsmaBeukelman1972],
//   R = -k cos mu / (2 omega_e) integral of (b33' - V da33'/dx) |V_z|^2 dx,
//   V_z = equivalent orbital velocity of the wave (wave frequency) - (z' - x theta' + V theta);
// it is P = R lambda / |cos mu| a period. Beam to following waves (mu < 90): the pressure of the relative
// motion at the waterline, and the vertical force turning with pitch [Boese1970],
//   R = -1/2 rho g integral of s_a^2 dy_w/dx dx (two sides) + 1/2 m omega_e^2 Re(z theta*).
// [Journee1992] §3 uses them so. The first does not hold behind the beam at speed, where omega_e goes through
// zero below it. At 90 degrees itself the first is zero by its factor and the second is not: there the value
// is the mean of both, what a trapezoidal sum over directions wants of a jump. Its size: tests/strip.
//
// Which power. The published b33' - V da33'/dx is the factor of the velocity in the ordinary strip force
// d/dt{a v} + b v. The mean work of the whole force is another, for a v is swept along the ship as well
// (v: complex amplitude of V_z; the hull's ends closed, or their jumps included):
//   ordinary  1/2 integral of b |v|^2 - V Re(v* (a v)_x)  =  1/2 integral of (b - 1/2 V a_x) |v|^2,
//   modified  1/2 integral of b |v|^2 - V Re(v* ((a - i b / omega_e) v)_x)
//             =  1/2 integral of (b - 1/2 V a_x) |v|^2 - (V / omega_e) b Im(v* v_x),
// the last term making b omega / omega_e of b on a ship at rest in head waves, as in the modified wave loads.
// The ordinary method keeps the published power, which is Gerritsma and Beukelman's; the modified method,
// for which they give none, takes the work of its own force. Figures of both for both: tests/strip.
//
// Slopes along the length are summed as in the coefficients: by parts over the stations, with the tapers and,
// where the method has end terms, the jumps at the ends.
// Assumptions: those of the motions; the error is that of the motions twice. Missing: diffraction of short
// waves by the bow (empirical_added_resistance.hpp), roll, sway, yaw and surge, both sides' own elevation.
// At zero speed the radiated energy is far too much in short waves: on the S-175 it peaks with 4.6 rho g B^2
// / L at lambda/L 0.47, where the semi-empirical method has no more than 1.3. Limits: 0 in long waves;
// radiated energy 0 as mu -> 90 from ahead; Boese 0 in short waves for a waterline that closes. Expected
// error: peak of the S-175 in head waves at 20 kn 7 ... 9 % below another program's; of the Wigley hulls 0.4
// to 2.9 times the measured (tests/strip). Cost: some 0.2 us, and the wave once for all speeds. Re-entrant.
// For mu >= 90 omega_e >= omega > 0; behind the beam nothing is divided by omega_e.
#pragma once

#include <complex>
#include <cstdint>

#include "core/base/angles.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/motion_transfer.hpp"
#include "core/strip/wave_loads.hpp"

namespace quickstrip {

/// What added resistance needs of a wave of 1 m amplitude, whatever the speed.
struct ResistanceWave {
  double omega = 0.0;
  EncounterAngle mu;
  AlongHull elevation;  // on the centre line [m/m]
  AlongHull velocity;   // equivalent vertical orbital velocity [m/s/m]
};

enum class RadiatedPower : std::uint8_t {
  kPublished,  // b33' - V da33'/dx
  kStripWork,  // mean work of the method's own strip force
};

/// Of the method: see above.
RadiatedPower radiated_power_of(StripVariant variant);

/// omega > 0 [rad/s].
void resistance_wave(const LoadedHull& hull, double omega, EncounterAngle mu, const SectionWaves& sections,
                     ResistanceWave& out);

/// By either method according to mu; `motion`: of this wave at this speed V >= 0 [m/s].
double added_resistance(const LoadedHull& hull, const ResistanceWave& wave, const MotionTransfer& motion,
                        double speed);

/// From ahead of the beam.
double radiated_energy_resistance(const LoadedHull& hull, const ResistanceWave& wave,
                                  const MotionTransfer& motion, double speed, RadiatedPower power);

double integrated_pressure_resistance(const LoadedHull& hull, const ResistanceWave& wave,
                                      const MotionTransfer& motion);
/// The same, with the integral of dy_w/dx |s|^2 over the length given, s the relative elevation.
double integrated_pressure_resistance(const LoadedHull& hull, double slope_times_square,
                                      const MotionTransfer& motion);

/// |cos mu| of 90 degrees comes out as 6e-17.
inline constexpr double kCosineOfBeam = 1e-12;

/// For one wave alone, its sections included (some 20 us); `motion` as above.
double added_resistance(const LoadedHull& hull, double omega, EncounterAngle mu, double speed,
                        const MotionTransfer& motion);

}  // namespace quickstrip
