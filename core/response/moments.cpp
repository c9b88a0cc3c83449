#include "core/response/moments.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/response/direction_response.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kHalfCircle = kNumDirections / 2;

/// The solved speeds on either side, and how far v lies towards the upper one.
struct SpeedBracket {
  std::size_t lower = 0;
  std::size_t upper = 0;
  double part = 0.0;
};

Result<SpeedBracket> bracket_speed(const TransferFunctions& transfer, double speed) {
  // Speeds at the rim are converted from knots: the last place of the ends is no reason to refuse.
  constexpr double kRounding = 1e-9;
  const std::size_t n = transfer.num_speeds;
  if (n == 0 || !(speed >= transfer.speeds[0] - kRounding) ||
      !(speed <= transfer.speeds[n - 1] + kRounding)) {
    return Error::kSpeedOutOfGrid;
  }
  SpeedBracket bracket;
  while (bracket.lower + 2 < n && speed >= transfer.speeds[bracket.lower + 1]) {
    ++bracket.lower;
  }
  bracket.upper = std::min(bracket.lower + 1, n - 1);
  if (bracket.upper > bracket.lower) {
    const double low = transfer.speeds[bracket.lower];
    bracket.part = std::clamp((speed - low) / (transfer.speeds[bracket.upper] - low), 0.0, 1.0);
  }
  return bracket;
}

using BandFactors = std::array<double, kMaxEnergyBands>;

/// What the systems take of each band at one relative direction, between two compass directions.
struct RelativeEnergy {
  std::array<BandFactors, kMaxWaveSystems> factor{};
  bool is_empty = true;
};

void list_relative_energy(const SeaEnergy& sea, Heading heading, std::size_t m, RelativeEnergy& out) {
  const double turned = wrap_two_pi(heading.radians) / kTwoPi * static_cast<double>(kNumDirections);
  const double below = std::floor(turned);
  const double part = turned - below;
  const std::size_t h = static_cast<std::size_t>(below) % kNumDirections;
  const std::size_t d0 = wave_direction(h, m);
  const std::size_t d1 = wave_direction((h + 1) % kNumDirections, m);
  out.is_empty = true;
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    const SystemEnergy& system = sea.part[s];
    for (std::size_t b = system.first; b < system.first + system.count; ++b) {
      const double factor = (1.0 - part) * system.factor[b][d0] + part * system.factor[b][d1];
      out.factor[s][b] = factor;
      out.is_empty = out.is_empty && factor == 0.0;
    }
  }
}

double of_system(const SeaEnergy& sea, const RelativeEnergy& energy, std::size_t s,
                 std::span<const double> integrals) {
  double sum = 0.0;
  for (std::size_t b = sea.part[s].first; b < sea.part[s].first + sea.part[s].count; ++b) {
    sum += energy.factor[s][b] * integrals[b];
  }
  return sum;
}

double of_all_systems(const SeaEnergy& sea, const RelativeEnergy& energy, std::span<const double> integrals) {
  double sum = 0.0;
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    sum += of_system(sea, energy, s, integrals);
  }
  return sum;
}

/// All channels, one speed, one relative direction; `weight` of this speed among those interpolated between.
void add_direction(const TransferFunctions& transfer, std::size_t speed, std::size_t m, double weight,
                   const Watch& watch, const SeaEnergy& sea, const RelativeEnergy& energy,
                   std::span<ResponseMoments> out) {
  Encounters encounters;
  list_encounters(transfer, speed, solved_direction(m), encounters);
  IncidentWave wave;
  ChannelValues values;
  BandFactors integrals{};
  const auto all = [&](Moment moment) {
    integrate_moment(transfer, speed, m, encounters, sea, moment, values, integrals);
    return weight * of_all_systems(sea, energy, integrals);
  };
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    const Channel& channel = watch.channels[c];
    if (channel.form.wave > 0.0) {
      list_incident_wave(transfer, solved_direction(m), channel.position, wave);
    }
    list_values(transfer, speed, m, channel, encounters, wave, values);
    out[c].m0 += all(Moment::kZeroth);
    for (std::size_t s = 0; s < sea.num_systems; ++s) {
      out[c].m0_by_system[s] += weight * of_system(sea, energy, s, integrals);
    }
    out[c].m1 += all(Moment::kFirst);
    out[c].m2 += all(Moment::kSecond);
    if (encounters.has_low) {
      out[c].m0_low_encounter += all(Moment::kLowEncounter);
    }
  }
}

