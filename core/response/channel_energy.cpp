#include "core/response/channel_energy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/check.hpp"
#include "core/sea/dispersion.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kHalfCircle = kNumDirections / 2;
constexpr std::array<std::size_t, 3> kLongitudinalModes = {0, 2, 4};  // surge, heave, pitch

bool is_slow(double omega, double omega_e, double floor) {
  return std::fabs(omega_e) < std::max(floor, kSlowEncounter * omega);
}

struct Coefficient {
  float displacement = 0.0F;
  float acceleration = 0.0F;
};

Coefficient coefficient_of(const LinearForm& form, std::size_t mode) {
  return {static_cast<float>(form.displacement[mode]), static_cast<float>(form.acceleration[mode])};
}

/// What the parts of a channel are put together from: the first motion is put where it belongs, the others
/// are added to it.
enum class Step : std::uint8_t { kPut, kAdd };

// (displacement + omega_e^2 acceleration) times a motion; whole groups.
template <Step step, std::size_t N>
void compose(Coefficient c, const std::array<float, N>& squared, const std::array<float, N>& re_of,
             const std::array<float, N>& im_of, std::size_t n, std::array<float, N>& re,
             std::array<float, N>& im) {
  for (std::size_t f = 0; f < n; f += kLanes) {
    std::array<float, kLanes> sum_re;
    std::array<float, kLanes> sum_im;
    for (std::size_t j = 0; j < kLanes; ++j) {
      const float factor = c.displacement + c.acceleration * squared[f + j];
      const float more_re = factor * re_of[f + j];
      const float more_im = factor * im_of[f + j];
      sum_re[j] = step == Step::kAdd ? re[f + j] + more_re : more_re;
      sum_im[j] = step == Step::kAdd ? im[f + j] + more_im : more_im;
    }
    for (std::size_t j = 0; j < kLanes; ++j) {
      re[f + j] = sum_re[j];
      im[f + j] = sum_im[j];
    }
  }
}

template <std::size_t N>
void compose(Step step, Coefficient c, const std::array<float, N>& squared, const std::array<float, N>& re_of,
             const std::array<float, N>& im_of, std::size_t n, std::array<float, N>& re,
             std::array<float, N>& im) {
  if (step == Step::kPut) {
    compose<Step::kPut>(c, squared, re_of, im_of, n, re, im);
  } else {
    compose<Step::kAdd>(c, squared, re_of, im_of, n, re, im);
  }
}

template <std::size_t N>
void square(const std::array<float, N>& re, const std::array<float, N>& im, std::size_t n,
            std::array<float, N>& out) {
  for (std::size_t f = 0; f < n; ++f) {
    out[f] = re[f] * re[f] + im[f] * im[f];
  }
}

template <std::size_t N>
void multiply_by(const std::array<float, N>& factor, std::size_t n, std::array<float, N>& out) {
  for (std::size_t f = 0; f < n; ++f) {
    out[f] *= factor[f];
  }
}

// Without a branch a frequency: it is what the cycle does for every relative motion.
void raise_by_swell_up(const DynamicSwellUp& swell_up, double speed, const Encounters& encounters,
                       std::size_t n, NodeValues& out) {
  const auto elsewhere = static_cast<float>(swell_up.elsewhere * swell_up.elsewhere);
  if (!swell_up.speeds.holds(speed)) {
    for (std::size_t f = 0; f < n; ++f) {
      out[f] *= elsewhere;
    }
    return;
  }
  const auto from = static_cast<float>(swell_up.frequencies.from);
  const auto to = static_cast<float>(swell_up.frequencies.to);
  const auto slope = static_cast<float>(swell_up.by_frequency);
  for (std::size_t f = 0; f < n; ++f) {
    const float frequency = encounters.magnitude[f];
    const float factor = 1.0F + slope * frequency;
    const float is_above = static_cast<float>(frequency >= from);
    const float is_below = static_cast<float>(frequency <= to);
    out[f] *= elsewhere + (is_above * is_below) * (factor * factor - elsewhere);
  }
}

void put_wave(const WaveThere& there, ChannelPart& out) {
  const float side = there.is_conjugate ? -1.0F : 1.0F;
  out.re = there.wave.re;
  for (std::size_t f = 0; f < kMaxFrequencies; ++f) {
    out.im[f] = side * there.wave.im[f];
  }
}

// Of a channel that none of these motions moves.
void put_nothing(ChannelPart& out) {
  out.re.fill(0.0F);
  out.im.fill(0.0F);
  out.point_re.fill(0.0F);
  out.point_im.fill(0.0F);
}

