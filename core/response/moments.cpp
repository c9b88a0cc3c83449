#include "core/response/moments.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/check.hpp"
#include "core/response/peak_terms.hpp"
#include "core/sea/dispersion.hpp"

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

/// Wave energy at one relative direction: per system, and all together.
struct RelativeEnergy {
  std::array<std::array<double, kMaxFrequencies>, kMaxWaveSystems> system{};
  std::array<double, kMaxFrequencies> total{};
  bool is_empty = true;
  std::size_t d0 = 0;  // the two compass directions, and the share of the second
  std::size_t d1 = 0;
  double part = 0.0;
};

RelativeEnergy relative_energy(const SeaEnergy& sea, Heading heading, std::size_t m) {
  const double turned = wrap_two_pi(heading.radians) / kTwoPi * static_cast<double>(kNumDirections);
  const double below = std::floor(turned);
  const double part = turned - below;
  const std::size_t h = static_cast<std::size_t>(below) % kNumDirections;
  const std::size_t d0 = wave_direction(h, m);
  const std::size_t d1 = wave_direction((h + 1) % kNumDirections, m);
  RelativeEnergy out;
  out.d0 = d0;
  out.d1 = d1;
  out.part = part;
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    for (std::size_t f = 0; f < sea.num_frequencies; ++f) {
      const double energy = (1.0 - part) * sea.energy[s][d0][f] + part * sea.energy[s][d1][f];
      out.system[s][f] = energy;
      out.total[f] += energy;
      out.is_empty = out.is_empty && energy == 0.0;
    }
  }
  return out;
}

using TransferRow = std::array<MotionTransfer, kMaxFrequencies>;

void add_moments(const std::array<double, kMaxFrequencies>& h2, const TransferRow& row,
                 const RelativeEnergy& energy, const SeaEnergy& sea, double weight, ResponseMoments& out) {
  for (std::size_t f = 0; f < sea.num_frequencies; ++f) {
    const double omega_e = std::abs(row[f].encounter_frequency);
    const double part = weight * h2[f] * energy.total[f];
    out.m0 += part;
    out.m1 += part * omega_e;
    out.m2 += part * omega_e * omega_e;
    out.m0_low_encounter += row[f].low_encounter ? part : 0.0;
  }
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    for (std::size_t f = 0; f < sea.num_frequencies; ++f) {
      out.m0_by_system[s] += weight * h2[f] * energy.system[s][f];
    }
  }
}

/// The solutions at the roll peak of one speed and relative direction.
struct PeakRow {
  const RollPeak& peak;
  std::array<MotionTransfer, kMaxPeakPoints> solved;
  std::array<double, kMaxPeakPoints> wave_number{};
};

PeakRow peak_row(const TransferFunctions& transfer, std::size_t speed, std::size_t m, double gravity) {
  const RollPeak& peak = transfer.peak[speed][solved_direction(m)];
  PeakRow row{.peak = peak, .solved = peak.solved};
  for (std::size_t p = 0; p < peak.num_points; ++p) {
    row.wave_number[p] = wave_number(peak.omega[p], gravity);
    if (is_mirrored(m)) {
      row.solved[p] = mirrored(row.solved[p]);
    }
  }
  return row;
}

/// Terms of |H|^2 |omega_e|^order, from the values of order 0 at frequencies and points.
PeakTerms terms_of_order(int order, const PeakRow& row, std::span<const double> omega,
                         const TransferRow& base, std::array<double, kMaxFrequencies> at_nodes,
                         std::array<double, kMaxPeakPoints> at_points) {
  for (int i = 0; i < order; ++i) {
    for (std::size_t f = 0; f < omega.size(); ++f) {
      at_nodes[f] *= std::abs(base[f].encounter_frequency);
    }
    for (std::size_t p = 0; p < row.peak.num_points; ++p) {
      at_points[p] *= std::abs(row.solved[p].encounter_frequency);
    }
  }
  return peak_terms(row.peak, omega, std::span(at_nodes).first(omega.size()),
                    std::span(at_points).first(row.peak.num_points));
}

/// The waves of one relative direction at one solved speed: what they hold, and what the ship does in them.
struct Incidence {
  const SeaEnergy& sea;
  const RelativeEnergy& energy;
  double weight;  // of this speed among those interpolated between
  std::span<const double> omega;
  const TransferRow& base;
  const PeakRow& row;
  EncounterAngle mu;
  double gravity;
};

