// What can be watched on board.
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
};

}  // namespace quickstrip
