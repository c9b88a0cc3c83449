// The watch: every response channel of the loaded hull. Six motions of G, three accelerations at each point,
// and the vertical relative motion at each slamming station and freeboard point.
//
// Built when the loading changes. A channel is a linear functional of the six motions and the incident wave:
// its energy |H|^2 per metre^2 times the wave energy, summed, is the variance.
// Assumes: small trim: points keep their height above the base line, measured along the vertical.
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/base/static_vector.hpp"
#include "core/hull/hull.hpp"
#include "core/hull/hydrostatics.hpp"
#include "core/response/point_motion.hpp"
#include "core/response/quantity.hpp"
#include "core/strip/motion_transfer.hpp"

namespace quickstrip {

struct Channel {
  Quantity quantity = Quantity::kRoll;
  std::uint8_t place = 0;              // index into the hull's points, slamming stations or freeboard points
  PointRole role = PointRole::kOther;  // of the point, for accelerations
  Position position{};                 // relative to G; the origin for motions
  double level = 0.0;  // m: draught of the slamming station, freeboard of the freeboard point; >= 0
  double threshold_velocity = 0.0;  // m/s; slamming only
};

struct Watch {
  StaticVector<Channel, kMaxChannels> channels;
  double gravity = kStandardGravity;
};

/// Order: motions, accelerations (x, y, z) point by point, slamming stations, freeboard points.
/// Errors: kNotFinite; kOutOfRange for a slamming station off the hull or a freeboard that is not positive.
Status list_channels(const Hull& hull, const Loading& loading, const Hydrostatics& hydrostatics, Watch& out);

/// Index into channels, or channels.size() when there is no such channel.
std::size_t find_channel(const Watch& watch, Quantity quantity, std::uint8_t place);

/// Per metre of wave amplitude: m, rad, m/s2. mu of the wave that `transfer` answers.
std::complex<double> channel_response(const Channel& channel, const MotionTransfer& transfer,
                                      double wave_number, EncounterAngle mu, double gravity);

/// |H|^2 at each frequency of one direction. transfers, wave_numbers and out of one length.
void channel_energies(const Channel& channel, std::span<const MotionTransfer> transfers,
                      std::span<const double> wave_numbers, EncounterAngle mu, double gravity,
                      std::span<double> out);

}  // namespace quickstrip
