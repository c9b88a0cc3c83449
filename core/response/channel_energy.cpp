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

// Of a form on one side of the ship.
struct Coefficient {
  double displacement = 0.0;
  double acceleration = 0.0;
  [[nodiscard]] bool is_absent() const { return displacement == 0.0 && acceleration == 0.0; }
};

Coefficient coefficient_of(const LinearForm& form, std::size_t mode, bool mirrored) {
  const double sign = mirrored && is_lateral(mode) ? -1.0 : 1.0;
  return {sign * form.displacement[mode], sign * form.acceleration[mode]};
}

bool has_motion(const LinearForm& form, bool lateral) {
  for (std::size_t mode = 0; mode < 6; ++mode) {
    if (is_lateral(mode) == lateral && !coefficient_of(form, mode, false).is_absent()) {
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

void node_energies(const TransferFunctions& transfer, std::size_t speed, std::size_t m,
                   const Channel& channel, const LateralMotions* damped, const Encounters& encounters,
                   const IncidentWave& wave, NodeValues& out) {
  const std::size_t n = transfer.num_frequencies;
  const MotionRow& row = transfer.row[speed][solved_direction(m)];
  NodeValues re{};
  NodeValues im{};
  if (channel.form.wave > 0.0) {
    re = wave.re;
    im = wave.im;
  }
  for (std::size_t mode = 0; mode < 6; ++mode) {
    const Coefficient c = coefficient_of(channel.form, mode, is_mirrored(m));
    if (c.is_absent()) {
      continue;
    }
    const bool is_damped = damped != nullptr && is_lateral(mode);
    add_motion(c, encounters.frequency, is_damped ? damped->re[mode / 2] : row.re[mode],
               is_damped ? damped->im[mode / 2] : row.im[mode], n, re, im);
  }
  square(re, im, n, out);
  if (channel.form.wave > 0.0) {
    raise_by_swell_up(channel.dynamic_swell_up, transfer.speeds[speed], encounters.frequency, n, out);
  }
  if (channel.is_rate) {
    multiply_by_square(encounters.frequency, n, out);
  }
}

void point_energies(const TransferFunctions& transfer, std::size_t speed, std::size_t m,
                    const Channel& channel, const LateralMotions* damped, const Encounters& encounters,
                    PointValues& out) {
  QS_CHECK(channel.form.wave == 0.0);
  const std::size_t solved_m = solved_direction(m);
  const RollPeak& peak = transfer.peak[speed][solved_m];
  const MotionRow& row = transfer.row[speed][solved_m];
  PointValues re{};
  PointValues im{};
  for (std::size_t mode = 0; mode < 6; ++mode) {
    const Coefficient c = coefficient_of(channel.form, mode, is_mirrored(m));
    if (c.is_absent()) {
      continue;
    }
    if (is_lateral(mode)) {
      const auto& re_of = damped != nullptr ? damped->point_re : peak.re;
      const auto& im_of = damped != nullptr ? damped->point_im : peak.im;
      add_motion(c, encounters.at_points, re_of[mode / 2], im_of[mode / 2], peak.num_points, re, im);
      continue;
    }
    PointValues re_of{};
    PointValues im_of{};
    to_points(transfer, peak, row.re[mode], re_of);
    to_points(transfer, peak, row.im[mode], im_of);
    add_motion(c, encounters.at_points, re_of, im_of, peak.num_points, re, im);
  }
  square(re, im, peak.num_points, out);
  if (channel.is_rate) {
    multiply_by_square(encounters.at_points, peak.num_points, out);
  }
}

}  // namespace quickstrip
