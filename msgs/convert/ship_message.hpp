// QS_OWN_SHIP and QS_LOADING against core's heading, speed and Loading. No heap.
#pragma once

#include <cstdint>
#include <optional>

#include "core/advice/step.hpp"
#include "core/hull/hull.hpp"
#include "msgs/convert/refusal.hpp"
#include "quickstrip/loading_t.hpp"
#include "quickstrip/own_ship_t.hpp"

namespace quickstrip {

/// As advice_t's SPEED_...
enum class SpeedKind : std::uint8_t { kNotKnown = 0, kThroughWater = 1, kOverGround = 2 };

/// SI. Speed through the water; over ground only where that is not known, and then the advice says so
/// (kQualitySpeedOverGround).
struct OwnShipReading {
  OwnShip ship;                        // what the advisor takes
  std::optional<double> course;        // over ground, compass [rad]
  std::optional<double> rate_of_turn;  // to starboard positive [rad/s]
};

constexpr SpeedKind speed_kind(const OwnShip& ship) {
  return ship.speed_over_ground ? SpeedKind::kOverGround : SpeedKind::kThroughWater;
}

/// Required: heading, and one of the two speeds. On refusal `out` is as it was.
Conversion to_own_ship(const own_ship_t& message, OwnShipReading& out);

/// The hull's default loading with the fields that the message gives. A new draught or KG takes away a
/// default GM and measured roll period, and a new KG a default free-surface correction, for they belonged to
/// the old condition. Required: one field at least. On refusal `out` is as it was.
Conversion to_loading(const loading_t& message, const Hull& hull, Loading& out);

/// The way back, for the simulator and manual entry: all that is known; utime, seq, source are the caller's.
void to_message(const Loading& loading, loading_t& out);

}  // namespace quickstrip
