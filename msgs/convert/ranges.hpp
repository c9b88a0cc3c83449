// Physical ranges of what comes in, in the units of the rim: the same at sea (messages) and ashore (files).
#pragma once

#include <cmath>

#include "core/hull/hull.hpp"

namespace quickstrip {

/// Both ends included.
struct Range {
  double from = 0.0;
  double to = 0.0;
  /// False for NaN and infinities too.
  [[nodiscard]] constexpr bool holds(double value) const { return value >= from && value <= to; }
};

inline constexpr double kMaxWaveHeight_m = 30.0;  // the highest significant height measured is 20 m
inline constexpr Range kWavePeriod_s{1.0, 40.0};
inline constexpr Range kSpreading_deg{0.0,
                                      80.0};  // s = 2/sigma^2 - 1 is 0, no direction at all, at 81 degrees
inline constexpr Range kPeakedness{1.0, 10.0};
inline constexpr Range kWaveFrequency_hz{0.01, 2.0};

inline constexpr Range kSpeedThroughWater_kn{-10.0, 60.0};
inline constexpr Range kSpeedOverGround_kn{0.0, 60.0};
inline constexpr Range kGridSpeed_kn{0.0, 100.0};
inline constexpr Range kDraught_m{0.01, 40.0};
inline constexpr Range kRollPeriod_s{0.5, 80.0};
inline constexpr Range kWaterDensity_kg_m3{950.0, 1060.0};
inline constexpr Range kViscosity_m2_s{0.5e-6, 2.5e-6};
inline constexpr Range kGravity_m_s2{9.7, 9.9};

/// Of the longest reach of the stations, and of the trim: beyond, it is a misprint, and the theory has no
/// meaning (sections are cut vertically to the base line).
inline constexpr double kLeastSpan = 0.8;  // [lpp]
inline constexpr double kMaxTrim = 0.05;   // [lpp]

/// A hundredth of the breadth floats no ship, and a section ten times as wide as the widest tabulated.
inline Range draught_range_m(const Hull& hull) {
  return {std::fmax(kDraught_m.from, 0.01 * hull.breadth), kDraught_m.to};
}
inline bool is_trim(double draught_aft, double draught_fwd, const Hull& hull) {
  return std::fabs(draught_aft - draught_fwd) <= kMaxTrim * hull.lpp;
}
inline Range kg_range_m(const Hull& hull) {
  return {0.001, 2.0 * hull.breadth};
}
inline Range free_surface_range_m(const Hull& hull) {
  return {0.0, 0.5 * hull.breadth};
}
/// GM must be positive.
inline Range gm_range_m(const Hull& hull) {
  return {0.001, 2.0 * hull.breadth};
}
inline Range roll_gyradius_range_m(const Hull& hull) {
  return {0.15 * hull.breadth, 0.75 * hull.breadth};
}
inline Range long_gyradius_range_m(const Hull& hull) {
  return {0.1 * hull.lpp, 0.5 * hull.lpp};
}

/// Height of the highest offset above the base line [m]; negative for a hull of minimal form.
inline double highest_deck(const Hull& hull) {
  double z = -1.0;
  for (const Station& station : hull.stations) {
    if (!station.is_minimal()) {
      z = std::fmax(z, station.offsets.back().z);
    }
  }
  return z;
}

}  // namespace quickstrip