template <std::size_t N>
void even_and_odd(const std::array<float, N>& a_re, const std::array<float, N>& a_im,
                  const std::array<float, N>& b_re, const std::array<float, N>& b_im, std::size_t n,
                  std::array<float, N>& even, std::array<float, N>& odd) {
  for (std::size_t f = 0; f < n; ++f) {
    even[f] = (a_re[f] * a_re[f] + a_im[f] * a_im[f]) + (b_re[f] * b_re[f] + b_im[f] * b_im[f]);
    odd[f] = 2.0F * (a_re[f] * b_re[f] + a_im[f] * b_im[f]);
  }
}

// What fills the last group weighs nothing, and must be a number.
void close_points(std::size_t num_points, ChannelValues& out) {
  std::fill(out.points.begin() + static_cast<std::ptrdiff_t>(num_points),
            out.points.begin() + static_cast<std::ptrdiff_t>(whole_lanes(num_points)), 0.0F);
}

// What squares are multiplied by: of a velocity, and of relative motion where the water swells up.
void raise(const MetWaves& met, const Channel& channel, ChannelValues& out) {
  const std::size_t n = whole_lanes(met.transfer.num_frequencies);
  if (channel.form.wave > 0.0) {
    raise_by_swell_up(channel.dynamic_swell_up, met.transfer.speeds[met.speed], met.encounters, n, out.nodes);
  }
  if (channel.is_rate) {
    multiply_by(met.encounters.squared, n, out.nodes);
    multiply_by(met.encounters.squared_at_points, whole_lanes(met.peak().num_points), out.points);
  }
}

}  // namespace

EncounterAngle relative_direction(std::size_t m) {
  const double mu = solved_angle(solved_direction(m)).radians;
  return {is_mirrored(m) ? -mu : mu};
}

std::size_t solved_direction(std::size_t m) {
  QS_CHECK(m < kNumDirections);
  return m <= kHalfCircle ? m : kNumDirections - m;
}

bool is_mirrored(std::size_t m) {
  return m > kHalfCircle;
}

void list_slow_waves(const TransferFunctions& transfer, const Encounters& encounters, NodeValues& out) {
  for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
    out[f] = is_slow(transfer.omega[f], encounters.frequency[f], transfer.encounter_floor[f]) ? 1.0F : 0.0F;
  }
}

void list_encounters(const TransferFunctions& transfer, std::size_t speed, std::size_t solved_m,
                     Encounters& out) {
  out.low = {};
  const double slope = transfer.speeds[speed] * std::cos(relative_direction(solved_m).radians);
  for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
    out.frequency[f] = transfer.omega[f] - transfer.wave_number[f] * slope;
    out.squared[f] = static_cast<float>(out.frequency[f] * out.frequency[f]);
    out.magnitude[f] = static_cast<float>(std::fabs(out.frequency[f]));
    const bool is_low = std::fabs(out.frequency[f]) < transfer.encounter_floor[f];
    out.is_low[f] = is_low ? 1.0F : 0.0F;
    if (is_low) {
      const LaneRange here = lanes_that_hold(f, f);
      out.low = {out.low.is_empty() ? here.first : out.low.first, here.end};
    }
  }
  const RollPeak& peak = transfer.peak[speed][solved_m];
  for (std::size_t p = 0; p < peak.num_points; ++p) {
    const auto omega = static_cast<double>(peak.omega[p]);
    out.at_points[p] = omega - wave_number(omega, transfer.gravity) * slope;
    out.squared_at_points[p] = static_cast<float>(out.at_points[p] * out.at_points[p]);
  }
}

SlowEncounters find_slow_encounters(const TransferFunctions& transfer, std::size_t speed) {
  SlowEncounters out;
  for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
    const double slope = transfer.speeds[speed] * std::cos(solved_angle(m).radians);
    for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
      const double met = transfer.omega[f] - transfer.wave_number[f] * slope;
      out.has_low = out.has_low || std::fabs(met) < transfer.encounter_floor[f];
      out.has_slow = out.has_slow || is_slow(transfer.omega[f], met, transfer.encounter_floor[f]);
    }
  }
  return out;
}

