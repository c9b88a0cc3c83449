#include "core/response/heading_moments.hpp"

#include <algorithm>
#include <span>

#include "core/base/check.hpp"
#include "core/response/heading_convolution.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kHalf = kNumDirections / 2;

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
  const Needs& needs;
  const SeaEnergy& sea;
  bool has_low;

  [[nodiscard]] const RollDampingLevels& levels() const { return transfer.roll_update[speed].levels; }
};

/// What convolve() left in the columns.
void read_moments(const SweepSubject& subject, const SweepWorkspace& work, ChannelMoments& out) {
  const std::size_t num_systems = subject.sea.num_systems;
  out.m0.fill(0.0);
  for (std::size_t s = 0; s < num_systems; ++s) {
    read_moment(work, s, out.m0_by_system[s]);
    for (std::size_t h = 0; h < kNumDirections; ++h) {
      out.m0[h] += out.m0_by_system[s][h];
    }
  }
  out.m0_low_encounter.fill(0.0);
  for (std::size_t i = 1; i < subject.moments.size(); ++i) {
    const bool is_second = subject.moments[i] == Moment::kSecond;
    read_moment(work, num_systems + i - 1, is_second ? out.m2 : out.m0_low_encounter);
  }
}

/// Everything that is wanted of one channel, at `num_levels` of roll damping.
void list_channel(const Sweep& sweep, std::size_t c, bool wants_second, SweepWorkspace& work,
                  std::span<ChannelMoments> out) {
  const Channel& channel = sweep.watch.channels[c];
  SweepSubject subject{sweep.transfer, sweep.speed, &channel, work.wave_of[c], sweep.sea, out.size(), {}};
  const bool wants_low = sweep.needs[c] == Need::kVarianceAndLowEncounter && sweep.has_low;
  want(Moment::kZeroth, true, subject);
  want(Moment::kSecond, wants_second, subject);
  want(Moment::kLowEncounter, wants_low, subject);
  integrate(subject, work);
  for (std::size_t level = 0; level < out.size(); ++level) {
    convolve(subject, level, work);
    read_moments(subject, work, out[level]);
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

void blend(const Sweep& sweep, bool has_second, SweepWorkspace& work, ChannelMoments& out) {
  const std::size_t num_levels = sweep.levels().count;
  blend_part(
      work, num_levels, [](ChannelMoments& of) -> ByHeading& { return of.m0; }, out);
  blend_part(
      work, num_levels, [](ChannelMoments& of) -> ByHeading& { return of.m0_low_encounter; }, out);
  if (has_second) {
    blend_part(
        work, num_levels, [](ChannelMoments& of) -> ByHeading& { return of.m2; }, out);
  }
  for (std::size_t s = 0; s < sweep.sea.num_systems; ++s) {
    blend_part(
        work, num_levels, [s](ChannelMoments& of) -> ByHeading& { return of.m0_by_system[s]; }, out);
  }
}

void list_at_levels(const Sweep& sweep, std::size_t c, bool wants_second, SweepWorkspace& work) {
  list_channel(sweep, c, wants_second, work, std::span(work.at_level).first(sweep.levels().count));
}

/// Lateral motions at the levels that the transfer functions do not hold themselves.
void list_damped(const Sweep& sweep, const RollShift& shift, SweepWorkspace& work) {
  const RollDampingLevels& levels = sweep.levels();
  std::array<RollAddition, kRollDampingLevels> addition{};
  for (std::size_t l = 0; l < levels.count; ++l) {
    addition[l].damping = levels.added[l] - levels.added[0];
    addition[l].stiffness = shift.stiffness_part * sweep.transfer.roll_update[sweep.speed].table.stiffness;
  }
  if (levels.count == 1) {
    addition[0].damping = (shift.damping_factor - 1.0) * levels.added[0];
  }
  work.first_damped = shift.is_none() ? 1 : 0;
  const auto wanted = std::span(addition).first(levels.count).subspan(work.first_damped);
  QS_CHECK(wanted.size() <= kMaxDampedLevels);
  for (std::size_t m = 0; m <= kHalf; ++m) {
    damp_motions(sweep.transfer, sweep.speed, m, work.encounters[m], wanted, work.damped[m]);
  }
}

/// From the moments of roll at each level, in work.at_level.
void linearise_headings(const Sweep& sweep, const SweepOptions& options, SweepWorkspace& work,
                        HeadingDamping& out) {
  const RollDampers dampers{sweep.transfer.roll_damping, sweep.levels(), sweep.transfer.speeds[sweep.speed],
                            options.is_stabilised, options.shift.damping_factor};
  for (std::size_t h = 0; h < kNumDirections; ++h) {
    RollVariances variances;
    for (std::size_t l = 0; l < dampers.levels.count; ++l) {
      variances.roll[l] = work.at_level[l].m0[h];
      variances.velocity[l] = work.at_level[l].m2[h];
    }
    const LinearisedRoll roll = linearise_roll(dampers, variances);
    out.added[h] = roll.damping;
    out.residual[h] = roll.residual;
    for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
      work.level_weight[l][h] = roll.weight[l];
    }
  }
}

}  // namespace

