// Sway, roll and yaw loads between the wave frequencies of one direction, section by section.
//
// The load on the whole ship turns with the wave from bow to stern and is no smooth function of frequency
// once the ship is longer than the wave; what each section takes of it, without the phase of her place, is.
// That is interpolated, a cubic through four frequencies, and the loads are summed up again with exact
// phases. Expected error: below 0.1 % of the largest load for waves down to L/8
// (tests/advice/roll_peak_test.cpp, by way of the motions). Cost: about three ordinary loads, 3 us at 24
// sections. No state.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>

#include "core/base/angles.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/wave_at_speeds.hpp"

namespace quickstrip {

/// At the wave frequencies of one direction, all of one length; none of `diffraction`: loads by equivalent
/// motions alone.
struct DirectionWaves {
  std::span<const double> omega;
  std::span<const SectionWaves> sections;
  std::span<const SectionDiffraction> diffraction;
};

/// How far the wave at the ends of the ship turns against midships from one frequency to the next [rad].
double turn_between(const LoadedHull& hull, EncounterAngle mu, double omega, double next_omega);

/// The wave of omega between frequency `interval` and the next, worked out for any speed.
void set_lateral_wave_between(const LoadedHull& hull, const DirectionWaves& waves, EncounterAngle mu,
                              std::size_t interval, double omega, WaveWork& work);

/// Of that wave; omega_e signed, not zero, above the floor.
LateralLoad lateral_load(const LoadedHull& hull, double omega_e, double speed, WaveWork& work);

}  // namespace quickstrip
