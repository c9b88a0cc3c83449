#include "core/response/heading_moments.hpp"

#include <algorithm>
#include <span>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

void want(Moment moment, bool is_wanted, SweepSubject& subject) {
  if (is_wanted) {
    QS_CHECK(subject.moments.push_back(moment));
  }
}

/// What the sweep of one speed rests on.
struct Sweep {
  const TransferFunctions& transfer;
  std::size_t speed;
  const Watch& watch;
  const IncidentWaves& waves;
  const SeaEnergy& sea;
  const SweepOptions& options;
  bool has_levels;  // of roll damping, or a shifted ship

  [[nodiscard]] const RollDampingLevels& levels() const { return transfer.roll_update[speed].levels; }
};

/// What turn_back() left in the columns from `first` on.
void read_moments(const SweepSubject& subject, std::size_t num_systems, std::size_t first,
                  const HeadingColumns& columns, ChannelMoments& out) {
  out.m0.fill(0.0);
  for (std::size_t s = 0; s < num_systems; ++s) {
    read_moment(columns, first + s, out.m0_by_system[s]);
    for (std::size_t h = 0; h < kNumDirections; ++h) {
      out.m0[h] += out.m0_by_system[s][h];
    }
  }
  out.m0_low_encounter.fill(0.0);
  for (std::size_t i = 1; i < subject.moments.size(); ++i) {
    const bool is_second = subject.moments[i] == Moment::kSecond;
    read_moment(columns, first + num_systems + i - 1, is_second ? out.m2 : out.m0_low_encounter);
  }
}

/// Moments of one channel at each of its levels, from its transformed columns.
void convolve(const SeaEnergy& sea, const SweepSubject& subject, SweepWorkspace& work,
              std::span<ChannelMoments> out) {
  const std::size_t num_moments = subject.moments.size();
  const std::size_t by_level = sea.num_systems + num_moments - 1;
  const std::size_t count = subject.num_levels * by_level;
  clear(count, work.headings);
  for (std::size_t level = 0; level < subject.num_levels; ++level) {
    for (std::size_t i = 0; i < num_moments; ++i) {
      const std::size_t offset = subject.offset(level, i, sea.num_bands);
      const ColumnPlace from{subject.first_even + offset, subject.first_odd + offset, subject.has_sides()};
      for (std::size_t s = 0; s < sea.num_systems; ++s) {
        const std::size_t column = i == 0 ? s : sea.num_systems + i - 1;
        add_product(sea.part[s], work.columns, from, level * by_level + column, work.headings);
      }
    }
  }
  turn_back(count, work.headings);
  for (std::size_t level = 0; level < subject.num_levels; ++level) {
    read_moments(subject, sea.num_systems, level * by_level, work.headings, out[level]);
  }
}

/// At the damping of each heading; `part`: what of a channel's moments.
template <typename Part>
void blend_part(SweepWorkspace& work, std::size_t num_levels, const Part& part, ChannelMoments& out) {
  for (std::size_t h = 0; h < kNumDirections; ++h) {
    double sum = 0.0;
    for (std::size_t l = 0; l < num_levels; ++l) {
      sum += work.level_weight[l][h] * part(work.at_level[l])[h];
    }
    part(out)[h] = sum < 0.0 ? 0.0 : sum;  // a NaN stays one
  }
}

void blend(const Sweep& sweep, const SweepSubject& subject, SweepWorkspace& work, ChannelMoments& out) {
  const std::size_t num_levels = subject.num_levels;
  blend_part(
      work, num_levels, [](ChannelMoments& of) -> ByHeading& { return of.m0; }, out);
  blend_part(
      work, num_levels, [](ChannelMoments& of) -> ByHeading& { return of.m0_low_encounter; }, out);
  if (std::find(subject.moments.begin(), subject.moments.end(), Moment::kSecond) != subject.moments.end()) {
    blend_part(
        work, num_levels, [](ChannelMoments& of) -> ByHeading& { return of.m2; }, out);
  }
  for (std::size_t s = 0; s < sweep.sea.num_systems; ++s) {
    blend_part(
        work, num_levels, [s](ChannelMoments& of) -> ByHeading& { return of.m0_by_system[s]; }, out);
  }
}

/// Dampings of roll at which lateral motions are found anew: beyond the one that the transfer functions were
/// solved with, of a shifted ship all.
StaticVector<RollAddition, kMaxDampedLevels> list_additions(const Sweep& sweep) {
  const RollDampingLevels& levels = sweep.levels();
  const RollShift& shift = sweep.options.shift;
  StaticVector<RollAddition, kMaxDampedLevels> out;
  for (std::size_t l = shift.is_none() ? 1 : 0; sweep.has_levels && l < levels.count; ++l) {
    RollAddition addition;
    addition.damping = levels.count == 1 ? (shift.damping_factor - 1.0) * levels.added[0]
                                         : levels.added[l] - levels.added[0];
    addition.stiffness = shift.stiffness_part * sweep.transfer.roll_update[sweep.speed].table.stiffness;
    QS_CHECK(out.push_back(addition));
  }
  return out;
}

