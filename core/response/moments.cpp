#include "core/response/moments.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/check.hpp"
#include "core/response/damped_motions.hpp"
#include "core/response/direction_response.hpp"
#include "core/response/met_energy.hpp"
#include "core/response/roll_linearisation.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kHalf = kNumDirections / 2;

/// One speed on one course, in one sea.
struct Course {
  const TransferFunctions& transfer;
  std::size_t speed;
  const Watch& watch;
  const SeaEnergy& sea;
  HeadingBracket heading;
  const MomentOptions& options;

  [[nodiscard]] const RollDampingLevels& levels() const { return transfer.roll_update[speed].levels; }
};

/// What the sums of a solved direction and its mirror image rest on.
struct Direction {
  Encounters encounters;
  LongitudinalMotions longitudinal;
  PeakShapes shapes;
  std::array<LateralMotions, kRollDampingLevels - 1> damped;
  // By system; what both sides bring, and their difference (met_energy.hpp).
  std::array<BandWeights, kMaxWaveSystems> even;
  std::array<BandWeights, kMaxWaveSystems> odd;

  [[nodiscard]] const LateralMotions* at_level(std::size_t level) const {
    return level > 0 ? &damped[level - 1] : nullptr;
  }
};

/// False: no wave comes from there.
bool look_towards(const Course& course, std::size_t m, Direction& out) {
  const TransferFunctions& transfer = course.transfer;
  const RollPeak& peak = transfer.peak[course.speed][m];
  list_peak_shapes(peak, std::span(transfer.omega).first(transfer.num_frequencies), out.shapes);
  bool has_waves = false;
  MetEnergy energy;
  for (std::size_t s = 0; s < course.sea.num_systems; ++s) {
    has_waves = meet_energy(course.sea, s, course.heading, m, energy) || has_waves;
    list_band_weights(energy.even, peak, out.shapes, out.even[s]);
    list_band_weights(energy.odd, peak, out.shapes, out.odd[s]);
  }
  if (!has_waves) {
    return false;
  }
  list_encounters(transfer, course.speed, m, out.encounters);
  list_longitudinal(transfer, course.speed, m, out.shapes.place, out.longitudinal);
  if (course.levels().count > 1) {
    const RollDampingLevels& levels = course.levels();
    std::array<RollAddition, kRollDampingLevels - 1> addition{};
    for (std::size_t l = 1; l < kRollDampingLevels; ++l) {
      addition[l - 1].damping = levels.added[l] - levels.added[0];
    }
    damp_motions(transfer, course.speed, m, out.encounters, addition, out.damped);
  }
  return true;
}

/// One channel as it stands in `room`.
struct Seen {
  const MetWaves& met;
  const Direction& direction;
  std::size_t num_systems;
  bool has_sides;
  ChannelRoom& room;
};

/// A moment by system.
using BySystem = std::array<double, kMaxWaveSystems>;

BySystem integrate_moment(const Seen& seen, Moment moment) {
  BySystem out{};
  const auto add = [&](const ChannelValues& values, const std::array<BandWeights, kMaxWaveSystems>& weights) {
    BySystem more;
    integrate_moment(seen.met, moment, std::span(weights).first(seen.num_systems), values, seen.room,
                     std::span(more).first(seen.num_systems));
    for (std::size_t s = 0; s < seen.num_systems; ++s) {
      out[s] += more[s];
    }
  };
  add(seen.room.even, seen.direction.even);
  if (seen.has_sides) {
    add(seen.room.odd, seen.direction.odd);
  }
  return out;
}

