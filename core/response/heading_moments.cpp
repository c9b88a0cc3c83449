#include "core/response/heading_moments.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kHalf = kNumDirections / 2;

/// One channel at one speed, or the waves themselves (null).
struct Subject {
  const TransferFunctions& transfer;
  std::size_t speed;
  const Channel* channel;
  std::size_t wave;  // place among the incident waves
  const SeaEnergy& sea;
};

void integrate_direction(const Subject& subject, std::size_t m, Moment moment, const SweepWorkspace& work,
                         ChannelValues& values, std::span<double> out) {
  const std::size_t solved_m = solved_direction(m);
  const Encounters& encounters = work.encounters[solved_m];
  if (moment == Moment::kLowEncounter && !encounters.has_low) {
    std::fill(out.begin(), out.end(), 0.0);
    return;
  }
  if (subject.channel != nullptr) {
    list_values(subject.transfer, subject.speed, m, *subject.channel, encounters,
                work.wave[subject.wave][solved_m], values);
  }
  integrate_moment(subject.transfer, subject.speed, m, encounters, subject.sea, moment, values, out);
}

/// Integrals by relative direction and band, transformed. False: an even function, no sine part.
bool transform_response(const Subject& subject, Moment moment, SweepWorkspace& work) {
  const std::size_t num_bands = subject.sea.num_bands;
  const bool has_sides = subject.channel != nullptr && !is_symmetric(*subject.channel);
  ChannelValues values;
  values.nodes.fill(1.0);
  std::array<double, kBandWidth> other{};
  for (std::size_t m = 0; m <= kHalf; ++m) {
    integrate_direction(subject, m, moment, work, values, work.even[m]);
    if (!has_sides || m == 0 || m == kHalf) {
      work.odd[m].fill(0.0);
      continue;
    }
    integrate_direction(subject, kNumDirections - m, moment, work, values, other);
    for (std::size_t b = 0; b < num_bands; ++b) {
      const double one = work.even[m][b];
      work.even[m][b] = 0.5 * (one + other[b]);
      work.odd[m][b] = 0.5 * (one - other[b]);
    }
  }
  cosine_transform(work.even, num_bands, work.cosine);
  if (has_sides) {
    sine_transform(work.odd, num_bands, work.sine);
  }
  return has_sides;
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

/// Leaves the moment by system and heading in the workspace; adds them up.
void sweep(const Subject& subject, Moment moment, SweepWorkspace& work, ByHeading& total) {
  const bool has_sides = transform_response(subject, moment, work);
  for (std::size_t s = 0; s < subject.sea.num_systems; ++s) {
    multiply(subject.sea.part[s], s, has_sides, work);
  }
  transform_back(subject.sea.num_systems, work);
  total.fill(0.0);
  for (std::size_t s = 0; s < subject.sea.num_systems; ++s) {
    for (std::size_t h = 0; h < kNumDirections; ++h) {
      total[h] += work.by_system[s][h];
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
    for (std::size_t m = 0; m <= kHalf; ++m) {
      list_incident_wave(transfer, m, watch.channels[c].position, work.wave[num_waves][m]);
    }
    ++num_waves;
  }
}

void list_heading_moments(const TransferFunctions& transfer, std::size_t speed, const Watch& watch,
                          const Needs& needs, const SeaEnergy& sea, bool counts_wave_energy,
                          SweepWorkspace& work, HeadingMoments& out) {
  bool has_low = false;
  for (std::size_t m = 0; m <= kHalf; ++m) {
    list_encounters(transfer, speed, m, work.encounters[m]);
    has_low = has_low || work.encounters[m].has_low;
  }
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    if (needs[c] == Need::kNone) {
      continue;
    }
    const Subject subject{transfer, speed, &watch.channels[c], work.wave_of[c], sea};
    sweep(subject, Moment::kZeroth, work, out.m0[c]);
    std::copy_n(work.by_system.begin(), sea.num_systems, out.m0_by_system[c].begin());
    if (watch.channels[c].form.wave > 0.0) {
      sweep(subject, Moment::kSecond, work, out.m2[c]);
    }
    if (needs[c] == Need::kVarianceAndLowEncounter && has_low) {
      sweep(subject, Moment::kLowEncounter, work, out.m0_low_encounter[c]);
    } else {
      out.m0_low_encounter[c].fill(0.0);
    }
  }
  out.low_encounter_energy.fill(0.0);
  if (counts_wave_energy && has_low) {
    sweep({transfer, speed, nullptr, 0, sea}, Moment::kLowEncounter, work, out.low_encounter_energy);
  }
}

}  // namespace quickstrip
