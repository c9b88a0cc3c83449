// What can be watched on board, and what is computed ashore besides.
#pragma once

#include <cstdint>

namespace quickstrip {

enum class Quantity : std::uint8_t {
  kSurge,
  kSway,
  kHeave,
  kRoll,
  kPitch,
  kYaw,  // m or rad, of G
  kLongitudinalAcceleration,
  kLateralAcceleration,
  kVerticalAcceleration,  // m/s2, at point `place`
  kSlamming,              // at slamming station `place`
  kDeckWetness,           // at freeboard point `place`
  kPropellerEmergence,    // of the blade tip
  kMotionSickness,        // of people at point `place`; where a criterion asks (motion_sickness.hpp)
  kMotionInterruptions,   // of people who stand at point `place`, likewise (interruptions.hpp)
  // Not in the watch on board, nor on the wire (response/local_watch.hpp):
  kDisplacementX,
  kDisplacementY,
  kDisplacementZ,  // m, at a point
  kVelocityX,
  kVelocityY,
  kVelocityZ,         // m/s, at a point
  kRelativeMotion,    // m, vertical, at a station
  kRelativeVelocity,  // m/s
};

inline constexpr Quantity kLastWatched = Quantity::kMotionInterruptions;

/// Counted: the water passes a level.
constexpr bool is_event(Quantity quantity) {
  return quantity == Quantity::kSlamming || quantity == Quantity::kDeckWetness ||
         quantity == Quantity::kPropellerEmergence;
}

/// At a point of the hull file.
constexpr bool is_at_point(Quantity quantity) {
  return quantity == Quantity::kLongitudinalAcceleration || quantity == Quantity::kLateralAcceleration ||
         quantity == Quantity::kVerticalAcceleration || quantity == Quantity::kMotionSickness ||
         quantity == Quantity::kMotionInterruptions;
}

}  // namespace quickstrip
