// Swell-up: what the ship's own waves add to the water at her side, where the undisturbed wave alone is the
// unsafe side. Named option SwellUp::kOnboard; [Journee1992] §3 names both and leaves them out (kOff).
//
// Dynamic (waves of the oscillating ship), [Tasaki1963]: relative motion is greater by the factor
//   1 + (CB - 0.45)/3 sqrt(omega_e^2 L/g)   on the entrance of the waterline, for
//   0.60 <= CB <= 0.80, 0.16 <= Fn <= 0.29, 1.60 <= omega_e^2 L/g <= 2.60.
// Everywhere else (another form, speed, frequency or place) it is the factor 1.15, of our choosing: the
// formula gives 1.06 to 1.19 within its range. The factor applies to s, and so to the relative velocity.
// Static (bow wave of the ship under way), [Tasaki1963]: the water at the forward perpendicular stands higher
// by 0.75 B (L/L_E) Fn^2 = 0.75 (B/L_E) V^2/g; here never by more than the stagnation height V^2/2g, which no
// free surface in steady flow exceeds (Bernoulli). Aft of the perpendicular it is taken to fall as the ship's
// own transverse wave, cos(g d/V^2), to zero a quarter of that wave's length aft: ours. It lowers freeboards
// only: at a slamming station it would deepen the bow, at the propeller the wave is the stern's: no credit.
// L_E: from the fore end of the waterline to where its half-breadth first reaches the greatest.
// Error: not known; both formulas are quoted at second hand (by the lecture notes that quote [Tasaki1963])
// and checked for dimension, size and limits only. Cost: a square root at set-up, two comparisons and a
// product a frequency.
#pragma once

#include <cmath>

#include "core/base/result.hpp"
#include "core/hull/hull.hpp"
#include "core/hull/hydrostatics.hpp"
#include "core/strip/method.hpp"

namespace quickstrip {

inline constexpr double kSwellUpFactor = 1.15;

struct Interval {
  double from = 1.0;
  double to = 0.0;  // empty
  [[nodiscard]] bool holds(double value) const { return value >= from && value <= to; }
};

/// The factor on relative motion at one place; by default 1 everywhere.
struct DynamicSwellUp {
  Interval speeds{};          // m/s; empty: outside the range of the formula at any speed
  Interval frequencies{};     // of |omega_e| [rad/s]
  double by_frequency = 0.0;  // s: the factor within is 1 + by_frequency |omega_e|
  double elsewhere = 1.0;

  [[nodiscard]] double factor(double speed, double omega_e) const {
    const double frequency = std::fabs(omega_e);
    return speeds.holds(speed) && frequencies.holds(frequency) ? 1.0 + by_frequency * frequency : elsewhere;
  }
};

/// How much higher the water stands at one place for the ship's speed; by default nothing.
struct StaticSwellUp {
  double by_speed_squared = 0.0;  // of V^2, at the forward perpendicular [s2/m]
  double gravity_distance = 0.0;  // g d, d aft of the forward perpendicular, >= 0 [m2/s2]

  /// m, >= 0; speed [m/s].
  [[nodiscard]] double rise(double speed) const;
};

/// Of the hull at her draughts.
struct SwellUpModel {
  SwellUp rule = SwellUp::kOff;
  double fore_end = 0.0;         // of the waterline, from the aft perpendicular [m]
  double entrance_length = 0.0;  // L_E [m]
  DynamicSwellUp at_entrance;
  StaticSwellUp at_fore_perpendicular;
  double lpp = 0.0;
  double gravity = kStandardGravity;

  /// Whether formulas, not the factor alone, speak at this speed; true when off: nothing is claimed then.
  [[nodiscard]] bool is_in_range(double speed) const;
};

/// Half the breadth at a height z above the base line, of a station as given; 0 below its keel and above its
/// deck [m].
double half_breadth_at(const Station& station, double z);

/// Errors: kOutOfRange (no waterline, no length), kNotFinite.
Result<SwellUpModel> swell_up_model(SwellUp rule, const Hull& hull, const Loading& loading,
                                    const Hydrostatics& hydrostatics);

/// On the centre line at x from the aft perpendicular [m].
DynamicSwellUp dynamic_swell_up(const SwellUpModel& model, double x);
StaticSwellUp static_swell_up(const SwellUpModel& model, double x);

}  // namespace quickstrip
