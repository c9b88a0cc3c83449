#include "core/response/moments.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/response/damped_motions.hpp"
#include "core/response/direction_response.hpp"
#include "core/response/roll_linearisation.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kHalfCircle = kNumDirections / 2;

/// What the waves of one relative direction bring, by system: its bands together, each with what the system
/// takes of it, between two compass directions.
using RelativeEnergy = std::array<EnergyNodes, kMaxWaveSystems>;

void add_band(const EnergyBand& band, double factor, EnergyBand& out) {
  for (std::size_t f = band.first; f <= band.last; ++f) {
    out.node[f] += factor * band.node[f];
  }
  for (std::size_t f = band.first; f < band.last; ++f) {
    for (std::size_t l = 0; l < kDensityTerms; ++l) {
      out.density[f][l] += factor * band.density[f][l];
    }
  }
  out.first = std::min(out.first, band.first);
  out.last = std::max(out.last, band.last);
}

/// Calls visit(s, band) for each system with its bands together; false when no wave comes from there.
template <typename Visit>
bool for_each_system(const SeaEnergy& sea, Heading heading, std::size_t m, const Visit& visit) {
  const HeadingBracket bracket = bracket_heading(heading);
  const double part = bracket.part;
  const std::size_t d0 = wave_direction(bracket.below, m);
  const std::size_t d1 = wave_direction(bracket.above, m);
  bool is_empty = true;
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    const SystemEnergy& system = sea.part[s];
    EnergyBand sum;
    sum.first = kMaxFrequencies - 1;
    for (std::size_t b = system.first; b < system.first + system.count; ++b) {
      const double factor = (1.0 - part) * system.factor[b][d0] + part * system.factor[b][d1];
      if (factor != 0.0) {
        add_band(sea.band[b], factor, sum);
        is_empty = false;
      }
    }
    sum.first = std::min(sum.first, sum.last);
    visit(s, sum);
  }
  return !is_empty;
}

/// One speed on one course, in one sea.
struct Course {
  const TransferFunctions& transfer;
  std::size_t speed;
  const Watch& watch;
  const SeaEnergy& sea;
  Heading heading;
  bool is_stabilised;

  [[nodiscard]] const RollDampingLevels& levels() const { return transfer.roll_update[speed].levels; }
};

/// One relative direction, and lateral motions at other dampings there.
struct Direction {
  LongitudinalMotions longitudinal;
  std::array<LateralMotions, kRollDampingLevels - 1> damped;
  std::array<BandWeights, kMaxWaveSystems> weights;  // by system
  Encounters encounters;
  PeakShapes shapes;
  RelativeEnergy energy;
  std::size_t m = 0;

  [[nodiscard]] const LateralMotions* at_level(std::size_t level) const {
    return level > 0 ? &damped[level - 1] : nullptr;
  }
};

/// False: no wave comes from there.
bool look_towards(const Course& course, std::size_t m, Direction& out) {
  const std::size_t solved_m = solved_direction(m);
  const RollPeak& peak = course.transfer.peak[course.speed][solved_m];
  out.m = m;
  list_peak_shapes(peak, std::span(course.transfer.omega).first(course.transfer.num_frequencies), out.shapes);
  const bool has_waves =
      for_each_system(course.sea, course.heading, m, [&](std::size_t s, const EnergyBand& band) {
        out.energy[s] = static_cast<const EnergyNodes&>(band);
        list_band_weights(band, peak, out.shapes, out.weights[s]);
      });
  if (!has_waves) {
    return false;
  }
  list_encounters(course.transfer, course.speed, solved_m, out.encounters);
  list_longitudinal(course.transfer, course.speed, solved_m, out.shapes.place, out.longitudinal);
  if (course.levels().count > 1) {
    const RollDampingLevels& levels = course.levels();
    std::array<RollAddition, kRollDampingLevels - 1> addition{};
    for (std::size_t l = 1; l < kRollDampingLevels; ++l) {
      addition[l - 1].damping = levels.added[l] - levels.added[0];
    }
    damp_motions(course.transfer, course.speed, solved_m, out.encounters, addition, out.damped);
  }
  return true;
}

