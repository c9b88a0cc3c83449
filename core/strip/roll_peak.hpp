// The roll peak: lightly damped roll is a needle of relative width zeta that the common wave frequencies
// miss. Coefficients and loads are smooth, so they are interpolated and the equations of motion solved again
// at points between the frequencies, where |omega_e| meets roll resonance: up to three places in a following
// sea.
//
// Resonance is that of the coupled sway-roll-yaw equations at the speed, not of roll alone: the Schur
// complement D of the roll equation has Re D = 0 there, and half width at half power |Im D| / |dRe D/domega|.
// Points: Gauss-Legendre, three a panel, panels no wider than 1.5 (half width + distance from resonance) in
// |omega_e|, in the intervals where a straight line between the frequencies errs most. Loads between the
// frequencies: Lagrange through six where the wave turns little against the ship from one to the next, else
// section by section (lateral_loads_between.hpp); coefficients as everywhere.
// An interval with an end below the encounter-frequency floor is left alone: motions are flat there by rule.
// Expected error: tests/advice/roll_peak_test.cpp. Cost: one solution at each point, 0.6 us, or 3 us section
// by section; no state. Source: equations [Journee1992] §2; points and widths are ours.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/base/static_vector.hpp"
#include "core/strip/lateral_loads_between.hpp"
#include "core/strip/loaded_hull.hpp"
#include "core/strip/motion_transfer.hpp"

namespace quickstrip {

/// Where roll resounds at one speed, in |omega_e| [rad/s].
struct RollResonance {
  double omega = 0.0;
  double half_width = 0.0;  // > 0
};

/// Points first ... first + count - 1 lie between wave frequencies `node` and `node` + 1.
struct PeakInterval {
  std::uint8_t node = 0;
  std::uint8_t first = 0;
  std::uint8_t count = 0;
};

/// Sway, roll and yaw, which alone make the peak, in the order of kPeakModes.
inline constexpr std::array<std::size_t, 3> kPeakModes = {1, 3, 5};

/// Solutions between the wave frequencies at one speed and direction, in single precision: 6e-8 of a value.
/// An integral over an interval is the sum of weight times value over its points.
struct alignas(kCacheLine) RollPeak {
  StaticVector<PeakInterval, kMaxPeakIntervals> intervals;  // in increasing frequency
  std::size_t num_points = 0;
  std::array<float, kMaxPeakPoints> omega{};   // wave frequency [rad/s]
  std::array<float, kMaxPeakPoints> weight{};  // rad/s
  std::array<std::array<float, kMaxPeakPoints>, kPeakModes.size()> re{};
  std::array<std::array<float, kMaxPeakPoints>, kPeakModes.size()> im{};

  void clear() {
    intervals.clear();
    num_points = 0;
  }
};

/// At speed V >= 0 [m/s]. Without a change of sign within half and twice the uncoupled natural frequency:
/// that frequency, and its own damping.
RollResonance roll_resonance(const LoadedHull& hull, double speed);

/// One speed of a direction: encounters and loads at the wave frequencies.
struct PeakSpeed {
  SpeedTerms terms;
  RollResonance resonance;
  std::span<const Encounter> encounters;
  std::span<const LateralLoad> loads;
  std::span<LateralLoad> at_points;  // scratch
  RollPeak* out = nullptr;
};

/// All speeds of one direction, for points of several speeds lie at the same wave frequencies. `waves`: at
/// least four, increasing. False: a solution is not finite.
[[nodiscard]] bool solve_roll_peaks(const LoadedHull& hull, const ShipTerms& ship, EncounterAngle mu,
                                    const DirectionWaves& waves, std::span<const PeakSpeed> speeds,
                                    WaveWork& work);

}  // namespace quickstrip