double at_least_zero(double value) {
  return value < 0.0 ? 0.0 : value;  // a NaN stays one
}

/// The wave energy at one solved speed below the floor, and all of it.
struct EnergyShare {
  double low = 0.0;
  double all = 0.0;
};

EnergyShare wave_energy(const TransferFunctions& transfer, std::size_t speed, std::size_t m,
                        const SeaEnergy& sea, const RelativeEnergy& energy) {
  Encounters encounters;
  list_encounters(transfer, speed, solved_direction(m), encounters);
  BandFactors integrals{};
  ChannelValues values;
  values.nodes.fill(1.0);
  integrate_moment(transfer, speed, m, encounters, sea, Moment::kLowEncounter, values, integrals);
  const double low = of_all_systems(sea, energy, integrals);
  integrate_moment(transfer, speed, m, encounters, sea, Moment::kZeroth, values, integrals);
  return {low, of_all_systems(sea, energy, integrals)};
}

}  // namespace

std::size_t wave_direction(std::size_t h, std::size_t m) {
  return (h + kHalfCircle + kNumDirections - m) % kNumDirections;
}

Status response_moments(const TransferFunctions& transfer, const Watch& watch, const SeaEnergy& sea,
                        Heading heading, double speed, std::span<ResponseMoments> out) {
  if (out.size() != watch.channels.size() || sea.num_frequencies != transfer.num_frequencies) {
    return Error::kTooMany;
  }
  if (!std::isfinite(heading.radians)) {
    return Error::kNotFinite;
  }
  const Result<SpeedBracket> bracket = bracket_speed(transfer, speed);
  if (!bracket) {
    return bracket.error();
  }
  std::fill(out.begin(), out.end(), ResponseMoments{});
  RelativeEnergy energy;
  for (std::size_t m = 0; m < kNumDirections; ++m) {
    list_relative_energy(sea, heading, m, energy);
    if (energy.is_empty) {
      continue;
    }
    if (bracket->part < 1.0) {
      add_direction(transfer, bracket->lower, m, 1.0 - bracket->part, watch, sea, energy, out);
    }
    if (bracket->part > 0.0) {
      add_direction(transfer, bracket->upper, m, bracket->part, watch, sea, energy, out);
    }
  }
  // The cubic of a density may undershoot beside a sharp edge of a measured system.
  for (ResponseMoments& moments : out) {
    moments.m0 = at_least_zero(moments.m0);
    moments.m1 = at_least_zero(moments.m1);
    moments.m2 = at_least_zero(moments.m2);
    for (double& part : moments.m0_by_system) {
      part = at_least_zero(part);
    }
  }
  const bool finite = std::all_of(out.begin(), out.end(), [](const ResponseMoments& moments) {
    return std::isfinite(moments.m0) && std::isfinite(moments.m2);
  });
  return finite ? Status() : Status(Error::kNotFinite);
}

Result<double> low_encounter_wave_share(const TransferFunctions& transfer, const SeaEnergy& sea,
                                        Heading heading, double speed) {
  if (!std::isfinite(heading.radians)) {
    return Error::kNotFinite;
  }
  const Result<SpeedBracket> bracket = bracket_speed(transfer, speed);
  if (!bracket) {
    return bracket.error();
  }
  double low = 0.0;
  double all = 0.0;
  RelativeEnergy energy;
  for (std::size_t m = 0; m < kNumDirections; ++m) {
    list_relative_energy(sea, heading, m, energy);
    if (energy.is_empty) {
      continue;
    }
    const EnergyShare lower = wave_energy(transfer, bracket->lower, m, sea, energy);
    const EnergyShare upper = wave_energy(transfer, bracket->upper, m, sea, energy);
    low += (1.0 - bracket->part) * lower.low + bracket->part * upper.low;
    all += lower.all;
  }
  return all > 0.0 ? low / all : 0.0;
}

}  // namespace quickstrip
