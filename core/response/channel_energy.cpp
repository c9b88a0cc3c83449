#include "core/response/channel_energy.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/base/check.hpp"
#include "core/response/relative_motion.hpp"
#include "core/sea/dispersion.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kHalfCircle = kNumDirections / 2;

bool is_lateral(std::size_t mode) {
  return mode % 2 == 1;  // sway, roll, yaw
}

struct Coefficient {
  double displacement = 0.0;
  double acceleration = 0.0;
  [[nodiscard]] bool is_absent() const { return displacement == 0.0 && acceleration == 0.0; }
};

Coefficient coefficient_of(const LinearForm& form, std::size_t mode) {
  return {form.displacement[mode], form.acceleration[mode]};
}

bool has_motion(const LinearForm& form, bool lateral) {
  for (std::size_t mode = 0; mode < 6; ++mode) {
    if (is_lateral(mode) == lateral && !coefficient_of(form, mode).is_absent()) {
      return true;
    }
  }
  return false;
}

// Adds (displacement + omega_e^2 acceleration) times a motion, in place.
template <std::size_t N, typename Motion>
void add_motion(const Coefficient& c, const std::array<double, N>& omega_e, const Motion& re_of,
                const Motion& im_of, std::size_t n, std::array<double, N>& re, std::array<double, N>& im) {
  for (std::size_t f = 0; f < n; ++f) {
    const double factor = c.displacement + c.acceleration * (omega_e[f] * omega_e[f]);
    re[f] += factor * static_cast<double>(re_of[f]);
    im[f] += factor * static_cast<double>(im_of[f]);
  }
}

template <std::size_t N>
void square(const std::array<double, N>& re, const std::array<double, N>& im, std::size_t n,
            std::array<double, N>& out) {
  for (std::size_t f = 0; f < n; ++f) {
    out[f] = re[f] * re[f] + im[f] * im[f];
  }
}

template <std::size_t N>
void multiply_by_square(const std::array<double, N>& factor, std::size_t n, std::array<double, N>& out) {
  for (std::size_t f = 0; f < n; ++f) {
    out[f] *= factor[f] * factor[f];
  }
}

// Without a branch a frequency: it is what the cycle does for every relative motion.
void raise_by_swell_up(const DynamicSwellUp& swell_up, double speed, const NodeValues& omega_e, std::size_t n,
                       NodeValues& out) {
  const double elsewhere = swell_up.elsewhere * swell_up.elsewhere;
  if (!swell_up.speeds.holds(speed)) {
    for (std::size_t f = 0; f < n; ++f) {
      out[f] *= elsewhere;
    }
    return;
  }
  const Interval range = swell_up.frequencies;
  const double slope = swell_up.by_frequency;
  for (std::size_t f = 0; f < n; ++f) {
    const double frequency = std::fabs(omega_e[f]);
    const double factor = 1.0 + slope * frequency;
    const double within = frequency >= range.from ? factor * factor : elsewhere;
    out[f] *= frequency <= range.to ? within : elsewhere;
  }
}

// Between the frequencies, on a straight line.
void to_points(const TransferFunctions& transfer, const RollPeak& peak, const MotionRow::ByFrequency& values,
               PointValues& out) {
  for (const PeakInterval& interval : peak.intervals) {
    const std::size_t i = interval.node;
    const double from = transfer.omega[i];
    const double slope = (static_cast<double>(values[i + 1]) - static_cast<double>(values[i])) /
                         (transfer.omega[i + 1] - from);
    for (std::size_t p = interval.first; p < std::size_t{interval.first} + interval.count; ++p) {
      out[p] = static_cast<double>(values[i]) + slope * (static_cast<double>(peak.omega[p]) - from);
    }
  }
}

void start(const IncidentWave* wave, bool has_points, ChannelPart& out) {
  if (wave != nullptr) {
    out.re = wave->re;
    out.im = wave->im;
  } else {
    out.re.fill(0.0);
    out.im.fill(0.0);
  }
  if (has_points) {
    out.point_re.fill(0.0);
    out.point_im.fill(0.0);
  }
}

template <std::size_t N>
void even_and_odd(const std::array<double, N>& a_re, const std::array<double, N>& a_im,
                  const std::array<double, N>& b_re, const std::array<double, N>& b_im, std::size_t n,
                  std::array<double, N>& even, std::array<double, N>& odd) {
  for (std::size_t f = 0; f < n; ++f) {
    even[f] = (a_re[f] * a_re[f] + a_im[f] * a_im[f]) + (b_re[f] * b_re[f] + b_im[f] * b_im[f]);
    odd[f] = 2.0 * (a_re[f] * b_re[f] + a_im[f] * b_im[f]);
  }
}

