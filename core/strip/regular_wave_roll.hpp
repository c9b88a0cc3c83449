// Motions in a regular wave of a given amplitude, with the roll damping that her own roll in it calls for.
//
// Roll damping by equal energy of harmonic roll of that amplitude at the frequency of encounter; amplitude
// and damping answer each other. More damping makes D + i omega_e b of the roll impedance D
// (roll_admittance.hpp), so the roll amplitude falls with the damping, the damping grows with the amplitude,
// and between none and the roll at vanishing damping lies one solution: found by kSteps bisections, to
// 2^-kSteps of that roll, always. Then the equations of motion are solved with that damping, and what this
// roll differs from the one assumed is the residual.
// Below the encounter-frequency floor damping is taken at the floor, as the equations are.
// Range: |roll| up to 20 degrees; above it restoring is not linear either: flagged, not refused. Source:
// [Ikeda1978], [ITTC2011]. Cost: two solutions and kSteps evaluations, 9 us; no state.
#pragma once

#include <cstdint>

#include "core/base/angles.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/motion_transfer.hpp"
#include "core/strip/wave_loads.hpp"

namespace quickstrip {

struct RegularWaveRoll {
  MotionTransfer transfer;          // per metre of wave amplitude
  double amplitude = 0.0;           // of roll in this wave [rad]
  double damping = 0.0;             // added b44 [N m s]
  double residual = 0.0;            // |roll with this damping / roll that calls for it - 1|
  std::uint16_t outside_range = 0;  // RollDampingRange
};

/// Beyond it a roll is flagged [rad].
inline constexpr double kGreatestRegularRoll = radians(20.0);
/// A residual above it is "not converged".
inline constexpr double kRegularRollResidualLimit = 1e-6;

/// `wave_amplitude` > 0 [m]; `field` is the wave's; speed V >= 0 [m/s].
RegularWaveRoll regular_wave_roll(const LoadedHull& hull, const WaveField& field, double speed,
                                  double wave_amplitude);

/// The same for one wave, all included.
RegularWaveRoll regular_wave_roll(const LoadedHull& hull, double omega, EncounterAngle mu, double speed,
                                  double wave_amplitude);

}  // namespace quickstrip
