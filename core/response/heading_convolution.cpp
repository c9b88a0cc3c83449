#include "core/response/heading_convolution.hpp"

#include <algorithm>
#include <array>

namespace quickstrip {
namespace {

constexpr std::size_t kHalf = kNumDirections / 2;
static_assert(kHalf % 2 == 0);
// Of the largest variance on any heading: below it lies the rounding of the transforms.
constexpr double kRounding = 1e-13;

using Integrals = std::array<double, kBandWidth>;

MetWaves met_waves(const SweepSubject& subject, std::size_t m, const SweepWorkspace& work) {
  return {subject.transfer, subject.speed, m, work.encounters[m]};
}

/// Of the channel without sway, roll and yaw; the same at every roll damping.
void list_longitudinal(const SweepSubject& subject, std::size_t m, const SweepWorkspace& work,
                       ChannelPart& out) {
  const auto& waves = work.wave[subject.wave];
  const bool is_ahead = m > kHalf / 2;
  const IncidentWave* wave = &waves[is_ahead ? kHalf - m : m];
  IncidentWave conjugate;
  if (is_ahead && subject.channel->form.wave > 0.0) {
    conjugate.re = wave->re;
    std::transform(wave->im.begin(), wave->im.end(), conjugate.im.begin(), [](auto value) { return -value; });
    wave = &conjugate;
  }
  longitudinal_part(met_waves(subject, m, work), *subject.channel, *wave, out);
}

const LateralMotions* damped_at(const SweepSubject& subject, std::size_t m, std::size_t level,
                                const SweepWorkspace& work) {
  return level >= work.first_damped && feels_roll(*subject.channel)
             ? &work.damped[m][level - work.first_damped]
             : nullptr;
}

/// Moments of one direction and level.
void integrate_at(const SweepSubject& subject, std::size_t m, std::size_t level, const ChannelValues& even,
                  const ChannelValues* odd, SweepWorkspace& work) {
  const MetWaves met = met_waves(subject, m, work);
  for (std::size_t i = 0; i < subject.moments.size(); ++i) {
    const Moment moment = subject.moments[i];
    Integrals& even_out = work.even[level][i][m];
    Integrals& odd_out = work.odd[level][i][m];
    const bool has_none = moment == Moment::kLowEncounter && !met.encounters.has_low;
    if (has_none) {
      even_out.fill(0.0);
    } else {
      integrate_moment(met, work.shapes[m], subject.sea, moment, even, even_out);
    }
    if (has_none || odd == nullptr) {
      odd_out.fill(0.0);
    } else {
      integrate_moment(met, work.shapes[m], subject.sea, moment, *odd, odd_out);
    }
  }
}

void integrate_waves(const SweepSubject& subject, SweepWorkspace& work) {
  ChannelValues slow;
  for (std::size_t m = 0; m <= kHalf; ++m) {
    list_slow_waves(subject.transfer, work.encounters[m], slow.nodes);
    integrate_at(subject, m, 0, slow, nullptr, work);
  }
}

/// (C - i S) of the response times (c - i s) of a system's factors, summed over its bands, added to a column.
void add_product(const SystemEnergy& part, std::size_t column, bool has_sides, SweepWorkspace& work) {
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
    work.product_cosine[k][column] += re;
    work.product_sine[k][column] += im;
  }
}

/// Variances below the rounding of the largest are none; a NaN stays one.
void drop_rounding(ByHeading& values) {
  const double largest = std::max(0.0, *std::max_element(values.begin(), values.end()));
  for (double& value : values) {
    value = value < kRounding * largest ? 0.0 : value;
  }
}

}  // namespace

void read_headings(const SweepWorkspace& work, std::size_t column, double scale, ByHeading& out) {
  const double by_count = scale / static_cast<double>(kNumDirections);
  for (std::size_t n = 0; n < kNumDirections; ++n) {
    const std::size_t m = n <= kHalf ? n : kNumDirections - n;
    const double odd = n <= kHalf ? work.part_odd[m][column] : -work.part_odd[m][column];
    out[(n + kHalf) % kNumDirections] = by_count * (work.part_even[m][column] + odd);
  }
}

void integrate(const SweepSubject& subject, SweepWorkspace& work) {
  if (subject.channel == nullptr) {
    integrate_waves(subject, work);
    return;
  }
  const Channel& channel = *subject.channel;
  ChannelPart longitudinal;
  ChannelPart lateral;
  ChannelValues even;
  ChannelValues odd;
  for (std::size_t m = 0; m <= kHalf; ++m) {
    const MetWaves met = met_waves(subject, m, work);
    const bool has_longitudinal = subject.has_sides() || !feels_roll(channel);
    if (has_longitudinal) {
      list_longitudinal(subject, m, work, longitudinal);
    }
    for (std::size_t level = 0; level < subject.num_levels; ++level) {
      if (feels_roll(channel)) {
        lateral_part(met, channel, damped_at(subject, m, level, work), lateral);
      }
      if (subject.has_sides()) {
        // Waves from right ahead or astern have one side; lateral motions are rounding there.
        list_even_odd(met, channel, longitudinal, lateral, even, odd);
        integrate_at(subject, m, level, even, m > 0 && m < kHalf ? &odd : nullptr, work);
      } else {
        list_square(met, channel, has_longitudinal ? longitudinal : lateral, even);
        integrate_at(subject, m, level, even, nullptr, work);
      }
    }
  }
}

void convolve(const SweepSubject& subject, std::size_t level, SweepWorkspace& work) {
  const SeaEnergy& sea = subject.sea;
  for (std::size_t k = 0; k <= kHalf; ++k) {
    work.product_cosine[k].fill(0.0);
    work.product_sine[k].fill(0.0);
  }
  std::size_t num_columns = 0;
  for (std::size_t i = 0; i < subject.moments.size(); ++i) {
    cosine_transform(work.even[level][i], sea.num_bands, work.cosine);
    if (subject.has_sides()) {
      sine_transform(work.odd[level][i], sea.num_bands, work.sine);
    }
    const bool is_by_system = i == 0;
    for (std::size_t s = 0; s < sea.num_systems; ++s) {
      add_product(sea.part[s], num_columns + (is_by_system ? s : 0), subject.has_sides(), work);
    }
    num_columns += is_by_system ? sea.num_systems : 1;
  }
  cosine_transform(work.product_cosine, num_columns, work.part_even);
  sine_transform(work.product_sine, num_columns, work.part_odd);
}

void read_moment(const SweepWorkspace& work, std::size_t column, ByHeading& out) {
  read_headings(work, column, 1.0, out);
  drop_rounding(out);
}

}  // namespace quickstrip