// Between the frequencies, on a straight line.
void list_longitudinal(const TransferFunctions& transfer, std::size_t speed, std::size_t solved_m,
                       const std::array<double, kMaxPeakPoints>& place, LongitudinalMotions& out) {
  const MotionRow& row = transfer.row[speed][solved_m];
  const RollPeak& peak = transfer.peak[speed][solved_m];
  for (const PeakInterval& interval : peak.intervals) {
    const std::size_t node = interval.node;
    for (std::size_t p = interval.first; p < std::size_t{interval.first} + interval.count; ++p) {
      const auto t = static_cast<float>(place[p]);
      for (std::size_t i = 0; i < kLongitudinalModes.size(); ++i) {
        const auto& re = row.re[kLongitudinalModes[i]];
        const auto& im = row.im[kLongitudinalModes[i]];
        out.re[i][p] = re[node] + t * (re[node + 1] - re[node]);
        out.im[i][p] = im[node] + t * (im[node + 1] - im[node]);
      }
    }
  }
}

void longitudinal_part(const MetWaves& met, const Channel& channel, const WaveThere& wave, ChannelPart& out) {
  const Encounters& encounters = met.encounters;
  const std::size_t n = whole_lanes(met.transfer.num_frequencies);
  const std::size_t num_points = feels_roll(channel) ? whole_lanes(met.peak().num_points) : 0;
  QS_CHECK(num_points == 0 || channel.form.wave == 0.0);
  Step step = Step::kPut;
  if (channel.form.wave > 0.0) {
    put_wave(wave, out);
    step = Step::kAdd;
  } else if (!moves_lengthwise(channel)) {
    put_nothing(out);
  }
  for (std::size_t i = 0; i < kLongitudinalModes.size(); ++i) {
    const std::size_t mode = kLongitudinalModes[i];
    if (!channel.form.has(mode)) {
      continue;
    }
    const Coefficient c = coefficient_of(channel.form, mode);
    compose(step, c, encounters.squared, met.row().re[mode], met.row().im[mode], n, out.re, out.im);
    compose(step, c, encounters.squared_at_points, met.longitudinal.re[i], met.longitudinal.im[i], num_points,
            out.point_re, out.point_im);
    step = Step::kAdd;
  }
}

void lateral_part(const MetWaves& met, const Channel& channel, const LateralMotions* damped,
                  ChannelPart& out) {
  const Encounters& encounters = met.encounters;
  const RollPeak& peak = met.peak();
  const std::size_t n = whole_lanes(met.transfer.num_frequencies);
  const std::size_t num_points = whole_lanes(peak.num_points);
  if (!feels_roll(channel)) {
    put_nothing(out);
  }
  Step step = Step::kPut;
  for (std::size_t i = 0; i < kPeakModes.size(); ++i) {
    const std::size_t mode = kPeakModes[i];
    if (!channel.form.has(mode)) {
      continue;
    }
    const Coefficient c = coefficient_of(channel.form, mode);
    compose(step, c, encounters.squared, damped != nullptr ? damped->re[i] : met.row().re[mode],
            damped != nullptr ? damped->im[i] : met.row().im[mode], n, out.re, out.im);
    compose(step, c, encounters.squared_at_points, damped != nullptr ? damped->point_re[i] : peak.re[i],
            damped != nullptr ? damped->point_im[i] : peak.im[i], num_points, out.point_re, out.point_im);
    step = Step::kAdd;
  }
}

void list_square(const MetWaves& met, const Channel& channel, const ChannelPart& part, ChannelValues& out) {
  const std::size_t num_points = met.peak().num_points;
  out.has_points = feels_roll(channel) && num_points > 0;
  square(part.re, part.im, whole_lanes(met.transfer.num_frequencies), out.nodes);
  if (out.has_points) {
    square(part.point_re, part.point_im, whole_lanes(num_points), out.points);
    close_points(num_points, out);
  }
  raise(met, channel, out);
}

void list_even_odd(const MetWaves& met, const Channel& channel, const ChannelPart& longitudinal,
                   const ChannelPart& lateral, ChannelValues& even, ChannelValues& odd) {
  const ChannelPart& a = longitudinal;
  const ChannelPart& b = lateral;
  const std::size_t num_points = met.peak().num_points;
  even.has_points = num_points > 0;
  odd.has_points = num_points > 0;
  even_and_odd(a.re, a.im, b.re, b.im, whole_lanes(met.transfer.num_frequencies), even.nodes, odd.nodes);
  even_and_odd(a.point_re, a.point_im, b.point_re, b.point_im, whole_lanes(num_points), even.points,
               odd.points);
  close_points(num_points, even);
  close_points(num_points, odd);
  raise(met, channel, even);
  raise(met, channel, odd);
}

}  // namespace quickstrip