/// `weight` times the moments of one channel at one level of roll damping.
void add_channel(const Course& course, const Direction& direction, std::size_t c, std::size_t level,
                 double weight, ResponseMoments& out) {
  const Channel& channel = course.watch.channels[c];
  const std::size_t num_systems = course.sea.num_systems;
  IncidentWave wave;
  if (channel.form.wave > 0.0) {
    list_incident_wave(course.transfer, solved_direction(direction.m), channel.position, wave);
  }
  const MetWaves met{course.transfer, course.speed, solved_direction(direction.m), direction.encounters,
                     direction.longitudinal};
  ChannelValues values;
  ChannelValues room;
  list_values(met, is_mirrored(direction.m), channel, direction.at_level(level), wave, values);
  const auto of_system = [&](Moment moment, const ChannelValues& weighed, std::size_t s) {
    return weight * integrate(met, moment, direction.energy[s], direction.weights[s], weighed);
  };
  const auto all = [&](Moment moment) {
    const ChannelValues& weighed = weigh(met, moment, values, room);
    double sum = 0.0;
    for (std::size_t s = 0; s < num_systems; ++s) {
      sum += of_system(moment, weighed, s);
    }
    return sum;
  };
  for (std::size_t s = 0; s < num_systems; ++s) {
    const double part = of_system(Moment::kZeroth, values, s);
    out.m0_by_system[s] += part;
    out.m0 += part;
  }
  out.m1 += all(Moment::kFirst);
  out.m2 += all(Moment::kSecond);
  if (out.m4 != kNoMoment) {
    out.m4 += all(Moment::kFourth);
  }
  if (!direction.encounters.low.is_empty()) {
    out.m0_low_encounter += all(Moment::kLowEncounter);
  }
}

/// What roll of this course in this sea asks of the damping.
LinearisedRoll linearise_course(const Course& course) {
  std::array<ResponseMoments, kRollDampingLevels> roll{};
  const std::size_t c = find_channel(course.watch, Quantity::kRoll, 0);
  const bool has_levels = course.levels().count > 1 && c < course.watch.channels.size();
  Direction direction;
  for (std::size_t m = 0; has_levels && m < kNumDirections; ++m) {
    if (look_towards(course, m, direction)) {
      for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
        add_channel(course, direction, c, l, 1.0, roll[l]);
      }
    }
  }
  RollVariances variances;
  for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
    variances.roll[l] = roll[l].m0;
    variances.velocity[l] = roll[l].m2;
  }
  return linearise_roll({course.transfer.roll_damping, course.levels(), course.transfer.speeds[course.speed],
                         course.is_stabilised},
                        variances);
}

/// All channels; `weight` of this speed among those interpolated between.
void add_course(const Course& course, double weight, std::span<ResponseMoments> out,
                RollDampingInUse& damping) {
  const LinearisedRoll roll = linearise_course(course);
  damping.added += weight * roll.damping;
  damping.residual = std::max(damping.residual, roll.residual);
  Direction direction;
  for (std::size_t m = 0; m < kNumDirections; ++m) {
    if (!look_towards(course, m, direction)) {
      continue;
    }
    for (std::size_t c = 0; c < course.watch.channels.size(); ++c) {
      const bool is_damped = course.levels().count > 1 && feels_roll(course.watch.channels[c]);
      for (std::size_t l = 0; l < (is_damped ? kRollDampingLevels : 1); ++l) {
        add_channel(course, direction, c, l, is_damped ? weight * roll.weight[l] : weight, out[c]);
      }
    }
  }
}

double at_least_zero(double value) {
  return value < 0.0 ? 0.0 : value;  // a NaN stays one
}

/// The energy of slow waves at one solved speed, and of all waves.
struct EnergyShare {
  double slow = 0.0;
  double all = 0.0;
};