/// What the roll peak adds; h2: |H|^2 of the channel at the wave frequencies.
void add_peak_moments(const Channel& channel, const std::array<double, kMaxFrequencies>& h2,
                      const Incidence& waves, ResponseMoments& out) {
  const PeakRow& row = waves.row;
  const std::size_t n = row.peak.num_points;
  std::array<double, kMaxPeakPoints> points{};
  channel_energies(channel, std::span(row.solved).first(n), std::span(row.wave_number).first(n), waves.mu,
                   waves.gravity, std::span(points).first(n));
  const auto variance = [&waves](const PeakTerms& terms, const SeaEnergy::Densities& densities) {
    const RelativeEnergy& at = waves.energy;
    return waves.weight * ((1.0 - at.part) * peak_variance(waves.row.peak, terms, densities[at.d0]) +
                           at.part * peak_variance(waves.row.peak, terms, densities[at.d1]));
  };
  const PeakTerms of_m0 = terms_of_order(0, row, waves.omega, waves.base, h2, points);
  out.m0 += variance(of_m0, waves.sea.total_density);
  out.m1 += variance(terms_of_order(1, row, waves.omega, waves.base, h2, points), waves.sea.total_density);
  out.m2 += variance(terms_of_order(2, row, waves.omega, waves.base, h2, points), waves.sea.total_density);
  for (std::size_t s = 0; s < waves.sea.num_systems; ++s) {
    out.m0_by_system[s] += variance(of_m0, waves.sea.density[s]);
  }
}

/// All channels, one speed, one relative direction.
void add_direction(const TransferFunctions& transfer, std::size_t speed, std::size_t m, double weight,
                   const Watch& watch, const SeaEnergy& sea, const RelativeEnergy& energy,
                   std::span<ResponseMoments> out) {
  const std::size_t n = transfer.num_frequencies;
  TransferRow row = transfer.solved[speed][solved_direction(m)];
  if (is_mirrored(m)) {
    std::transform(row.begin(), row.begin() + n, row.begin(), mirrored);
  }
  const PeakRow peak = peak_row(transfer, speed, m, watch.gravity);
  const Incidence waves{
      sea,          energy, weight, std::span(transfer.omega).first(n), row, peak, relative_direction(m),
      watch.gravity};
  std::array<double, kMaxFrequencies> h2{};
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    channel_energies(watch.channels[c], std::span(row).first(n), std::span(transfer.wave_number).first(n),
                     relative_direction(m), watch.gravity, std::span(h2).first(n));
    add_moments(h2, row, energy, sea, weight, out[c]);
    if (peak.peak.num_points > 0 && feels_roll(watch.channels[c])) {
      add_peak_moments(watch.channels[c], h2, waves, out[c]);
    }
  }
}

double at_least_zero(double value) {
  return value < 0.0 ? 0.0 : value;  // a NaN stays one
}

/// The part of `energy` below the floor at one solved speed.
double low_encounter_energy(const TransferFunctions& transfer, std::size_t speed, std::size_t m,
                            const RelativeEnergy& energy) {
  const TransferRow& row = transfer.solved[speed][solved_direction(m)];
  double low = 0.0;
  for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
    low += row[f].low_encounter ? energy.total[f] : 0.0;
  }
  return low;
}

}  // namespace

EncounterAngle relative_direction(std::size_t m) {
  const double mu = kTwoPi * static_cast<double>(solved_direction(m)) / static_cast<double>(kNumDirections);
  return {is_mirrored(m) ? -mu : mu};
}

std::size_t solved_direction(std::size_t m) {
  QS_CHECK(m < kNumDirections);
  return m <= kHalfCircle ? m : kNumDirections - m;
}

bool is_mirrored(std::size_t m) {
  return m > kHalfCircle;
}

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
  for (std::size_t m = 0; m < kNumDirections; ++m) {
    const RelativeEnergy energy = relative_energy(sea, heading, m);
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
  for (std::size_t m = 0; m < kNumDirections; ++m) {
    const RelativeEnergy energy = relative_energy(sea, heading, m);
    if (energy.is_empty) {
      continue;
    }
    low += (1.0 - bracket->part) * low_encounter_energy(transfer, bracket->lower, m, energy) +
           bracket->part * low_encounter_energy(transfer, bracket->upper, m, energy);
    all = std::accumulate(energy.total.begin(), energy.total.end(), all);
  }
  return all > 0.0 ? low / all : 0.0;
}

}  // namespace quickstrip
