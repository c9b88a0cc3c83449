// Local motions ashore: displacements and velocities of a point along x, y and z, and vertical relative
// motion and velocity where water is watched. A watch of their own, filled piece by piece: on board the same
// channels would cost the cycle memory and time and tell the bridge nothing.
//
// The first channel of a local watch is roll: the damping of the lateral motions follows from it
// (moments.hpp). A velocity's |H|^2 is omega_e^2 times the displacement's: its variance is the displacement's
// m2, its zero-crossing period 2 pi sqrt(m2/m4).
#pragma once

#include <cstdint>

#include "core/base/result.hpp"
#include "core/response/watch.hpp"

namespace quickstrip {

/// A local watch of the same ship, with roll alone.
Status begin_local_watch(const Watch& ship, Watch& out);

/// Appends displacement and velocity, and acceleration if asked. position: relative to G; gravity > 0 [m/s2].
/// Errors: kTooMany, kNotFinite.
Status add_local_motions(const Position& position, std::uint8_t place, bool with_accelerations,
                         double gravity, Watch& out);

/// Appends relative motion and relative velocity of an event's channel, with its swell-up; `place` as there.
/// Errors: kTooMany; kOutOfRange for a channel without relative motion.
Status add_relative_motion(const Channel& event, std::uint8_t place, double gravity, Watch& out);

}  // namespace quickstrip