EnergyShare wave_energy(const TransferFunctions& transfer, std::size_t speed, std::size_t m,
                        std::span<const EnergyNodes> systems) {
  Encounters encounters;
  list_encounters(transfer, speed, solved_direction(m), encounters);
  NodeValues slow_waves{};  // the waves themselves have no peak
  NodeValues all_waves{};
  list_slow_waves(transfer, encounters, slow_waves);
  all_waves.fill(1.0);
  EnergyShare out;
  for (const EnergyNodes& system : systems) {
    out.slow += integrate(system, slow_waves);
    out.all += integrate(system, all_waves);
  }
  return out;
}

}  // namespace

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

HeadingBracket bracket_heading(Heading heading) {
  const double turned = wrap_two_pi(heading.radians) / kTwoPi * static_cast<double>(kNumDirections);
  const double below = std::floor(turned);
  const std::size_t h = static_cast<std::size_t>(below) % kNumDirections;
  return {h, (h + 1) % kNumDirections, turned - below};
}

std::size_t wave_direction(std::size_t h, std::size_t m) {
  return (h + kHalfCircle + kNumDirections - m) % kNumDirections;
}

Result<RollDampingInUse> response_moments(const TransferFunctions& transfer, const Watch& watch,
                                          const SeaEnergy& sea, Heading heading, double speed,
                                          std::span<ResponseMoments> out, const ChannelSet* with_fourth,
                                          bool is_stabilised) {
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
  for (std::size_t c = 0; c < out.size(); ++c) {
    out[c] = ResponseMoments{};
    out[c].m4 = with_fourth == nullptr || (*with_fourth)[c] ? 0.0 : kNoMoment;
  }
  RollDampingInUse damping;
  if (bracket->part < 1.0) {
    add_course({transfer, bracket->lower, watch, sea, heading, is_stabilised}, 1.0 - bracket->part, out,
               damping);
  }
  if (bracket->part > 0.0) {
    add_course({transfer, bracket->upper, watch, sea, heading, is_stabilised}, bracket->part, out, damping);
  }
  // The cubic of a density may undershoot beside a sharp edge of a measured system.
  for (ResponseMoments& moments : out) {
    moments.m0 = at_least_zero(moments.m0);
    moments.m1 = at_least_zero(moments.m1);
    moments.m2 = at_least_zero(moments.m2);
    moments.m4 = moments.m4 == kNoMoment ? kNoMoment : at_least_zero(moments.m4);
    for (double& part : moments.m0_by_system) {
      part = at_least_zero(part);
    }
  }
  const bool finite = std::all_of(out.begin(), out.end(), [](const ResponseMoments& moments) {
    return std::isfinite(moments.m0) && std::isfinite(moments.m2);
  });
  if (!finite) {
    return Error::kNotFinite;
  }
  return damping;
}

Result<double> slow_wave_share(const TransferFunctions& transfer, const SeaEnergy& sea, Heading heading,
                               double speed) {
  if (!std::isfinite(heading.radians)) {
    return Error::kNotFinite;
  }
  const Result<SpeedBracket> bracket = bracket_speed(transfer, speed);
  if (!bracket) {
    return bracket.error();
  }
  double slow = 0.0;
  double all = 0.0;
  RelativeEnergy energy;
  for (std::size_t m = 0; m < kNumDirections; ++m) {
    const bool has_waves = for_each_system(sea, heading, m, [&](std::size_t s, const EnergyBand& band) {
      energy[s] = static_cast<const EnergyNodes&>(band);
    });
    if (!has_waves) {
      continue;
    }
    const auto systems = std::span<const EnergyNodes>(energy).first(sea.num_systems);
    const EnergyShare lower = wave_energy(transfer, bracket->lower, m, systems);
    const EnergyShare upper = wave_energy(transfer, bracket->upper, m, systems);
    slow += (1.0 - bracket->part) * lower.slow + bracket->part * upper.slow;
    all += lower.all;
  }
  return all > 0.0 ? slow / all : 0.0;
}

}  // namespace quickstrip
