#include "firmware/nmea/ship_state.hpp"

#include <algorithm>
#include <cmath>

#include "msgs/convert/field_checks.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip::nmea {
namespace {

constexpr double kNeverDisagrees = 1e9;

/// By how much two senders may differ [units of the quantity]. Ours: above what good sensors differ by, below
/// what would change the advice (a heading step of the grid is 5 degrees, a speed step 1 kn). Attitude is not
/// compared: sensors in two places differ by their lag.
double tolerance(Quantity quantity) {
  switch (quantity) {
    case Quantity::kHeading:
      return 3.0;
    case Quantity::kSpeedThroughWater:
    case Quantity::kSpeedOverGround:
      return 1.0;
    default:
      return kNeverDisagrees;
  }
}

double difference(Quantity quantity, double a, double b) {
  const double d = std::fabs(a - b);
  return quantity == Quantity::kHeading ? std::min(d, 360.0 - d) : d;
}

}  // namespace

bool ShipState::is_fresh(const Sender& sender, std::int64_t now) const {
  const double age = seconds_between(sender.newest.utime, now);
  return sender.is_used && age <= stale_after_s_ && age >= -stale_after_s_;  // ahead: a clock was set back
}

const ShipState::Sender* ShipState::believed(const Senders& senders, std::int64_t now) const {
  const Sender* best = nullptr;
  for (const Sender& sender : senders) {
    if (is_fresh(sender, now) && (best == nullptr || sender.rank < best->rank)) {
      best = &sender;
    }
  }
  return best;
}

ShipState::Sender& ShipState::slot(Senders& senders, Rank rank) {
  Sender* worst = &senders[0];
  for (Sender& sender : senders) {
    if (sender.is_used && sender.rank == rank) {
      return sender;
    }
    const bool is_worse = worst->is_used && (!sender.is_used || sender.rank > worst->rank);
    worst = is_worse ? &sender : worst;
  }
  return *worst;
}

bool ShipState::take(const Reading& reading, Rank rank, std::int64_t utime) {
  Senders& senders = senders_[static_cast<std::size_t>(reading.quantity)];
  const Sender* const best = believed(senders, utime);
  const bool is_second = best != nullptr && best->rank < rank;
  if (is_second &&
      difference(reading.quantity, best->newest.value, reading.value) > tolerance(reading.quantity)) {
    ++num_disagreements_;
  }
  slot(senders, rank) = {true, rank, {reading.value, utime}};
  return !is_second;
}

std::optional<ShipState::Value> ShipState::fresh(Quantity quantity, std::int64_t now) const {
  const Sender* const best = believed(senders_[static_cast<std::size_t>(quantity)], now);
  return best == nullptr ? std::nullopt : std::optional<Value>(best->newest);
}

std::optional<own_ship_t> ShipState::own_ship(std::int64_t now) const {
  using M = own_ship_t;
  own_ship_t message{};
  const auto put = [&](Quantity quantity, std::int32_t bit, double& field) {
    const std::optional<Value> value = fresh(quantity, now);
    if (value) {
      message.valid |= bit;
      field = value->value;
    }
    return value;
  };
  const auto heading = put(Quantity::kHeading, M::VALID_HEADING, message.heading_deg);
  const auto through_water =
      put(Quantity::kSpeedThroughWater, M::VALID_SPEED_THROUGH_WATER, message.speed_through_water_kn);
  const auto over_ground =
      put(Quantity::kSpeedOverGround, M::VALID_SPEED_OVER_GROUND, message.speed_over_ground_kn);
  const auto speed = through_water ? through_water : over_ground;
  if (!heading || !speed) {
    return {};
  }
  put(Quantity::kCourse, M::VALID_COURSE, message.course_over_ground_deg);
  put(Quantity::kRateOfTurn, M::VALID_RATE_OF_TURN, message.rate_of_turn_deg_min);
  put(Quantity::kDepth, M::VALID_DEPTH, message.depth_m);
  const auto lat = fresh(Quantity::kLatitude, now);
  const auto lon = fresh(Quantity::kLongitude, now);
  if (lat && lon) {
    message.valid |= M::VALID_POSITION;
    message.lat_deg = lat->value;
    message.lon_deg = lon->value;
  }
  message.stabiliser = M::STABILISER_NOT_KNOWN;
  message.utime = std::min(heading->utime, speed->utime);
  return message;
}

}  // namespace quickstrip::nmea