// What squares are multiplied by: of a velocity, and of relative motion where the water swells up.
void raise(const MetWaves& met, const Channel& channel, ChannelValues& out) {
  const std::size_t n = met.transfer.num_frequencies;
  if (channel.form.wave > 0.0) {
    raise_by_swell_up(channel.dynamic_swell_up, met.transfer.speeds[met.speed], met.encounters.frequency, n,
                      out.nodes);
  }
  if (channel.is_rate) {
    multiply_by_square(met.encounters.frequency, n, out.nodes);
    multiply_by_square(met.encounters.at_points, met.peak().num_points, out.points);
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

bool feels_roll(const Channel& channel) {
  return has_motion(channel.form, true);
}

bool is_symmetric(const Channel& channel) {
  return !feels_roll(channel) || !(has_motion(channel.form, false) || channel.form.wave != 0.0);
}

namespace {

bool is_slow(double omega, double omega_e, double floor) {
  return std::fabs(omega_e) < std::max(floor, kSlowEncounter * omega);
}

}  // namespace

void list_slow_waves(const TransferFunctions& transfer, const Encounters& encounters, NodeValues& out) {
  for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
    out[f] = is_slow(transfer.omega[f], encounters.frequency[f], transfer.encounter_floor[f]) ? 1.0 : 0.0;
  }
}

void list_encounters(const TransferFunctions& transfer, std::size_t speed, std::size_t solved_m,
                     Encounters& out) {
  out.has_low = false;
  out.has_slow = false;
  const double slope = transfer.speeds[speed] * std::cos(relative_direction(solved_m).radians);
  for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
    out.frequency[f] = transfer.omega[f] - transfer.wave_number[f] * slope;
    const bool is_low = std::fabs(out.frequency[f]) < transfer.encounter_floor[f];
    out.low[f] = is_low ? 1.0 : 0.0;
    out.has_low = out.has_low || is_low;
    out.has_slow = out.has_slow || is_slow(transfer.omega[f], out.frequency[f], transfer.encounter_floor[f]);
  }
  const RollPeak& peak = transfer.peak[speed][solved_m];
  for (std::size_t p = 0; p < peak.num_points; ++p) {
    const auto omega = static_cast<double>(peak.omega[p]);
    out.at_points[p] = omega - wave_number(omega, transfer.gravity) * slope;
  }
}

void list_incident_wave(const TransferFunctions& transfer, std::size_t solved_m, const Position& position,
                        IncidentWave& out) {
  QS_CHECK(position.y == 0.0);
  const EncounterAngle mu = relative_direction(solved_m);
  for (std::size_t f = 0; f < transfer.num_frequencies; ++f) {
    const std::complex<double> wave = incident_wave(position, transfer.wave_number[f], mu);
    out.re[f] = wave.real();
    out.im[f] = wave.imag();
  }
}

void longitudinal_part(const MetWaves& met, const Channel& channel, const IncidentWave& wave,
                       ChannelPart& out) {
  const std::size_t n = met.transfer.num_frequencies;
  const RollPeak& peak = met.peak();
  const bool has_points = feels_roll(channel) && peak.num_points > 0;
  QS_CHECK(!has_points || channel.form.wave == 0.0);
  start(channel.form.wave > 0.0 ? &wave : nullptr, has_points, out);
  for (const std::size_t mode : {0U, 2U, 4U}) {
    const Coefficient c = coefficient_of(channel.form, mode);
    if (c.is_absent()) {
      continue;
    }
    add_motion(c, met.encounters.frequency, met.row().re[mode], met.row().im[mode], n, out.re, out.im);
    if (has_points) {
      PointValues re_of;
      PointValues im_of;
      to_points(met.transfer, peak, met.row().re[mode], re_of);
      to_points(met.transfer, peak, met.row().im[mode], im_of);
      add_motion(c, met.encounters.at_points, re_of, im_of, peak.num_points, out.point_re, out.point_im);
    }
  }
}

void lateral_part(const MetWaves& met, const Channel& channel, const LateralMotions* damped,
                  ChannelPart& out) {
  const RollPeak& peak = met.peak();
  start(nullptr, peak.num_points > 0, out);
  for (std::size_t i = 0; i < kPeakModes.size(); ++i) {
    const std::size_t mode = kPeakModes[i];
    const Coefficient c = coefficient_of(channel.form, mode);
    if (c.is_absent()) {
      continue;
    }
    add_motion(c, met.encounters.frequency, damped != nullptr ? damped->re[i] : met.row().re[mode],
               damped != nullptr ? damped->im[i] : met.row().im[mode], met.transfer.num_frequencies, out.re,
               out.im);
    add_motion(c, met.encounters.at_points, damped != nullptr ? damped->point_re[i] : peak.re[i],
               damped != nullptr ? damped->point_im[i] : peak.im[i], peak.num_points, out.point_re,
               out.point_im);
  }
}

void list_square(const MetWaves& met, const Channel& channel, const ChannelPart& part, ChannelValues& out) {
  const std::size_t num_points = met.peak().num_points;
  out.has_points = feels_roll(channel) && num_points > 0;
  square(part.re, part.im, met.transfer.num_frequencies, out.nodes);
  if (out.has_points) {
    square(part.point_re, part.point_im, num_points, out.points);
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
  even_and_odd(a.re, a.im, b.re, b.im, met.transfer.num_frequencies, even.nodes, odd.nodes);
  even_and_odd(a.point_re, a.point_im, b.point_re, b.point_im, num_points, even.points, odd.points);
  raise(met, channel, even);
  raise(met, channel, odd);
}

}  // namespace quickstrip
