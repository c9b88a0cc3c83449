#include "core/response/heading_integrals.hpp"

#include <cmath>

#include "core/base/check.hpp"
#include "core/base/prefetch.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kHalf = kNumDirections / 2;
static_assert(kSweepColumns % kTransformBlock == 0 &&
                  kSweepColumns >= 2 * (kRollDampingLevels * 3 * kMaxEnergyBands + kTransformBlock),
              "room for any one channel");

/// Row m of the columns from `first` on.
struct ColumnRow {
  SweepColumns& columns;
  std::size_t first_block;
  std::size_t m;

  double& operator[](std::size_t column) const {
    return columns.block[first_block + column / kTransformBlock][m][column % kTransformBlock];
  }
};

/// One direction, ready for every channel.
struct Towards {
  const SpeedSweep& sweep;
  const MetWaves& met;
  const DirectionWork& work;
  const IncidentWave& no_wave;
  ChannelRoom& room;
  ColumnRow even;
  ColumnRow odd;
};

/// Into the columns of one level.
void integrate_level(const Towards& to, const SweepSubject& subject, std::size_t level,
                     const ChannelValues& values, const ColumnRow& row, std::size_t first) {
  const std::size_t num_bands = to.sweep.sea.num_bands;
  const auto bands = std::span(to.work.weights).first(num_bands);
  std::array<double, kMaxEnergyBands> integral;
  for (std::size_t i = 0; i < subject.moments.size(); ++i) {
    integrate_moment(to.met, subject.moments[i], bands, values, to.room,
                     std::span(integral).first(num_bands));
    const std::size_t column = first + subject.offset(level, i, num_bands);
    for (std::size_t b = 0; b < num_bands; ++b) {
      row[column + b] = integral[b];
    }
  }
}

void clear_level(const Towards& to, const SweepSubject& subject, std::size_t level) {
  const std::size_t num_bands = to.sweep.sea.num_bands;
  const std::size_t first = subject.first_odd + subject.offset(level, 0, num_bands);
  for (std::size_t c = 0; c < subject.moments.size() * num_bands; ++c) {
    to.odd[first + c] = 0.0;
  }
}

const LateralMotions* damped_at(const Towards& to, const SweepSubject& subject, std::size_t level) {
  const bool is_damped = level >= to.sweep.first_damped && !to.sweep.additions.empty();
  return is_damped && feels_roll(*subject.channel) ? &to.work.damped[level - to.sweep.first_damped] : nullptr;
}

WaveThere wave_there(const Towards& to, const SweepSubject& subject) {
  return subject.waves != nullptr ? wave_from(*subject.waves, to.met.solved_m) : WaveThere{to.no_wave};
}

void integrate_channel(const Towards& to, const SweepSubject& subject) {
  const Channel& channel = *subject.channel;
  begin_channel(to.met, channel, wave_there(to, subject), to.room);
  for (std::size_t level = 0; level < subject.num_levels; ++level) {
    list_values(to.met, channel, damped_at(to, subject, level), to.room);
    integrate_level(to, subject, level, to.room.even, to.even, subject.first_even);
    if (has_sides(to.met, channel)) {
      integrate_level(to, subject, level, to.room.odd, to.odd, subject.first_odd);
    } else if (subject.has_sides()) {
      clear_level(to, subject, level);
    }
  }
}

void integrate_slow_waves(const Towards& to, const SweepSubject& subject) {
  ChannelValues& slow = to.room.even;
  slow.has_points = false;
  list_slow_waves(to.sweep.transfer, to.work.encounters, slow.nodes);
  integrate_level(to, subject, 0, slow, to.even, subject.first_even);
}

/// What the sums towards one direction rest on.
void look_towards(const SpeedSweep& sweep, std::size_t m, DirectionWork& out) {
  const TransferFunctions& transfer = sweep.transfer;
  const RollPeak& peak = transfer.peak[sweep.speed][m];
  list_encounters(transfer, sweep.speed, m, out.encounters);
  list_peak_shapes(peak, std::span(transfer.omega).first(transfer.num_frequencies), out.shapes);
  list_longitudinal(transfer, sweep.speed, m, out.shapes.place, out.longitudinal);
  for (std::size_t b = 0; b < sweep.sea.num_bands; ++b) {
    list_band_weights(sweep.sea.band[b], peak, out.shapes, out.weights[b]);
  }
  if (!sweep.additions.empty()) {
    damp_motions(transfer, sweep.speed, m, out.encounters, sweep.additions, out.damped);
  }
}

}  // namespace

std::size_t take_columns(std::size_t num_bands, std::size_t first, SweepSubjects& subjects,
                         SweepColumns& columns) {
  std::size_t num_even = 0;
  std::size_t num_odd = 0;
  std::size_t end = first;
  bool has_room = true;
  for (std::size_t i = first; i < subjects.size() && has_room; ++i) {
    SweepSubject& subject = subjects[i];
    const std::size_t more = subject.num_columns(num_bands);
    const std::size_t more_odd = subject.has_sides() ? more : 0;
    has_room = blocks_of(num_even + more) + blocks_of(num_odd + more_odd) <= kSweepBlocks;
    if (has_room) {
      subject.first_even = num_even;
      subject.first_odd = num_odd;
      num_even += more;
      num_odd += more_odd;
      end = i + 1;
    }
  }
  QS_CHECK(end > first);
  columns.num_even = blocks_of(num_even);
  columns.num_odd = blocks_of(num_odd);
  return end;
}

void list_integrals(const SpeedSweep& sweep, std::span<const SweepSubject> subjects, DirectionWork& work,
                    SweepColumns& columns) {
  ChannelRoom room;
  const IncidentWave no_wave;
  for (std::size_t m = 0; m <= kHalf; ++m) {
    look_towards(sweep, m, work);
    // 4 kB of the next direction while this one is summed: 3 % of the cycle.
    const std::size_t next = m < kHalf ? m + 1 : m;
    prefetch(sweep.transfer.row[sweep.speed][next]);
    prefetch(sweep.transfer.peak[sweep.speed][next]);
    const MetWaves met{sweep.transfer, sweep.speed, m, work.encounters, work.longitudinal};
    const Towards to{sweep, met, work, no_wave, room, {columns, 0, m}, {columns, columns.first_odd(), m}};
    for (const SweepSubject& subject : subjects) {
      if (subject.channel == nullptr) {
        integrate_slow_waves(to, subject);
      } else {
        integrate_channel(to, subject);
      }
    }
  }
}

}  // namespace quickstrip
