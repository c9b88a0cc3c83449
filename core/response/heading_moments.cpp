#include "core/response/heading_moments.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/base/static_vector.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kHalf = kNumDirections / 2;
static_assert(kHalf % 2 == 0);
// Of the largest variance on any heading: below it lies the rounding of the transforms.
constexpr double kRounding = 1e-13;

/// One channel at one speed, or the waves themselves (null), and what is wanted of it.
struct Subject {
  const TransferFunctions& transfer;
  std::size_t speed;
  const Channel* channel;
  std::size_t wave;  // place among the incident waves
  const SeaEnergy& sea;
  std::size_t level;  // of roll damping
  StaticVector<Moment, 3> moments;

  [[nodiscard]] bool has_sides() const { return channel != nullptr && !is_symmetric(*channel); }
};

using Integrals = std::array<double, kBandWidth>;

void list_values_at(const Subject& subject, std::size_t m, const SweepWorkspace& work,
                    ChannelValues& values) {
  if (subject.channel == nullptr) {
    return;
  }
  const std::size_t solved_m = solved_direction(m);
  const auto& waves = work.wave[subject.wave];
  const bool is_ahead = solved_m > kHalf / 2;
  const IncidentWave* wave = &waves[is_ahead ? kHalf - solved_m : solved_m];
  IncidentWave conjugate;
  if (is_ahead && subject.channel->form.wave > 0.0) {
    conjugate.re = wave->re;
    std::transform(wave->im.begin(), wave->im.end(), conjugate.im.begin(), [](auto value) { return -value; });
    wave = &conjugate;
  }
  const LateralMotions* const damped =
      subject.level > 0 ? &work.damped[solved_m][subject.level - 1] : nullptr;
  list_values(subject.transfer, subject.speed, m, *subject.channel, damped, work.encounters[solved_m], *wave,
              values);
}

void integrate_at(const Subject& subject, std::size_t m, Moment moment, const ChannelValues& values,
                  const SweepWorkspace& work, Integrals& out) {
  const Encounters& encounters = work.encounters[solved_direction(m)];
  if (moment == Moment::kLowEncounter && !encounters.has_low) {
    out.fill(0.0);
    return;
  }
  integrate_moment(subject.transfer, subject.speed, m, encounters, work.shapes[solved_direction(m)],
                   subject.sea, moment, values, out);
}

/// Integrals by relative direction and band, even and odd in direction.
void integrate(const Subject& subject, SweepWorkspace& work) {
  ChannelValues values;
  ChannelValues values_of_other;
  values.nodes.fill(1.0);
  Integrals other{};
  for (std::size_t m = 0; m <= kHalf; ++m) {
    const bool has_other = subject.has_sides() && m > 0 && m < kHalf;
    list_values_at(subject, m, work, values);
    if (has_other) {
      list_values_at(subject, kNumDirections - m, work, values_of_other);
    }
    for (std::size_t i = 0; i < subject.moments.size(); ++i) {
      Integrals& even = work.even[i][m];
      Integrals& odd = work.odd[i][m];
      integrate_at(subject, m, subject.moments[i], values, work, even);
      if (!has_other) {
        odd.fill(0.0);
        continue;
      }
      integrate_at(subject, kNumDirections - m, subject.moments[i], values_of_other, work, other);
      for (std::size_t b = 0; b < subject.sea.num_bands; ++b) {
        const double one = even[b];
        even[b] = 0.5 * (one + other[b]);
        odd[b] = 0.5 * (one - other[b]);
      }
    }
  }
}

/// (C - i S) of the response times (c - i s) of a system's factors, summed over its bands.
void multiply(const SystemEnergy& part, std::size_t s, bool has_sides, SweepWorkspace& work) {
  const std::size_t end = part.first + part.count;
  for (std::size_t k = 0; k <= kHalf; ++k) {
    double re = 0.0;
    double im = 0.0;  // minus the imaginary part
    for (std::size_t b = part.first; b < end; ++b) {
      re += work.cosine[k][b] * part.cosine[k][b];
      im += work.cosine[k][b] * part.sine[k][b];
    }
    for (std::size_t b = part.first; b < end && has_sides; ++b) {
      re -= work.sine[k][b] * part.sine[k][b];
      im += work.sine[k][b] * part.cosine[k][b];
    }
    work.product_cosine[k][s] = re;
    work.product_sine[k][s] = im;
  }
}

/// Variances below the rounding of the largest are none; a NaN stays one.
void drop_rounding(ByHeading& values) {
  const double largest = std::max(0.0, *std::max_element(values.begin(), values.end()));
  for (double& value : values) {
    value = value < kRounding * largest ? 0.0 : value;
  }
}

/// Back to headings: waves from d meet a ship heading for h at m = h + half a turn - d.
void transform_back(std::size_t num_systems, SweepWorkspace& work) {
  cosine_transform(work.product_cosine, num_systems, work.part_even);
  sine_transform(work.product_sine, num_systems, work.part_odd);
  constexpr double kScale = 1.0 / static_cast<double>(kNumDirections);
  for (std::size_t s = 0; s < num_systems; ++s) {
    for (std::size_t n = 0; n < kNumDirections; ++n) {
      const std::size_t m = n <= kHalf ? n : kNumDirections - n;
      const double odd = n <= kHalf ? work.part_odd[m][s] : -work.part_odd[m][s];
      work.by_system[s][(n + kHalf) % kNumDirections] = kScale * (work.part_even[m][s] + odd);
    }
    drop_rounding(work.by_system[s]);
  }
}

