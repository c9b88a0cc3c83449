// The watch: every response channel of the loaded hull. Six motions of G, three accelerations at each point,
// and the vertical relative motion at each slamming station, at each freeboard point and at the propeller.
// Channels of people follow where criteria ask for them (advice/people_channels.hpp).
//
// Built when the loading changes. A channel is a linear functional of the six motions and the incident wave;
// what it answers to waves is in channel_energy.hpp.
// Assumes: small trim: points keep their height above the base line, measured along the vertical.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/base/static_vector.hpp"
#include "core/hull/hull.hpp"
#include "core/hull/hydrostatics.hpp"
#include "core/response/point_motion.hpp"
#include "core/response/quantity.hpp"
#include "core/response/swell_up.hpp"

namespace quickstrip {

/// A channel as a linear functional of the six motions x_j and of the incident wave at its position: sum of
/// (displacement_j + omega_e^2 acceleration_j) x_j, plus `wave` times the elevation.
struct LinearForm {
  std::array<double, 6> displacement{};
  std::array<double, 6> acceleration{};
  double wave = 0.0;

  [[nodiscard]] constexpr bool has(std::size_t mode) const {
    return displacement[mode] != 0.0 || acceleration[mode] != 0.0;
  }
};

struct Channel {
  Quantity quantity = Quantity::kRoll;
  std::uint8_t place = 0;              // index into the hull's points, slamming stations or freeboard points
  PointRole role = PointRole::kOther;  // of the point, for accelerations
  Position position{};                 // relative to G; the origin for motions
  bool to_starboard = false;  // interruptions: the side people tip to; the channel of port stands before it
  // m, >= 0, at rest: draught of the slamming station, freeboard of the freeboard point, depth of the blade
  // tip. Interruptions: what people withstand [m/s2]
  double level = 0.0;
  double threshold_velocity = 0.0;  // m/s; slamming only
  LinearForm form{};
  bool is_rate = false;               // the velocity of what `form` says: |H|^2 times omega_e^2
  DynamicSwellUp dynamic_swell_up{};  // of relative motion
  StaticSwellUp static_swell_up{};    // of a freeboard
};

struct Watch {
  StaticVector<Channel, kMaxChannels> channels;
  double gravity = kStandardGravity;
  SwellUpModel swell_up;
};

/// Order: motions, accelerations (x, y, z) point by point, slamming stations, freeboard points, propeller.
/// Errors: kNotFinite; kOutOfRange for a slamming station off the hull or a freeboard that is not positive. A
/// propeller that is out of the water at rest has level 0: it always is.
Status list_channels(const Hull& hull, const Loading& loading, const Hydrostatics& hydrostatics,
                     SwellUp swell_up, Watch& out);

/// m2 is part of what the channel is watched for; else it is nobody's in the sweep.
bool needs_second_moment(const Channel& channel);

/// Of an event at the ship's speed: less than at rest by the bow wave, >= 0 [m].
double level_at(const Channel& channel, double speed);

/// The form of a channel of this quantity at this position; gravity > 0 [m/s2].
LinearForm linear_form(Quantity quantity, const Position& position, double gravity);

/// Index into channels, or channels.size() when there is no such channel.
std::size_t find_channel(const Watch& watch, Quantity quantity, std::uint8_t place);

}  // namespace quickstrip
