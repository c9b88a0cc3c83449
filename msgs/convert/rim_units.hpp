// The unit in which a quantity's statistic leaves the ship's core, and its value there.
#pragma once

#include <cstdint>

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "core/base/angles.hpp"

namespace quickstrip {

/// As limits_t's UNIT_...; the first three as response_t's.
enum class RimUnit : std::uint8_t {
  kMetre = 0,
  kDegree = 1,
  kMetrePerSecondSquared = 2,
  kProbability = 3,
  kPerHour = 4,
  kShareOfPeople = 5,
  kPerMinute = 6
};

/// Of rms and significant. Events: of the relative motion, metres. Motion sickness: of the vertical
/// acceleration; interruptions: of what tips.
constexpr RimUnit rim_unit(Quantity quantity) {
  switch (quantity) {
    case Quantity::kRoll:
    case Quantity::kPitch:
    case Quantity::kYaw:
      return RimUnit::kDegree;
    case Quantity::kLongitudinalAcceleration:
    case Quantity::kLateralAcceleration:
    case Quantity::kVerticalAcceleration:
    case Quantity::kMotionSickness:
    case Quantity::kMotionInterruptions:
      return RimUnit::kMetrePerSecondSquared;
    default:
      return RimUnit::kMetre;
  }
}

constexpr RimUnit rim_unit(Quantity quantity, Statistic statistic) {
  switch (statistic) {
    case Statistic::kProbability:
      return RimUnit::kProbability;
    case Statistic::kPerHour:
      return RimUnit::kPerHour;
    case Statistic::kShareOfPeople:
      return RimUnit::kShareOfPeople;
    case Statistic::kPerMinute:
      return RimUnit::kPerMinute;
    default:
      return rim_unit(quantity);
  }
}

/// Of a value >= 0 in core's unit. Negative or NaN (not computed): kNotComputed.
constexpr double to_rim(double value, RimUnit unit) {
  if (!(value >= 0.0)) {
    return static_cast<double>(kNotComputed);
  }
  return unit == RimUnit::kDegree ? degrees(value) : value;
}

}  // namespace quickstrip
