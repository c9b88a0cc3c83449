#include "core/response/direction_response.hpp"

#include <cmath>

#include "core/response/met_energy.hpp"

namespace quickstrip {
namespace {

// One loop a moment: a choice within would keep the compiler from making vectors of it.
template <std::size_t N>
void weigh(Moment moment, const std::array<float, N>& squared, std::size_t n,
           const std::array<float, N>& values, std::array<float, N>& out) {
  switch (moment) {
    case Moment::kZeroth:
    case Moment::kLowEncounter:
      return;
    case Moment::kFirst:
      for (std::size_t i = 0; i < n; ++i) {
        out[i] = values[i] * std::sqrt(squared[i]);
      }
      return;
    case Moment::kSecond:
      for (std::size_t i = 0; i < n; ++i) {
        out[i] = values[i] * squared[i];
      }
      return;
    case Moment::kFourth:
      for (std::size_t i = 0; i < n; ++i) {
        out[i] = values[i] * (squared[i] * squared[i]);
      }
      return;
  }
}

/// What is to be integrated: `values` or, after another moment, `room`.
const ChannelValues& weigh(const MetWaves& met, Moment moment, const ChannelValues& values,
                           ChannelValues& room) {
  if (moment == Moment::kZeroth) {
    return values;
  }
  const std::size_t num_points = values.has_points ? whole_lanes(met.peak().num_points) : 0;
  room.has_points = values.has_points;
  weigh(moment, met.encounters.squared, whole_lanes(met.transfer.num_frequencies), values.nodes, room.nodes);
  weigh(moment, met.encounters.squared_at_points, num_points, values.points, room.points);
  return room;
}

// Waves from right ahead move a ship sideways by rounding only, and products of that are subnormal numbers,
// which take a processor a hundred times as long.
void drop_rounding(ChannelPart& part) {
  constexpr float kLeast = 1e-10F;  // m or rad a metre, or these times rad2/s2
  const auto drop = [](auto& values) {
    for (float& value : values) {
      value = std::fabs(value) < kLeast ? 0.0F : value;
    }
  };
  drop(part.re);
  drop(part.im);
  drop(part.point_re);
  drop(part.point_im);
}

}  // namespace

bool has_sides(const MetWaves& met, const Channel& channel) {
  return has_two_sides(met.solved_m) && !is_symmetric(channel);
}

void begin_channel(const MetWaves& met, const Channel& channel, const WaveThere& wave, ChannelRoom& room) {
  if (!is_symmetric(channel) || !feels_roll(channel)) {
    longitudinal_part(met, channel, wave, room.longitudinal);
  }
}

void list_values(const MetWaves& met, const Channel& channel, const LateralMotions* damped,
                 ChannelRoom& room) {
  if (!feels_roll(channel)) {
    list_square(met, channel, room.longitudinal, room.even);
    return;
  }
  lateral_part(met, channel, damped, room.lateral);
  if (!has_two_sides(met.solved_m)) {
    drop_rounding(room.lateral);
  }
  if (is_symmetric(channel)) {
    list_square(met, channel, room.lateral, room.even);
  } else {
    list_even_odd(met, channel, room.longitudinal, room.lateral, room.even, room.odd);
  }
}

void integrate_moment(const MetWaves& met, Moment moment, std::span<const BandWeights> bands,
                      const ChannelValues& values, ChannelRoom& room, std::span<double> out) {
  if (moment == Moment::kLowEncounter) {
    integrate_low(bands, met.encounters, values.nodes, out);
  } else {
    integrate(bands, weigh(met, moment, values, room.weighed), out);
  }
}

}  // namespace quickstrip
