// The part of wave loads that is work: sums over the sections of coefficients a, b times what one wave does
// at each section. Coefficients at an encounter frequency are interpolated between nodes, which is linear in
// them, so the sums are taken at the nodes once for every speed that needs the node, and interpolated in
// place of the coefficients: the same numbers but for rounding, with a third of the work.
//
// Columns: complex numbers side by side for each section, so that a sum over sections runs down all of them
// at once. Velocity V (plain) and S (its weights against a slope of the coefficient), [0] force, [1] times x,
// as in WaveField. Loads: formulas in wave_loads.hpp. Radiated energy (added_resistance.hpp) is quadratic in
// the relative velocity w - (A + B x), so it needs the same sums of the wave's w, and of |w|^2.
// Cost: 0.3 us a node at 24 sections. No state.
#pragma once

#include <array>

#include "core/base/pair.hpp"
#include "core/strip/added_resistance.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/wave_loads.hpp"

namespace quickstrip {

/// Heave: S0 S1 Q V0 V1; Q: |w|^2 against the slope of a33 (first lane) and plain with b33 (second).
enum HeaveColumn : std::size_t { kHeaveS0, kHeaveS1, kHeaveQ, kHeaveV0, kHeaveV1, kHeaveColumns };
/// The same of velocities by the restrained section's own flow, where loads are by boundary values.
enum SolvedColumn : std::size_t { kSolvedS0, kSolvedS1, kSolvedV0, kSolvedV1, kSolvedColumns };
/// Sway, and velocities that make a roll moment by a lever (RV, RS).
enum SwayColumn : std::size_t { kSwayS1, kSwayS0, kSwayV0, kSwayV1, kRollV, kRollS, kSwayColumns };

/// One wave, arranged by section.
struct WaveColumns {
  double omega = 0.0;
  double heave_guard = 0.0;  // 0 in long waves: of the correction's speed term in pitch
  std::array<Pair, 6> froude_krilov{};
  std::array<Pair, 6> beam_correction{};
  std::array<std::array<Pair, kHeaveColumns>, kMaxStations> heave{};
  std::array<std::array<Pair, kSolvedColumns>, kMaxStations> solved{};
  std::array<std::array<Pair, kSwayColumns>, kMaxStations> sway{};
};

/// Sums of a coefficient times the columns; those that a method does not need stay unset.
struct WaveSums {
  std::array<Pair, kHeaveColumns> a33{};
  std::array<Pair, kHeaveColumns> b33{};
  std::array<Pair, kSolvedColumns> solved_a33{};
  std::array<Pair, kSolvedColumns> solved_b33{};
  std::array<Pair, kSwayColumns> a22{};
  std::array<Pair, kSwayColumns> b22{};
  std::array<Pair, kSwayColumns> a24{};  // S0 and V0
  std::array<Pair, kSwayColumns> b24{};
};

/// `wave`: where added resistance is wanted by these sums, else null.
void arrange(const LoadedHull& hull, const WaveField& field, const ResistanceWave* wave, WaveColumns& out);
/// Of a lateral field: sway alone.
void arrange_lateral(const LoadedHull& hull, const WaveField& field, WaveColumns& out);

/// Of the coefficients at one |omega_e|.
void sum_up(const LoadedHull& hull, const WaveColumns& columns, const SectionHydrodynamics& section,
            WaveSums& out);
void sum_up_lateral(const LoadedHull& hull, const WaveColumns& columns, const SectionHydrodynamics& section,
                    WaveSums& out);

/// out = sum of weight times what stands at three nodes.
struct WaveSumsStencil {
  std::array<const WaveSums*, 3> at{};
  std::array<double, 3> weight{};
};
void interpolate(const LoadedHull& hull, const WaveSumsStencil& stencil, WaveSums& out);
void interpolate_lateral(const LoadedHull& hull, const WaveSumsStencil& stencil, WaveSums& out);

/// Six loads [N, N m per m], times e^{i omega_e t}; omega_e signed, not zero; V [m/s].
std::array<Pair, 6> loads_of(const LoadedHull& hull, const WaveColumns& wave, const WaveSums& sums,
                             double omega_e, double speed);
/// Sway, roll and yaw, in places 1, 3, 5; the others zero.
std::array<Pair, 6> lateral_loads_of(const LoadedHull& hull, const WaveColumns& wave, const WaveSums& sums,
                                     double omega_e, double speed);

}  // namespace quickstrip
