#include "msgs/convert/sea_message.hpp"

#include <array>
#include <cmath>
#include <span>
#include <type_traits>

#include "core/base/check.hpp"
#include "msgs/convert/field_checks.hpp"

namespace quickstrip {
namespace {

constexpr std::array kPeriodKinds{PeriodKind::kPeak, PeriodKind::kMean, PeriodKind::kZeroCrossing};
constexpr std::array kShapes{SpectrumShape::kBretschneider, SpectrumShape::kJonswap, SpectrumShape::kNeumann};

template <typename Kinds>
bool is_known(std::int8_t kind, const Kinds& kinds) {
  return kind >= 0 && static_cast<std::size_t>(kind) < kinds.size();
}

Conversion check_finite(const sea_state_t& m) {
  return all_finite({field("lat_deg", m.lat_deg),
                     field("lon_deg", m.lon_deg),
                     {"hs_m", m.hs_m},
                     {"period_s", m.period_s},
                     {"dir_from_deg", m.dir_from_deg},
                     {"spreading_deg", m.spreading_deg},
                     {"peakedness", m.peakedness},
                     {"hs_std_m", m.hs_std_m},
                     {"period_std_s", m.period_std_s},
                     {"dir_std_deg", m.dir_std_deg}});
}

Conversion check_sea_fields(const sea_state_t& m) {
  using M = sea_state_t;
  if (const Conversion finite = check_finite(m); !finite) {
    return finite;
  }
  if (!is_time(m.utime)) {
    return {Refusal::kTime, "utime"};
  }
  if (const Conversion known =
          only_known_bits(m.valid, bits({M::VALID_SPREADING, M::VALID_SHAPE, M::VALID_PEAKEDNESS,
                                         M::VALID_STD, M::VALID_UNTIL, M::VALID_POSITION}));
      !known) {
    return known;
  }
  if (has(m.valid, M::VALID_UNTIL)) {
    if (const Conversion until = check_valid_until(m.utime, m.valid_until_utime); !until) {
      return until;
    }
  }
  if (has(m.valid, M::VALID_POSITION)) {
    if (const Conversion position = check_position(m.lat_deg, m.lon_deg); !position) {
      return position;
    }
  }
  if (m.num_systems < 1 || m.num_systems > static_cast<int>(kMaxWaveSystems)) {
    return {Refusal::kCount, "num_systems"};
  }
  if (m.source_kind < sea_state_t::SOURCE_NOT_KNOWN || m.source_kind > sea_state_t::SOURCE_MANUAL) {
    return {Refusal::kUnknownKind, "source_kind"};
  }
  return {};
}

Conversion check_system(const sea_state_t& m, int i) {
  if (!(m.hs_m[i] > 0.0 && m.hs_m[i] <= kMaxWaveHeight_m)) {
    return {Refusal::kHeight, "hs_m", i};
  }
  if (!kWavePeriod_s.holds(m.period_s[i])) {
    return {Refusal::kPeriod, "period_s", i};
  }
  if (!is_known(m.period_kind[i], kPeriodKinds)) {
    return {Refusal::kUnknownKind, "period_kind", i};
  }
  if (!is_direction(m.dir_from_deg[i])) {
    return {Refusal::kDirection, "dir_from_deg", i};
  }
  if (has(m.valid, sea_state_t::VALID_SPREADING) && !kSpreading_deg.holds(m.spreading_deg[i])) {
    return {Refusal::kOutOfRange, "spreading_deg", i};
  }
  if (has(m.valid, sea_state_t::VALID_SHAPE) && !is_known(m.shape[i], kShapes)) {
    return {Refusal::kUnknownKind, "shape", i};
  }
  if (has(m.valid, sea_state_t::VALID_PEAKEDNESS) && !kPeakedness.holds(m.peakedness[i])) {
    return {Refusal::kOutOfRange, "peakedness", i};
  }
  if (m.system_kind[i] < sea_state_t::SYSTEM_NOT_KNOWN || m.system_kind[i] > sea_state_t::SYSTEM_SWELL) {
    return {Refusal::kUnknownKind, "system_kind", i};
  }
  if (has(m.valid, sea_state_t::VALID_STD) &&
      !(m.hs_std_m[i] >= 0.0 && m.period_std_s[i] >= 0.0 && m.dir_std_deg[i] >= 0.0)) {
    return {Refusal::kOutOfRange, "hs_std_m, period_std_s or dir_std_deg", i};
  }
  return {};
}

WaveSystem system_of(const sea_state_t& m, int i, std::uint32_t& assumed) {
  WaveSystem system;
  system.hs = m.hs_m[i];
  system.period = m.period_s[i];
  system.period_kind = kPeriodKinds[static_cast<std::size_t>(m.period_kind[i])];
  system.from = {radians(m.dir_from_deg[i])};
  const bool knows_spreading = has(m.valid, sea_state_t::VALID_SPREADING);
  system.spreading = radians(knows_spreading ? m.spreading_deg[i] : kAssumedSpreading_deg);
  const bool knows_shape = has(m.valid, sea_state_t::VALID_SHAPE);
  system.shape = knows_shape ? kShapes[static_cast<std::size_t>(m.shape[i])] : SpectrumShape::kBretschneider;
  const bool knows_peakedness = has(m.valid, sea_state_t::VALID_PEAKEDNESS);
  system.peakedness = knows_peakedness ? m.peakedness[i] : kAssumedPeakedness;
  assumed |= knows_spreading ? 0u : std::uint32_t{kAssumedSpreading};
  assumed |= knows_shape ? 0u : std::uint32_t{kAssumedShape};
  const bool wants_peakedness = system.shape == SpectrumShape::kJonswap && !knows_peakedness;
  assumed |= wants_peakedness ? std::uint32_t{kAssumedPeakednessOfJonswap} : 0u;
  return system;
}

}  // namespace

Conversion to_sea_state(const sea_state_t& message, SeaState& out, std::uint32_t& assumed) {
  if (const Conversion fields = check_sea_fields(message); !fields) {
    return fields;
  }
  SeaState sea;
  std::uint32_t not_given = 0;
  double square_sum = 0.0;
  for (int i = 0; i < message.num_systems; ++i) {
    if (const Conversion system = check_system(message, i); !system) {
      return system;
    }
    QS_CHECK(sea.systems.push_back(system_of(message, i, not_given)));
    square_sum += message.hs_m[i] * message.hs_m[i];
  }
  if (!(std::sqrt(square_sum) <= kMaxWaveHeight_m)) {  // all systems together
    return {Refusal::kHeight, "hs_m"};
  }
  out = sea;
  assumed = not_given;
  return {};
}

Conversion check_forecast(const sea_forecast_t& message) {
  constexpr int kMaxStates = static_cast<int>(std::extent_v<decltype(message.states)>);
  for (const sea_state_t& state : message.states) {  // used or not: NaN is always refused
    if (const Conversion finite = check_finite(state); !finite) {
      return finite;
    }
  }
  if (!is_time(message.utime)) {
    return {Refusal::kTime, "utime"};
  }
  if (message.num_states < 1 || message.num_states > kMaxStates) {
    return {Refusal::kCount, "num_states"};
  }
  SeaState sea;
  std::uint32_t assumed = 0;
  for (int i = 0; i < message.num_states; ++i) {
    if (const Conversion state = to_sea_state(message.states[i], sea, assumed); !state) {
      return {state.refusal, state.field, i};
    }
    if (i > 0 && message.states[i].utime <= message.states[i - 1].utime) {
      return {Refusal::kNotOrdered, "states.utime", i};
    }
  }
  return {};
}

void to_message(const SeaState& sea, sea_state_t& out) {
  out.num_systems = static_cast<std::int8_t>(sea.systems.size());
  out.valid = bits({sea_state_t::VALID_SPREADING, sea_state_t::VALID_SHAPE, sea_state_t::VALID_PEAKEDNESS});
  for (std::size_t i = 0; i < sea.systems.size(); ++i) {
    const WaveSystem& system = sea.systems[i];
    out.hs_m[i] = system.hs;
    out.period_s[i] = system.period;
    out.period_kind[i] = static_cast<std::int8_t>(system.period_kind);
    out.dir_from_deg[i] = degrees(wrap_two_pi(system.from.radians));
    out.spreading_deg[i] = degrees(system.spreading);
    out.shape[i] = static_cast<std::int8_t>(system.shape);
    out.peakedness[i] = system.peakedness;
  }
}

}  // namespace quickstrip
