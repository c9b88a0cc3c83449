// Angles in radians, and the three directions that must never be mixed up: types, not comments.
// Heading and WaveFrom are compass directions, clockwise from true north. EncounterAngle is the wave
// direction relative to the bow (NOTATION.md): 0 following, pi head, +pi/2 waves from starboard.
#pragma once

#include <cmath>

#include "core/base/constants.hpp"

namespace quickstrip {

/// Into (-pi, pi]. Finite input only.
inline double wrap_pi(double angle) {
  const double turned = std::remainder(angle, kTwoPi);
  return turned <= -kPi ? turned + kTwoPi : turned;
}

/// Into [0, 2 pi). Finite input only.
inline double wrap_two_pi(double angle) {
  const double turned = angle - kTwoPi * std::floor(angle / kTwoPi);
  return turned >= kTwoPi ? 0.0 : turned;
}

struct Heading {
  double radians = 0.0;
};
struct WaveFrom {
  double radians = 0.0;
};
struct EncounterAngle {
  double radians = 0.0;
};

/// mu = wrap(heading - from + pi), in (-pi, pi]. Contract §3; the opposite order flips port and starboard.
inline EncounterAngle encounter_angle(Heading heading, WaveFrom from) {
  return {wrap_pi(heading.radians - from.radians + kPi)};
}

inline constexpr double radians(double degrees) {
  return degrees * (kPi / 180.0);
}
inline constexpr double degrees(double radians_value) {
  return radians_value * (180.0 / kPi);
}

}  // namespace quickstrip
