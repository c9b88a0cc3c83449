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

void list_values_at(const SweepSubject& subject, std::size_t m, const SweepWorkspace& work,
                    ChannelValues& values) {
  const std::size_t solved_m = solved_direction(m);
  if (subject.channel == nullptr) {
    list_slow_waves(subject.transfer, work.encounters[solved_m], values.nodes);
    return;
  }
  const auto& waves = work.wave[subject.wave];
  const bool is_ahead = solved_m > kHalf / 2;
  const IncidentWave* wave = &waves[is_ahead ? kHalf - solved_m : solved_m];
  IncidentWave conjugate;
  if (is_ahead && subject.channel->form.wave > 0.0) {
    conjugate.re = wave->re;
    std::transform(wave->im.begin(), wave->im.end(), conjugate.im.begin(), [](auto value) { return -value; });
    wave = &conjugate;
  }
  const LateralMotions* const damped = subject.level >= work.first_damped
                                           ? &work.damped[solved_m][subject.level - work.first_damped]
                                           : nullptr;
  list_values(subject.transfer, subject.speed, m, *subject.channel, damped, work.encounters[solved_m], *wave,
              values);
}

void integrate_at(const SweepSubject& subject, std::size_t m, Moment moment, const ChannelValues& values,
                  const SweepWorkspace& work, Integrals& out) {
  const Encounters& encounters = work.encounters[solved_direction(m)];
  if (moment == Moment::kLowEncounter && !encounters.has_low) {
    out.fill(0.0);
    return;
  }
  integrate_moment(subject.transfer, subject.speed, m, encounters, work.shapes[solved_direction(m)],
                   subject.sea, moment, values, out);
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

/// Back to headings, each system.
void transform_back(std::size_t num_systems, SweepWorkspace& work) {
  cosine_transform(work.product_cosine, num_systems, work.part_even);
  sine_transform(work.product_sine, num_systems, work.part_odd);
  for (std::size_t s = 0; s < num_systems; ++s) {
    read_headings(work, s, 1.0, work.by_system[s]);
    drop_rounding(work.by_system[s]);
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
  ChannelValues values;
  ChannelValues values_of_other;
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

void convolve(const SweepSubject& subject, std::size_t i, SweepWorkspace& work, ByHeading& total) {
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

}  // namespace quickstrip
