// Roll damping beyond potential theory, as the b44 that equations of motion take: a ratio of critical
// damping, or Ikeda's components.
//
// A model is condensed from the hull when the loading changes (load()) and then stands alone: small, without
// references, trivially copyable. What is exact in speed and frequency stays a formula (friction sqrt(omega)
// (1 + 4.1 V/(omega L)), eddies omega amplitude over speed, lift V, bilge keel's normal force
// omega (c0 + c1 amplitude)); the pressure of the keel on the hull, nonlinear in the amplitude, is a table.
// Damping that grows with the roll is given by equal energy: over a period of harmonic roll of an amplitude,
// or in the mean of a Gaussian roll of an RMS.
// Error of the table: below 0.3 % of the pressure (tests/strip/ikeda_damping_test.cpp). Cost of an
// evaluation: below 50 ns. No state.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/base/constants.hpp"

namespace quickstrip {

struct LoadedHull;

/// Where a model of roll damping is used outside the range that it was made for.
enum RollDampingRange : std::uint16_t {
  kOutsideBlockCoefficient = 1u << 0,
  kOutsideMidshipCoefficient = 1u << 1,
  kOutsideBreadthDraught = 1u << 2,
  kOutsideCentreOfGravity = 1u << 3,
  kOutsideKeelBreadth = 1u << 4,
  kOutsideKeelLength = 1u << 5,
  kOutsideSectionFullness = 1u << 6,  // sections over-full or re-entrant: brought into the range
  kOutsideFrequency = 1u << 7,
  kOutsideAmplitude = 1u << 8,
};

/// Amplitudes of the pressure table: 0 to kLast by kStep [rad]; of the Gaussian one the same as RMS / 2.
struct RollAmplitudeNodes {
  static constexpr std::size_t kCount = 33;
  static constexpr double kStep = 0.025;
  static constexpr double kLast = kStep * static_cast<double>(kCount - 1);
};

struct RollDampingModel {
  double constant = 0.0;           // of method "ratio" [N m s]
  double natural_frequency = 0.0;  // of undamped roll [rad/s]
  // Ikeda's components; all zero for method "ratio".
  double lpp = 1.0;              // m
  double frequency_scale = 0.0;  // sqrt(B/2g): makes omega-hat [s]
  double friction = 0.0;         // per sqrt(omega) at V = 0 [N m s^1.5]
  double eddy = 0.0;             // per omega and amplitude at V = 0 [N m s2]
  double lift = 0.0;             // per speed [N s2]
  double keel_normal_0 = 0.0;    // per omega [N m s2]
  double keel_normal_1 = 0.0;    // per omega and amplitude [N m s2]
  std::array<double, RollAmplitudeNodes::kCount> keel_pressure{};           // per omega [N m s2], of harmonic
  std::array<double, RollAmplitudeNodes::kCount> keel_pressure_gaussian{};  // and of Gaussian roll
  // Wave damping at speed after Ikeda, in place of strip theory's own.
  // By frequency, 0 to 4 natural frequencies: strip theory's b44 at V = 0, and what a metre a second adds to
  // it.
  double draught = 0.0;  // m
  double gravity = kStandardGravity;
  std::array<double, RollAmplitudeNodes::kCount> wave_still{};      // N m s
  std::array<double, RollAmplitudeNodes::kCount> wave_per_speed{};  // N s2
  std::uint16_t outside_range = 0;                                  // RollDampingRange, of the hull
};
static_assert(std::is_trivially_copyable_v<RollDampingModel> && sizeof(RollDampingModel) < 2048,
              "copied into the transfer functions");

/// b44 of each component [N m s].
struct RollDampingComponents {
  double constant = 0.0;
  double friction = 0.0;
  double eddy = 0.0;
  double lift = 0.0;
  double keel_normal = 0.0;
  double keel_pressure = 0.0;
  double wave = 0.0;  // beyond strip theory's own at this speed

  [[nodiscard]] double sum() const {
    return constant + friction + eddy + lift + keel_normal + keel_pressure + wave;
  }
};

/// Frequency between the nodes of the wave damping, over the natural one.
inline constexpr double kWaveNodeStep = 4.0 / static_cast<double>(RollAmplitudeNodes::kCount - 1);

/// Ikeda's wave damping at speed over that without, [ITTC2011]; omega > 0 [rad/s], V >= 0 [m/s].
double ikeda_wave_speed_factor(double omega, double speed, double draught, double gravity);

/// That take as much energy as the ship's do from harmonic roll of `amplitude` >= 0 [rad] at the roll
/// frequency omega > 0 [rad/s]; speed V >= 0 [m/s].
RollDampingComponents roll_damping_components(const RollDampingModel& model, double speed, double amplitude,
                                              double omega);

/// Their sum, b44 [N m s].
double added_roll_damping(const RollDampingModel& model, double speed, double amplitude, double omega);

/// The same in the mean of Gaussian roll of RMS `rms` >= 0 [rad] at omega: over the amplitudes of a Rayleigh
/// distribution, weighted with their energy. Damping that is quadratic in the rate then is
/// sqrt(8/pi) sigma_rate B2, stochastic linearisation's.
double added_roll_damping_gaussian(const RollDampingModel& model, double speed, double rms, double omega);

/// The limit for vanishing roll, at the natural frequency.
double small_roll_damping(const RollDampingModel& model, double speed);

/// Of roll of 3 degrees at the natural frequency: what transfer functions are solved with. A ship that rolls
/// less is of no interest, and at rest the limit for vanishing roll is so small (0.3 % of critical for the
/// S-175) that its resonance would need frequencies of its own.
double reference_roll_damping(const RollDampingModel& model, double speed);

/// False: small_roll_damping() is all there is, at any frequency.
bool depends_on_amplitude(const RollDampingModel& model);

/// RollDampingRange bits of the hull and of this roll.
std::uint16_t roll_damping_outside_range(const RollDampingModel& model, double amplitude, double omega);

/// b44 [N m s] whatever the roll, the frequency and the speed.
RollDampingModel constant_roll_damping(double b44, double natural_frequency);

/// omega_n [rad/s] of undamped roll: (I_xx + a44(omega_n)) omega_n^2 = c44. Fixed 40 bisections on
/// 0.02 ... 20 times the value without a44: |error| < 1e-10 of it.
double roll_natural_frequency(const LoadedHull& hull);

/// b44 [N m s] = 2 ratio c44 / omega_n, with the natural frequency already in `hull` (contract §2, method
/// "ratio").
double ratio_roll_damping(const LoadedHull& hull, double ratio);

}  // namespace quickstrip
