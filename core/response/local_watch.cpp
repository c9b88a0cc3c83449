#include "core/response/local_watch.hpp"

#include <array>
#include <cmath>

namespace quickstrip {
namespace {

bool is_velocity(Quantity quantity) {
  return quantity == Quantity::kVelocityX || quantity == Quantity::kVelocityY ||
         quantity == Quantity::kVelocityZ || quantity == Quantity::kRelativeVelocity;
}

Channel channel_of(Quantity quantity, const Position& position, std::uint8_t place, double gravity) {
  return {.quantity = quantity,
          .place = place,
          .position = position,
          .form = linear_form(quantity, position, gravity),
          .is_rate = is_velocity(quantity)};
}

}  // namespace

Status begin_local_watch(const Watch& ship, Watch& out) {
  out.channels.clear();
  out.gravity = ship.gravity;
  out.swell_up = ship.swell_up;
  const std::size_t roll = find_channel(ship, Quantity::kRoll, 0);
  const bool fits = roll < ship.channels.size() && out.channels.push_back(ship.channels[roll]);
  return fits ? Status() : Status(Error::kOutOfRange);
}

Status add_local_motions(const Position& position, std::uint8_t place, bool with_accelerations,
                         double gravity, Watch& out) {
  constexpr std::array kMotions{Quantity::kDisplacementX, Quantity::kDisplacementY, Quantity::kDisplacementZ,
                                Quantity::kVelocityX,     Quantity::kVelocityY,     Quantity::kVelocityZ};
  constexpr std::array kAccelerations{Quantity::kLongitudinalAcceleration, Quantity::kLateralAcceleration,
                                      Quantity::kVerticalAcceleration};
  if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z)) {
    return Error::kNotFinite;
  }
  bool fits = true;
  for (const Quantity quantity : kMotions) {
    fits = out.channels.push_back(channel_of(quantity, position, place, gravity)) && fits;
  }
  for (std::size_t i = 0; with_accelerations && i < kAccelerations.size(); ++i) {
    fits = out.channels.push_back(channel_of(kAccelerations[i], position, place, gravity)) && fits;
  }
  return fits ? Status() : Status(Error::kTooMany);
}

Status add_relative_motion(const Channel& event, std::uint8_t place, double gravity, Watch& out) {
  if (!is_event(event.quantity)) {
    return Error::kOutOfRange;
  }
  bool fits = true;
  for (const Quantity quantity : {Quantity::kRelativeMotion, Quantity::kRelativeVelocity}) {
    Channel channel = channel_of(quantity, event.position, place, gravity);
    channel.dynamic_swell_up = event.dynamic_swell_up;
    fits = out.channels.push_back(channel) && fits;
  }
  return fits ? Status() : Status(Error::kTooMany);
}

}  // namespace quickstrip