void prepare_sweep(const TransferFunctions& transfer, const Watch& watch, const Needs& needs,
                   SweepWorkspace& work) {
  std::size_t num_waves = 0;
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    work.wave_of[c] = 0;
    if (needs[c] == Need::kNone || !(watch.channels[c].form.wave > 0.0)) {
      continue;
    }
    QS_CHECK(num_waves < work.wave.size());
    work.wave_of[c] = num_waves;
    for (std::size_t m = 0; m <= kHalf / 2; ++m) {
      list_incident_wave(transfer, m, watch.channels[c].position, work.wave[num_waves][m]);
    }
    ++num_waves;
  }
}

void list_heading_moments(const TransferFunctions& transfer, std::size_t speed, const Watch& watch,
                          const Needs& needs, const SeaEnergy& sea, const SweepOptions& options,
                          SweepWorkspace& work, HeadingMoments& out) {
  const auto omega = std::span(transfer.omega).first(transfer.num_frequencies);
  bool has_low = false;
  bool has_slow = false;
  for (std::size_t m = 0; m <= kHalf; ++m) {
    list_encounters(transfer, speed, m, work.encounters[m]);
    list_peak_shapes(transfer.peak[speed][m], omega, work.shapes[m]);
    has_low = has_low || work.encounters[m].has_low;
    has_slow = has_slow || work.encounters[m].has_slow;
  }
  const Sweep sweep{transfer, speed, watch, needs, sea, has_low};
  const RollDampingLevels& levels = transfer.roll_update[speed].levels;
  out.roll_damping.added.fill(levels.added[0]);
  out.roll_damping.residual.fill(0.0);
  const std::size_t roll = find_channel(watch, Quantity::kRoll, 0);
  const bool has_levels = (levels.count > 1 || !options.shift.is_none()) && roll < watch.channels.size();
  if (has_levels) {
    list_damped(sweep, options.shift, work);
    list_at_levels(sweep, roll, true, work);
    linearise_headings(sweep, options, work, out.roll_damping);
    blend(sweep, true, work, out.channel[roll]);
  }
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    if (needs[c] == Need::kNone || (has_levels && c == roll)) {
      continue;
    }
    const bool wants_second = needs_second_moment(watch.channels[c]);
    if (has_levels && feels_roll(watch.channels[c])) {
      list_at_levels(sweep, c, wants_second, work);
      blend(sweep, wants_second, work, out.channel[c]);
    } else {
      list_channel(sweep, c, wants_second, work, {&out.channel[c], 1});
    }
  }
  out.slow_wave_energy.fill(0.0);
  if (options.counts_slow_waves && has_slow) {
    SweepSubject waves{transfer, speed, nullptr, 0, sea, 1, {}};
    want(Moment::kZeroth, true, waves);
    integrate(waves, work);
    convolve(waves, 0, work);
    ByHeading of_system;
    for (std::size_t s = 0; s < sea.num_systems; ++s) {
      read_moment(work, s, of_system);
      for (std::size_t h = 0; h < kNumDirections; ++h) {
        out.slow_wave_energy[h] += of_system[h];
      }
    }
  }
}

}  // namespace quickstrip