/// Moment i of the subject: by system and heading in the workspace, and all together.
void convolve(const Subject& subject, std::size_t i, SweepWorkspace& work, ByHeading& total) {
  const SeaEnergy& sea = subject.sea;
  cosine_transform(work.even[i], sea.num_bands, work.cosine);
  if (subject.has_sides()) {
    sine_transform(work.odd[i], sea.num_bands, work.sine);
  }
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    multiply(sea.part[s], s, subject.has_sides(), work);
  }
  transform_back(sea.num_systems, work);
  total.fill(0.0);
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    for (std::size_t h = 0; h < kNumDirections; ++h) {
      total[h] += work.by_system[s][h];
    }
  }
}

void want(Moment moment, bool is_wanted, Subject& subject) {
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
};

/// Everything that is wanted of one channel, at one level of roll damping.
void list_channel(const Sweep& sweep, std::size_t c, std::size_t level, bool wants_second,
                  SweepWorkspace& work, ChannelMoments& out) {
  const Channel& channel = sweep.watch.channels[c];
  Subject subject{sweep.transfer, sweep.speed, &channel, work.wave_of[c], sweep.sea, level, {}};
  const bool wants_low = sweep.needs[c] == Need::kVarianceAndLowEncounter && sweep.has_low;
  want(Moment::kZeroth, true, subject);
  want(Moment::kSecond, wants_second, subject);
  want(Moment::kLowEncounter, wants_low, subject);
  integrate(subject, work);
  convolve(subject, 0, work, out.m0);
  std::copy_n(work.by_system.begin(), sweep.sea.num_systems, out.m0_by_system.begin());
  if (wants_second) {
    convolve(subject, 1, work, out.m2);
  }
  if (wants_low) {
    convolve(subject, subject.moments.size() - 1, work, out.m0_low_encounter);
  } else {
    out.m0_low_encounter.fill(0.0);
  }
}

/// At the damping of each heading; `part`: what of a channel's moments.
template <typename Part>
void blend_part(SweepWorkspace& work, const Part& part, ChannelMoments& out) {
  for (std::size_t h = 0; h < kNumDirections; ++h) {
    double sum = 0.0;
    for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
      sum += work.level_weight[l][h] * part(work.at_level[l])[h];
    }
    part(out)[h] = sum < 0.0 ? 0.0 : sum;  // a NaN stays one
  }
}

void blend(SweepWorkspace& work, std::size_t num_systems, bool has_second, ChannelMoments& out) {
  blend_part(
      work, [](ChannelMoments& of) -> ByHeading& { return of.m0; }, out);
  blend_part(
      work, [](ChannelMoments& of) -> ByHeading& { return of.m0_low_encounter; }, out);
  if (has_second) {
    blend_part(
        work, [](ChannelMoments& of) -> ByHeading& { return of.m2; }, out);
  }
  for (std::size_t s = 0; s < num_systems; ++s) {
    blend_part(
        work, [s](ChannelMoments& of) -> ByHeading& { return of.m0_by_system[s]; }, out);
  }
}

void list_at_levels(const Sweep& sweep, std::size_t c, bool wants_second, SweepWorkspace& work) {
  for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
    list_channel(sweep, c, l, wants_second, work, work.at_level[l]);
  }
}

/// From the moments of roll at each level, in work.at_level.
void linearise_headings(const Sweep& sweep, bool is_stabilised, SweepWorkspace& work, HeadingDamping& out) {
  const RollDampers dampers{sweep.transfer.roll_damping, sweep.transfer.roll_update[sweep.speed].levels,
                            sweep.transfer.speeds[sweep.speed], is_stabilised};
  for (std::size_t h = 0; h < kNumDirections; ++h) {
    RollVariances variances;
    for (std::size_t l = 0; l < kRollDampingLevels; ++l) {
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
  for (std::size_t m = 0; m <= kHalf; ++m) {
    list_encounters(transfer, speed, m, work.encounters[m]);
    list_peak_shapes(transfer.peak[speed][m], omega, work.shapes[m]);
    has_low = has_low || work.encounters[m].has_low;
  }
  const Sweep sweep{transfer, speed, watch, needs, sea, has_low};
  const RollDampingLevels& levels = transfer.roll_update[speed].levels;
  out.roll_damping.added.fill(levels.added[0]);
  out.roll_damping.residual.fill(0.0);
  const std::size_t roll = find_channel(watch, Quantity::kRoll, 0);
  const bool has_levels = levels.count > 1 && roll < watch.channels.size();
  if (has_levels) {
    for (std::size_t m = 0; m <= kHalf; ++m) {
      damp_motions(transfer, speed, m, work.encounters[m], work.damped[m]);
    }
    list_at_levels(sweep, roll, true, work);
    linearise_headings(sweep, options.is_stabilised, work, out.roll_damping);
    blend(work, sea.num_systems, true, out.channel[roll]);
  }
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    if (needs[c] == Need::kNone || (has_levels && c == roll)) {
      continue;
    }
    const bool wants_second = watch.channels[c].form.wave > 0.0;
    if (has_levels && feels_roll(watch.channels[c])) {
      list_at_levels(sweep, c, wants_second, work);
      blend(work, sea.num_systems, wants_second, out.channel[c]);
    } else {
      list_channel(sweep, c, 0, wants_second, work, out.channel[c]);
    }
  }
  out.low_encounter_energy.fill(0.0);
  if (options.counts_wave_energy && has_low) {
    Subject waves{transfer, speed, nullptr, 0, sea, 0, {}};
    want(Moment::kLowEncounter, true, waves);
    integrate(waves, work);
    convolve(waves, 0, work, out.low_encounter_energy);
  }
}

}  // namespace quickstrip
