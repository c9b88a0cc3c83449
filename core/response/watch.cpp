#include "core/response/watch.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/response/relative_motion.hpp"
#include "core/response/slamming.hpp"

namespace quickstrip {
namespace {

/// Of the lowest point of a station above the base line [m].
double keel_height(const Hull& hull, const Loading& loading, const Station& station) {
  return station.is_minimal() ? waterline_height(hull, loading, station.x) - station.draught
                              : station.offsets.front().z;
}

/// Linear between stations. Stations in increasing x.
Result<double> keel_height_at(const Hull& hull, const Loading& loading, double x) {
  for (std::size_t i = 0; i + 1 < hull.stations.size(); ++i) {
    const Station& aft = hull.stations[i];
    const Station& fore = hull.stations[i + 1];
    if (x >= aft.x && x <= fore.x) {
      const double part = (x - aft.x) / (fore.x - aft.x);
      return (1.0 - part) * keel_height(hull, loading, aft) + part * keel_height(hull, loading, fore);
    }
  }
  return Error::kOutOfRange;
}

void list_points(const Hull& hull, const Position& g, Watch& out) {
  for (std::size_t i = 0; i < hull.points.size(); ++i) {
    const PointOfInterest& point = hull.points[i];
    for (const Quantity quantity : {Quantity::kLongitudinalAcceleration, Quantity::kLateralAcceleration,
                                    Quantity::kVerticalAcceleration}) {
      QS_CHECK(out.channels.push_back({.quantity = quantity,
                                       .place = static_cast<std::uint8_t>(i),
                                       .role = point.role,
                                       .position = {point.x - g.x, point.y, point.z - g.z}}));
    }
  }
}

Status list_slamming(const Hull& hull, const Loading& loading, const Position& g, Watch& out) {
  for (std::size_t i = 0; i < hull.slamming.size(); ++i) {
    const SlammingStation& station = hull.slamming[i];
    const Result<double> keel = keel_height_at(hull, loading, station.x);
    if (!keel) {
      return keel.error();
    }
    const double velocity =
        station.threshold_velocity.value_or(ochi_threshold_velocity(hull.lpp, loading.gravity));
    const double draught = waterline_height(hull, loading, station.x) - *keel;
    if (!(velocity >= 0.0) || !std::isfinite(velocity) || !std::isfinite(draught)) {
      return Error::kNotFinite;
    }
    QS_CHECK(out.channels.push_back({.quantity = Quantity::kSlamming,
                                     .place = static_cast<std::uint8_t>(i),
                                     .position = {station.x - g.x, 0.0, *keel - g.z},
                                     .level = std::max(draught, 0.0),
                                     .threshold_velocity = velocity,
                                     .dynamic_swell_up = dynamic_swell_up(out.swell_up, station.x)}));
  }
  return {};
}

Status list_freeboard(const Hull& hull, const Loading& loading, const Position& g, Watch& out) {
  for (std::size_t i = 0; i < hull.freeboard.size(); ++i) {
    const FreeboardPoint& point = hull.freeboard[i];
    const double freeboard = point.height - waterline_height(hull, loading, point.x);
    if (!(freeboard > 0.0) || !std::isfinite(freeboard)) {
      return Error::kOutOfRange;
    }
    QS_CHECK(out.channels.push_back({.quantity = Quantity::kDeckWetness,
                                     .place = static_cast<std::uint8_t>(i),
                                     .position = {point.x - g.x, 0.0, point.height - g.z},
                                     .level = freeboard,
                                     .dynamic_swell_up = dynamic_swell_up(out.swell_up, point.x),
                                     .static_swell_up = static_swell_up(out.swell_up, point.x)}));
  }
  return {};
}

Status list_propeller(const Hull& hull, const Loading& loading, const Position& g, Watch& out) {
  if (!hull.propeller) {
    return {};
  }
  const double x = hull.propeller->x;
  const double depth = waterline_height(hull, loading, x) - hull.propeller->tip_z;
  if (!std::isfinite(depth)) {
    return Error::kNotFinite;
  }
  QS_CHECK(out.channels.push_back({.quantity = Quantity::kPropellerEmergence,
                                   .position = {x - g.x, 0.0, hull.propeller->tip_z - g.z},
                                   .level = std::max(depth, 0.0),
                                   .dynamic_swell_up = dynamic_swell_up(out.swell_up, x)}));
  return {};
}

bool all_finite(const Watch& watch) {
  return std::isfinite(watch.gravity) &&
         std::all_of(watch.channels.begin(), watch.channels.end(), [](const Channel& channel) {
           return std::isfinite(channel.position.x) && std::isfinite(channel.position.y) &&
                  std::isfinite(channel.position.z);
         });
}

bool is_relative_motion(Quantity quantity) {
  return is_event(quantity) || quantity == Quantity::kRelativeMotion ||
         quantity == Quantity::kRelativeVelocity;
}

// What is meant when only these motions are there: no incident wave.
double response_to_motions(Quantity quantity, const Position& position, const MotionTransfer& motions,
                           double gravity) {
  if (quantity <= Quantity::kYaw) {
    return motions.motion[static_cast<std::size_t>(quantity)].real();
  }
  if (is_relative_motion(quantity)) {
    constexpr double kWaveNumber = 0.0;  // of any wave: it goes out again
    const EncounterAngle mu{0.0};
    return (relative_motion(motions, position, kWaveNumber, mu) - incident_wave(position, kWaveNumber, mu))
        .real();
  }
  const PointMotion displacement = point_displacement(motions, position);
  const PointMotion acceleration = point_acceleration(motions, position, gravity);
  switch (quantity) {
    case Quantity::kLongitudinalAcceleration:
      return acceleration.x.real();
    case Quantity::kLateralAcceleration:
      return acceleration.y.real();
    case Quantity::kVerticalAcceleration:
      return acceleration.z.real();
    case Quantity::kDisplacementX:
    case Quantity::kVelocityX:
      return displacement.x.real();
    case Quantity::kDisplacementY:
    case Quantity::kVelocityY:
      return displacement.y.real();
    default:
      return displacement.z.real();
  }
}

}  // namespace

// Everything is linear: one motion at a time, at omega_e of 0 and of 1 rad/s.
LinearForm linear_form(Quantity quantity, const Position& position, double gravity) {
  LinearForm form{.wave = is_relative_motion(quantity) ? 1.0 : 0.0};
  for (std::size_t j = 0; j < form.displacement.size(); ++j) {
    MotionTransfer one;
    one.motion[j] = 1.0;
    form.displacement[j] = response_to_motions(quantity, position, one, gravity);
    one.encounter_frequency = 1.0;
    form.acceleration[j] = response_to_motions(quantity, position, one, gravity) - form.displacement[j];
  }
  return form;
}

bool needs_second_moment(const Channel& channel) {
  return channel.form.wave > 0.0 || channel.quantity == Quantity::kMotionSickness ||
         channel.quantity == Quantity::kMotionInterruptions;
}

double level_at(const Channel& channel, double speed) {
  return std::max(channel.level - channel.static_swell_up.rise(speed), 0.0);
}

Status list_channels(const Hull& hull, const Loading& loading, const Hydrostatics& hydrostatics,
                     SwellUp swell_up, Watch& out) {
  out.channels.clear();
  out.gravity = loading.gravity;
  if (!(hull.lpp > 0.0) || !(loading.gravity > 0.0)) {
    return Error::kOutOfRange;
  }
  const Result<SwellUpModel> model = swell_up_model(swell_up, hull, loading, hydrostatics);
  if (!model) {
    return model.error();
  }
  out.swell_up = *model;
  // G lies above the centre of buoyancy in x (it floats at these draughts) and at the solid KG (contract §2).
  const Position g{hydrostatics.lcb, 0.0, hydrostatics.kg};
  for (const Quantity motion : {Quantity::kSurge, Quantity::kSway, Quantity::kHeave, Quantity::kRoll,
                                Quantity::kPitch, Quantity::kYaw}) {
    QS_CHECK(out.channels.push_back({.quantity = motion}));
  }
  list_points(hull, g, out);
  if (const Status status = list_slamming(hull, loading, g, out); !status) {
    return status;
  }
  if (const Status status = list_freeboard(hull, loading, g, out); !status) {
    return status;
  }
  if (const Status status = list_propeller(hull, loading, g, out); !status) {
    return status;
  }
  for (Channel& channel : out.channels) {
    channel.form = linear_form(channel.quantity, channel.position, loading.gravity);
  }
  return all_finite(out) ? Status() : Status(Error::kNotFinite);
}

std::size_t find_channel(const Watch& watch, Quantity quantity, std::uint8_t place) {
  const auto* const found = std::find_if(
      watch.channels.begin(), watch.channels.end(),
      [&](const Channel& channel) { return channel.quantity == quantity && channel.place == place; });
  return static_cast<std::size_t>(found - watch.channels.begin());
}

}  // namespace quickstrip