/// From the moments of roll at each level, in work.at_level.
void linearise_headings(const Sweep& sweep, SweepWorkspace& work, HeadingDamping& out) {
  const RollDampers dampers{sweep.transfer.roll_damping, sweep.levels(), sweep.transfer.speeds[sweep.speed],
                            sweep.options.is_stabilised, sweep.options.shift.damping_factor};
  LinearisedRoll roll;
  for (std::size_t h = 0; h < kNumDirections; ++h) {
    RollVariances variances;
    for (std::size_t l = 0; l < dampers.levels.count; ++l) {
      variances.roll[l] = work.at_level[l].m0[h];
      variances.velocity[l] = work.at_level[l].m2[h];
    }
    roll = linearise_roll(dampers, variances, h > 0 ? &roll : nullptr);
    out.added[h] = roll.damping;
    out.residual[h] = roll.residual;
    for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
      work.level_weight[l][h] = roll.weight[l];
    }
  }
}

/// Roll first, where the damping of every other channel waits for it; then the others in the watch's order,
/// and the slow waves.
void list_subjects(const Sweep& sweep, const Needs& needs, const SlowEncounters& slow, std::size_t roll,
                   SweepWorkspace& work) {
  work.subjects.clear();
  const auto add = [&](std::size_t c) {
    const Channel& channel = sweep.watch.channels[c];
    const bool is_damped = sweep.has_levels && feels_roll(channel);
    SweepSubject subject{.channel = &channel,
                         .place = c,
                         .waves = channel.form.wave > 0.0 ? &sweep.waves.of(c) : nullptr,
                         .num_levels = is_damped ? sweep.levels().count : 1};
    want(Moment::kZeroth, true, subject);
    want(Moment::kSecond, needs_second_moment(channel) || (is_damped && c == roll), subject);
    want(Moment::kLowEncounter, needs[c] == Need::kVarianceAndLowEncounter && slow.has_low, subject);
    QS_CHECK(work.subjects.push_back(subject));
  };
  if (sweep.has_levels) {
    add(roll);
  }
  for (std::size_t c = 0; c < sweep.watch.channels.size(); ++c) {
    if (needs[c] != Need::kNone && !(sweep.has_levels && c == roll)) {
      add(c);
    }
  }
  if (sweep.options.counts_slow_waves && slow.has_slow) {
    SweepSubject waves;
    want(Moment::kZeroth, true, waves);
    QS_CHECK(work.subjects.push_back(waves));
  }
}

void read_slow_waves(const Sweep& sweep, const SweepSubject& waves, SweepWorkspace& work, ByHeading& out) {
  convolve(sweep.sea, waves, work, std::span(work.at_level).first(1));
  out = work.at_level[0].m0;
}

/// From transformed columns.
void read_subject(const Sweep& sweep, const SweepSubject& subject, SweepWorkspace& work,
                  HeadingMoments& out) {
  if (subject.channel == nullptr) {
    read_slow_waves(sweep, subject, work, out.slow_wave_energy);
    return;
  }
  ChannelMoments& moments = out.channel[subject.place];
  const bool is_damped = sweep.has_levels && feels_roll(*subject.channel);
  if (!is_damped) {
    convolve(sweep.sea, subject, work, {&moments, 1});
    return;
  }
  convolve(sweep.sea, subject, work, std::span(work.at_level).first(subject.num_levels));
  if (&subject == work.subjects.begin()) {  // roll
    linearise_headings(sweep, work, out.roll_damping);
  }
  blend(sweep, subject, work, moments);
}

}  // namespace

void list_heading_moments(const TransferFunctions& transfer, std::size_t speed, const Watch& watch,
                          const IncidentWaves& waves, const Needs& needs, const SeaEnergy& sea,
                          const SweepOptions& options, SweepWorkspace& work, HeadingMoments& out) {
  const RollDampingLevels& levels = transfer.roll_update[speed].levels;
  const std::size_t roll = find_channel(watch, Quantity::kRoll, 0);
  const bool has_levels = (levels.count > 1 || !options.shift.is_none()) && roll < watch.channels.size();
  const Sweep sweep{transfer, speed, watch, waves, sea, options, has_levels};
  out.roll_damping.added.fill(levels.added[0]);
  out.roll_damping.residual.fill(0.0);
  out.slow_wave_energy.fill(0.0);
  list_subjects(sweep, needs, find_slow_encounters(transfer, speed), roll, work);
  const auto additions = list_additions(sweep);
  const SpeedSweep directions{transfer, speed, sea, additions.span(), options.shift.is_none() ? 1U : 0U};
  // bounded: take_columns() takes one subject at least
  for (std::size_t first = 0; first < work.subjects.size();) {
    const std::size_t end = take_columns(sea.num_bands, first, work.subjects, work.columns);
    const auto subjects = work.subjects.span().subspan(first, end - first);
    list_integrals(directions, subjects, work.direction, work.columns);
    transform_columns(work.columns);
    for (const SweepSubject& subject : subjects) {
      read_subject(sweep, subject, work, out);
    }
    first = end;
  }
}

}  // namespace quickstrip