double integrate_all(const Seen& seen, Moment moment) {
  const BySystem parts = integrate_moment(seen, moment);
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

/// `weight` times what is seen.
void add_moments(const Seen& seen, double weight, ResponseMoments& out) {
  const BySystem zeroth = integrate_moment(seen, Moment::kZeroth);
  for (std::size_t s = 0; s < seen.num_systems; ++s) {
    out.m0_by_system[s] += weight * zeroth[s];
    out.m0 += weight * zeroth[s];
  }
  out.m1 += weight * integrate_all(seen, Moment::kFirst);
  out.m2 += weight * integrate_all(seen, Moment::kSecond);
  if (out.m4 != kNoMoment) {
    out.m4 += weight * integrate_all(seen, Moment::kFourth);
  }
  if (!seen.direction.encounters.low.is_empty()) {
    out.m0_low_encounter += weight * integrate_all(seen, Moment::kLowEncounter);
  }
}

/// Moments of one channel, out[l] at level l of roll damping with its weight.
struct LevelMoments {
  double weight = 0.0;
  ResponseMoments* out = nullptr;
};
using Levels = std::array<LevelMoments, kRollDampingLevels>;

void add_channel(const Course& course, std::size_t m, const Direction& direction, std::size_t c,
                 std::span<const LevelMoments> levels, ChannelRoom& room) {
  const Channel& channel = course.watch.channels[c];
  const MetWaves met{course.transfer, course.speed, m, direction.encounters, direction.longitudinal};
  IncidentWave wave;
  const IncidentWaves* const listed = course.options.waves;
  if (channel.form.wave > 0.0 && listed == nullptr) {
    list_incident_wave(course.transfer, m, channel.position, wave);
  }
  begin_channel(met, channel, listed != nullptr ? wave_from(listed->of(c), m) : WaveThere{wave}, room);
  const Seen seen{met, direction, course.sea.num_systems, has_sides(met, channel), room};
  for (std::size_t l = 0; l < levels.size(); ++l) {
    list_values(met, channel, direction.at_level(l), room);
    add_moments(seen, levels[l].weight, *levels[l].out);
  }
}

/// What roll of this course in this sea asks of the damping.
LinearisedRoll linearise_course(const Course& course, Direction& direction, ChannelRoom& room) {
  std::array<ResponseMoments, kRollDampingLevels> roll{};
  Levels levels;
  for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
    levels[l] = {1.0, &roll[l]};
  }
  const std::size_t c = find_channel(course.watch, Quantity::kRoll, 0);
  const bool has_levels = course.levels().count > 1 && c < course.watch.channels.size();
  for (std::size_t m = 0; has_levels && m <= kHalf; ++m) {
    if (look_towards(course, m, direction)) {
      add_channel(course, m, direction, c, levels, room);
    }
  }
  RollVariances variances;
  for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
    variances.roll[l] = roll[l].m0;
    variances.velocity[l] = roll[l].m2;
  }
  return linearise_roll({course.transfer.roll_damping, course.levels(), course.transfer.speeds[course.speed],
                         course.options.is_stabilised},
                        variances);
}

/// All channels; `weight` of this speed among those interpolated between.
void add_course(const Course& course, double weight, std::span<ResponseMoments> out,
                RollDampingInUse& damping) {
  Direction direction;
  ChannelRoom room;
  const LinearisedRoll roll = linearise_course(course, direction, room);
  damping.added += weight * roll.damping;
  damping.residual = std::max(damping.residual, roll.residual);
  for (std::size_t m = 0; m <= kHalf; ++m) {
    if (!look_towards(course, m, direction)) {
      continue;
    }
    for (std::size_t c = 0; c < out.size(); ++c) {
      const bool is_damped = course.levels().count > 1 && feels_roll(course.watch.channels[c]);
      Levels levels;
      for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
        levels[l] = {is_damped ? weight * roll.weight[l] : weight, &out[c]};
      }
      const auto count = is_damped ? kRollDampingLevels : std::size_t{1};
      add_channel(course, m, direction, c, std::span(levels).first(count), room);
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

// From both sides of the ship at once.
EnergyShare wave_energy(const TransferFunctions& transfer, std::size_t speed, std::size_t m,
                        std::span<const EnergyNodes> systems) {
  Encounters encounters;
  list_encounters(transfer, speed, m, encounters);
  NodeValues slow_waves{};  // the waves themselves have no peak
  NodeValues all_waves{};
  list_slow_waves(transfer, encounters, slow_waves);
  all_waves.fill(1.0F);
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

Result<RollDampingInUse> response_moments(const TransferFunctions& transfer, const Watch& watch,
                                          const SeaEnergy& sea, Heading heading, double speed,
                                          std::span<ResponseMoments> out, const MomentOptions& options) {
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
    out[c].m4 = options.with_fourth == nullptr || (*options.with_fourth)[c] ? 0.0 : kNoMoment;
  }
  const HeadingBracket directions = bracket_heading(heading);
  RollDampingInUse damping;
  if (bracket->part < 1.0) {
    add_course({transfer, bracket->lower, watch, sea, directions, options}, 1.0 - bracket->part, out,
               damping);
  }
  if (bracket->part > 0.0) {
    add_course({transfer, bracket->upper, watch, sea, directions, options}, bracket->part, out, damping);
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
  const HeadingBracket directions = bracket_heading(heading);
  std::array<EnergyNodes, kMaxWaveSystems> energy;
  MetEnergy met;
  for (std::size_t m = 0; m <= kHalf; ++m) {
    bool has_waves = false;
    for (std::size_t s = 0; s < sea.num_systems; ++s) {
      has_waves = meet_energy(sea, s, directions, m, met) || has_waves;
      energy[s] = static_cast<const EnergyNodes&>(met.even);
    }
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
