// Motion transfer functions of the loaded hull at every speed, relative direction and wave frequency of the
// grid. Filled when the loading changes, read by every cycle. The port side is the mirror of the starboard
// side: sway, roll and yaw change sign with mu, surge, heave and pitch do not. Between the frequencies the
// roll peak is solved at points of its own (roll_peak.hpp).
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>

#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/motion_transfer.hpp"
#include "core/strip/roll_damping.hpp"
#include "core/strip/roll_peak.hpp"
#include "core/strip/roll_update.hpp"
#include "core/strip/wave_at_speeds.hpp"

namespace quickstrip {

/// Six complex amplitudes by wave frequency, at one speed and direction: structure of arrays, in single
/// precision (6e-8 of a value; energies are summed in double).
struct alignas(kCacheLine) MotionRow {
  using ByFrequency = std::array<float, kMaxFrequencies>;
  std::array<ByFrequency, 6> re{};
  std::array<ByFrequency, 6> im{};
};

/// Scratch of one direction at a time; its contents mean nothing between calls.
struct TransferWorkspace {
  std::array<SectionWaves, kMaxFrequencies> sections{};
  std::array<SectionDiffraction, kMaxFrequencies> diffraction{};
  std::array<std::array<LateralLoad, kMaxFrequencies>, kMaxSpeeds> load{};
  std::array<std::array<Encounter, kMaxFrequencies>, kMaxSpeeds> encounter{};
  ShipTerms ship;
  std::array<RollResonance, kMaxSpeeds> resonance{};
  std::array<SpeedTerms, kMaxSpeeds> terms{};
  std::array<std::array<LateralLoad, kMaxPeakPoints>, kMaxSpeeds> peak_load{};
  WaveWork wave;
  // Of contour points in waves of every frequency (WaveDecays): 600 points a wave, some 25 a section of 24.
  // Where frequencies are few, so is memory, and there is none.
  std::array<Pair, (kMaxFrequencies > 24 ? 300 * kMaxFrequencies : 0)> decay_room{};
  WaveDecays decays;
};

/// Added resistance per metre of wave amplitude squared [N/m2], + aft, by wave frequency.
using ResistanceRow = std::array<float, kMaxFrequencies>;
using ResistanceRows = std::array<ResistanceRow, kNumSolvedDirections>;

/// 4.1 MB at full capacity: static. row[v][m]: mu = pi m / (kNumSolvedDirections - 1), m = 0 following.
struct TransferFunctions {
  std::size_t num_speeds = 0;
  std::size_t num_frequencies = 0;
  double gravity = 0.0;
  std::array<double, kMaxSpeeds> speeds{};      // m/s
  std::array<double, kMaxFrequencies> omega{};  // wave frequency, increasing [rad/s]
  std::array<double, kMaxFrequencies> wave_number{};
  std::array<double, kMaxFrequencies> encounter_floor{};  // of |omega_e| [rad/s]
  std::array<std::array<MotionRow, kNumSolvedDirections>, kMaxSpeeds> row{};
  std::array<std::array<RollPeak, kNumSolvedDirections>, kMaxSpeeds> peak{};  // [v][m]
  RollDampingModel roll_damping;
  double critical_roll_damping = 0.0;                         // 2 c44 / omega_n [N m s]
  std::array<RollUpdate, kMaxSpeeds> roll_update;             // to motions at other roll dampings
  std::array<ResistanceRows, kMaxSpeeds> added_resistance{};  // strip/added_resistance.hpp, [v][m]
  // strip/empirical_added_resistance.hpp, of the speeds that have it: in its range, where there is room.
  std::array<ResistanceRows, kMaxEmpiricalSpeeds> empirical_resistance{};
  std::array<bool, kMaxSpeeds> has_empirical_resistance{};
};

/// mu of solved direction m [rad].
EncounterAngle solved_angle(std::size_t m);

/// Stores the six motions.
void store_motions(const std::array<Complex, 6>& motion, std::size_t f, MotionRow& row);

/// Fills the frequencies: kMaxFrequencies nodes whose range and density follow the hull's size.
void choose_frequencies(const LoadedHull& hull, TransferFunctions& out);

/// Solves the whole grid: speeds [m/s] >= 0, at most kMaxSpeeds. Errors: kTooMany, kSingular. Cost: 44,400
/// solutions of 24 sections at full capacity and up to 31,500 more at the peaks, see the benchmark.
Status solve_transfer_functions(const LoadedHull& hull, std::span<const double> speeds,
                                TransferWorkspace& work, TransferFunctions& out);

/// The same on wave frequencies of the caller's choice: 4 ... kMaxFrequencies (else kTooMany), increasing.
Status solve_transfer_functions(const LoadedHull& hull, std::span<const double> speeds,
                                std::span<const double> omega, TransferWorkspace& work,
                                TransferFunctions& out);

}  // namespace quickstrip
