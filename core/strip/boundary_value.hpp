// Diffraction by boundary values: what each section's own flow makes of a wave when it is held, from a
// compiled hull table, as equivalent motions of the water, v_2 = omega sin mu (sway), v_3 = i omega (heave)
// per metre of wave amplitude, times e^{-i k x cos mu}:
//   X_3 = (i omega a33 + b33) heave v_3,  X_2 = (i omega a22 + b22) sway v_2,
//   X_4 = {(i omega a24 + b24) sway + (i omega a22 + b22) lever} v_2 (about O).
// At V = 0 these are the solved loads exactly, in every direction [STF1970]. At speed a and
// b are those at the frequency of encounter, the equivalent motions those of the wave's own: what that leaves
// out is measured against the parent program (tests/parent). Cost: about 1.5 us a section and direction and
// 0.1 us a frequency.
#pragma once

#include <span>

#include "core/base/angles.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/wave_loads.hpp"

namespace quickstrip {

/// At wave frequencies omega [rad/s] > 0, of one direction. The hull has a table (kBoundaryValue after
/// load()).
void boundary_value_motions(const LoadedHull& hull, std::span<const double> omega, EncounterAngle mu,
                            std::span<SectionDiffraction> out);

}  // namespace quickstrip
