// One measured quantity out of a sentence, at the rim's units and the contract's signs (not the sensor's:
// each family of sentences turns its own).
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/static_vector.hpp"

namespace quickstrip::nmea {

enum class Quantity : std::uint8_t {
  kHeading = 0,        // true [deg], [0, 360)
  kSpeedThroughWater,  // forward positive [kn]
  kSpeedOverGround,    // [kn], 0 or more
  kCourse,             // over ground, true [deg], [0, 360)
  kRateOfTurn,         // to starboard positive [deg/min]
  kLatitude,           // north positive [deg]
  kLongitude,          // east positive [deg]
  kDepth,              // of the water, from the surface [m]
  kRoll,               // starboard down positive [deg]
  kPitch,              // bow down positive [deg]
  kHeave,              // up positive [m]
};
inline constexpr std::size_t kNumQuantities = 11;

struct Reading {
  Quantity quantity = Quantity::kHeading;
  double value = 0.0;
};

/// One sentence gives four at most (PASHR); XDR has as many as fit into a line.
using Readings = StaticVector<Reading, 8>;

}  // namespace quickstrip::nmea
