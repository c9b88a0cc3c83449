#include <cmath>

#include "core/base/check.hpp"
#include "msgs/convert/field_checks.hpp"
#include "msgs/convert/sea_message.hpp"

namespace quickstrip {
namespace {

constexpr double kDirectionSlack_deg = 0.01;  // rounding of thirds of a degree on the wire
// Density per Hz and degree against per rad/s and radian: domega dtheta = 2 pi df * pi/180 d(deg).
constexpr double kPerHzDegree = kTwoPi * kPi / 180.0;

Conversion check_spectrum_header(const wave_spectrum_t& m) {
  const Conversion finite = all_finite({field("lat_deg", m.lat_deg),
                                        field("lon_deg", m.lon_deg),
                                        field("hs_std_m", m.hs_std_m),
                                        {"frequency_hz", m.frequency_hz},
                                        {"dir_from_deg", m.dir_from_deg}});
  if (!finite) {
    return finite;
  }
  if (!is_time(m.utime)) {
    return {Refusal::kTime, "utime"};
  }
  using M = wave_spectrum_t;
  if (const Conversion known =
          only_known_bits(m.valid, bits({M::VALID_UNTIL, M::VALID_POSITION, M::VALID_STD}));
      !known) {
    return known;
  }
  if (m.num_frequencies < 3 || m.num_frequencies > static_cast<int>(kMaxSpectrumFrequencies)) {
    return {Refusal::kCount, "num_frequencies"};
  }
  if (m.num_directions < 4 || m.num_directions > static_cast<int>(kMaxSpectrumDirections)) {
    return {Refusal::kCount, "num_directions"};
  }
  if (m.source_kind < wave_spectrum_t::SOURCE_NOT_KNOWN || m.source_kind > wave_spectrum_t::SOURCE_MANUAL) {
    return {Refusal::kUnknownKind, "source_kind"};
  }
  return {};
}

Conversion check_optional(const wave_spectrum_t& m) {
  if (has(m.valid, wave_spectrum_t::VALID_STD) && !(m.hs_std_m >= 0.0)) {
    return {Refusal::kOutOfRange, "hs_std_m"};
  }
  if (has(m.valid, wave_spectrum_t::VALID_UNTIL)) {
    if (const Conversion until = check_valid_until(m.utime, m.valid_until_utime); !until) {
      return until;
    }
  }
  return has(m.valid, wave_spectrum_t::VALID_POSITION) ? check_position(m.lat_deg, m.lon_deg) : Conversion{};
}

Conversion check_axes(const wave_spectrum_t& m) {
  for (int f = 0; f < m.num_frequencies; ++f) {
    if (!kWaveFrequency_hz.holds(m.frequency_hz[f])) {
      return {Refusal::kOutOfRange, "frequency_hz", f};
    }
    if (f > 0 && !(m.frequency_hz[f] > m.frequency_hz[f - 1])) {
      return {Refusal::kNotOrdered, "frequency_hz", f};
    }
  }
  const double step = 360.0 / m.num_directions;
  for (int d = 0; d < m.num_directions; ++d) {
    if (!is_direction(m.dir_from_deg[d])) {
      return {Refusal::kDirection, "dir_from_deg", d};
    }
    const double off = std::remainder(m.dir_from_deg[d] - m.dir_from_deg[0] - d * step, 360.0);
    if (!(std::abs(off) <= kDirectionSlack_deg)) {
      return {Refusal::kNotOrdered, "dir_from_deg", d};
    }
  }
  return {};
}

// All of the array, used or not: contract §5, NaN is always refused.
Conversion check_density(const wave_spectrum_t& m) {
  for (int f = 0; f < static_cast<int>(kMaxSpectrumFrequencies); ++f) {
    for (int d = 0; d < static_cast<int>(kMaxSpectrumDirections); ++d) {
      const float density = m.density_m2_hz_deg[f][d];
      if (!std::isfinite(density)) {
        return {Refusal::kNotFinite, "density_m2_hz_deg", f};
      }
      if (!(density >= 0.0F) && f < m.num_frequencies && d < m.num_directions) {
        return {Refusal::kOutOfRange, "density_m2_hz_deg", f};
      }
    }
  }
  return {};
}

/// Significant height by trapezoids in frequency.
Conversion check_height(const wave_spectrum_t& m) {
  double m0 = 0.0;
  double previous = 0.0;
  for (int f = 0; f < m.num_frequencies; ++f) {
    double row = 0.0;
    for (int d = 0; d < m.num_directions; ++d) {
      row += static_cast<double>(m.density_m2_hz_deg[f][d]) * (360.0 / m.num_directions);
    }
    m0 += f > 0 ? 0.5 * (previous + row) * (m.frequency_hz[f] - m.frequency_hz[f - 1]) : 0.0;
    previous = row;
  }
  if (!(m0 > 0.0)) {
    return {Refusal::kEmpty, "density_m2_hz_deg"};
  }
  if (!(4.0 * std::sqrt(m0) <= kMaxWaveHeight_m)) {
    return {Refusal::kHeight, "density_m2_hz_deg"};
  }
  return {};
}

}  // namespace

Conversion to_directional_spectrum(const wave_spectrum_t& message, DirectionalSpectrum& out) {
  for (const auto check : {check_spectrum_header, check_optional, check_axes, check_density, check_height}) {
    if (const Conversion result = check(message); !result) {
      return result;
    }
  }
  const auto num_frequencies = static_cast<std::size_t>(message.num_frequencies);
  const auto num_directions = static_cast<std::size_t>(message.num_directions);
  std::size_t first = 0;  // of the smallest direction, so that they come out increasing
  for (std::size_t d = 1; d < num_directions; ++d) {
    first = message.dir_from_deg[d] < message.dir_from_deg[first] ? d : first;
  }
  QS_CHECK(out.frequencies.resize(num_frequencies) && out.directions.resize(num_directions));
  for (std::size_t d = 0; d < num_directions; ++d) {
    out.directions[d] = radians(message.dir_from_deg[(first + d) % num_directions]);
  }
  for (std::size_t f = 0; f < num_frequencies; ++f) {
    out.frequencies[f] = kTwoPi * message.frequency_hz[f];
    out.density[f].fill(0.0);
    for (std::size_t d = 0; d < num_directions; ++d) {
      out.density[f][d] =
          static_cast<double>(message.density_m2_hz_deg[f][(first + d) % num_directions]) / kPerHzDegree;
    }
  }
  for (std::size_t f = num_frequencies; f < kMaxSpectrumFrequencies; ++f) {
    out.density[f].fill(0.0);
  }
  return {};
}

void to_message(const DirectionalSpectrum& spectrum, wave_spectrum_t& out) {
  out.num_frequencies = static_cast<std::int16_t>(spectrum.frequencies.size());
  out.num_directions = static_cast<std::int16_t>(spectrum.directions.size());
  for (std::size_t d = 0; d < spectrum.directions.size(); ++d) {
    out.dir_from_deg[d] = degrees(wrap_two_pi(spectrum.directions[d]));
  }
  for (std::size_t f = 0; f < spectrum.frequencies.size(); ++f) {
    out.frequency_hz[f] = spectrum.frequencies[f] / kTwoPi;
    for (std::size_t d = 0; d < spectrum.directions.size(); ++d) {
      out.density_m2_hz_deg[f][d] = static_cast<float>(spectrum.density[f][d] * kPerHzDegree);
    }
  }
}

}  // namespace quickstrip
