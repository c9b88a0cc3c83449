#include "core/response/direction_response.hpp"

#include <cmath>

namespace quickstrip {
namespace {

// One loop a moment: a choice within would keep the compiler from making vectors of it.
template <std::size_t N>
void weigh(Moment moment, const std::array<double, N>& omega_e, std::size_t n,
           const std::array<double, N>& values, std::array<double, N>& out) {
  switch (moment) {
    case Moment::kZeroth:
    case Moment::kLowEncounter:
      return;
    case Moment::kFirst:
      for (std::size_t i = 0; i < n; ++i) {
        out[i] = values[i] * std::fabs(omega_e[i]);
      }
      return;
    case Moment::kSecond:
      for (std::size_t i = 0; i < n; ++i) {
        out[i] = values[i] * (omega_e[i] * omega_e[i]);
      }
      return;
    case Moment::kFourth:
      for (std::size_t i = 0; i < n; ++i) {
        out[i] = values[i] * ((omega_e[i] * omega_e[i]) * (omega_e[i] * omega_e[i]));
      }
      return;
  }
}

}  // namespace

void list_values(const MetWaves& met, bool is_from_port, const Channel& channel, const LateralMotions* damped,
                 const IncidentWave& wave, ChannelValues& out) {
  ChannelPart longitudinal;
  longitudinal_part(met, channel, {wave}, longitudinal);
  if (!feels_roll(channel)) {
    list_square(met, channel, longitudinal, out);
    return;
  }
  ChannelPart lateral;
  lateral_part(met, channel, damped, lateral);
  ChannelValues odd;
  list_even_odd(met, channel, longitudinal, lateral, out, odd);
  const double side = is_from_port ? -1.0 : 1.0;
  for (std::size_t f = 0; f < met.transfer.num_frequencies; ++f) {
    out.nodes[f] += side * odd.nodes[f];
  }
  for (std::size_t p = 0; p < met.peak().num_points; ++p) {
    out.points[p] += side * odd.points[p];
  }
}

const ChannelValues& weigh(const MetWaves& met, Moment moment, const ChannelValues& values,
                           ChannelValues& room) {
  if (moment == Moment::kZeroth || moment == Moment::kLowEncounter) {
    return values;
  }
  const std::size_t num_points = values.has_points ? whole_lanes(met.peak().num_points) : 0;
  room.has_points = values.has_points;
  weigh(moment, met.encounters.frequency, whole_lanes(met.transfer.num_frequencies), values.nodes,
        room.nodes);
  weigh(moment, met.encounters.at_points, num_points, values.points, room.points);
  return room;
}

double integrate(const MetWaves& met, Moment moment, const EnergyNodes& band, const BandWeights& weights,
                 const ChannelValues& values) {
  if (moment == Moment::kLowEncounter) {
    return integrate_low(band, met.encounters, values.nodes);
  }
  return values.has_points ? integrate(weights, values) : integrate(band, values.nodes);
}

}  // namespace quickstrip
