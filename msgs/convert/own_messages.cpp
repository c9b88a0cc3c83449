#include "msgs/convert/own_messages.hpp"

#include <cmath>
#include <span>
#include <type_traits>

#include "msgs/convert/field_checks.hpp"
#include "msgs/convert/ranges.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr int kMaxListedCriteria = 32;  // of limits_t and advice_t
constexpr int kMaxListedChanges = 8;    // of advice_t
constexpr int kMaxVerdict = advice_t::VERDICT_EXCEEDED;
constexpr int kGridSpeeds = 25;
constexpr int kGridHeadings = 72;

bool is_verdict(int verdict) {
  return verdict >= 0 && verdict <= kMaxVerdict;
}

/// -1 is none.
bool is_criterion(int index) {
  return index >= -1 && index < kMaxListedCriteria;
}

Conversion check_finite(const advice_t& m) {
  return all_finite({field("heading_deg", m.heading_deg),
                     field("speed_kn", m.speed_kn),
                     field("governing_value", m.governing_value),
                     field("governing_limit", m.governing_limit),
                     field("margin", m.margin),
                     field("roll_rms_deg", m.roll_rms_deg),
                     field("bridge_vertical_rms_m_s2", m.bridge_vertical_rms_m_s2),
                     field("roll_exceedance", m.roll_exceedance),
                     field("slam_probability", m.slam_probability),
                     field("slams_per_hour", m.slams_per_hour),
                     field("wetness_probability", m.wetness_probability),
                     {"criterion_value", m.criterion_value},
                     {"change_to_heading_deg", m.change_to_heading_deg},
                     {"change_to_speed_kn", m.change_to_speed_kn},
                     {"change_heading_deg", m.change_heading_deg},
                     {"change_speed_kn", m.change_speed_kn},
                     {"change_effort", m.change_effort},
                     {"change_margin", m.change_margin},
                     {"change_roll_rms_deg", m.change_roll_rms_deg},
                     {"change_bridge_vertical_rms_m_s2", m.change_bridge_vertical_rms_m_s2},
                     {"change_roll_exceedance", m.change_roll_exceedance},
                     {"change_slam_probability", m.change_slam_probability},
                     {"change_slams_per_hour", m.change_slams_per_hour},
                     {"change_wetness_probability", m.change_wetness_probability},
                     {"change_speed_loss_kn", m.change_speed_loss_kn}});
}

Conversion check_cell(const grid_t& m, int speed, int heading) {
  if (!is_verdict(m.verdict[speed][heading])) {
    return {Refusal::kUnknownKind, "verdict", speed};
  }
  if (!is_criterion(m.governing[speed][heading])) {
    return {Refusal::kCount, "governing", speed};
  }
  return {};
}

}  // namespace

Conversion check_advice(const advice_t& message) {
  if (const Conversion finite = check_finite(message); !finite) {
    return finite;
  }
  if (!is_time(message.utime)) {
    return {Refusal::kTime, "utime"};
  }
  if (message.num_criteria < 0 || message.num_criteria > kMaxListedCriteria) {
    return {Refusal::kCount, "num_criteria"};
  }
  if (message.num_changes < 0 || message.num_changes > kMaxListedChanges) {
    return {Refusal::kCount, "num_changes"};
  }
  if (!is_verdict(message.verdict)) {
    return {Refusal::kUnknownKind, "verdict"};
  }
  if (!is_criterion(message.governing)) {
    return {Refusal::kCount, "governing"};
  }
  for (int i = 0; i < message.num_changes; ++i) {
    if (!is_verdict(message.change_verdict[i])) {
      return {Refusal::kUnknownKind, "change_verdict", i};
    }
    if (!is_criterion(message.change_governing[i])) {
      return {Refusal::kCount, "change_governing", i};
    }
  }
  return {};
}

Conversion check_grid(const grid_t& message) {
  static_assert(std::extent_v<decltype(message.verdict), 0> == kGridSpeeds);
  static_assert(std::extent_v<decltype(message.verdict), 1> == kGridHeadings);
  if (!is_time(message.utime)) {
    return {Refusal::kTime, "utime"};
  }
  if (message.num_speeds < 0 || message.num_speeds > kGridSpeeds) {
    return {Refusal::kCount, "num_speeds"};
  }
  if (message.num_headings < 0 || message.num_headings > kGridHeadings ||
      (message.num_speeds > 0 && message.num_headings == 0)) {
    return {Refusal::kCount, "num_headings"};
  }
  for (int s = 0; s < kGridSpeeds; ++s) {
    if (!std::isfinite(message.speed_kn[s])) {
      return {Refusal::kNotFinite, "speed_kn", s};
    }
    if (s < message.num_speeds && !kGridSpeed_kn.holds(static_cast<double>(message.speed_kn[s]))) {
      return {Refusal::kOutOfRange, "speed_kn", s};
    }
    if (s > 0 && s < message.num_speeds && !(message.speed_kn[s] > message.speed_kn[s - 1])) {
      return {Refusal::kNotOrdered, "speed_kn", s};
    }
  }
  for (int s = 0; s < message.num_speeds; ++s) {
    for (int h = 0; h < message.num_headings; ++h) {
      if (const Conversion cell = check_cell(message, s, h); !cell) {
        return cell;
      }
    }
  }
  return {};
}

Conversion check_limits(const limits_t& message) {
  static_assert(std::extent_v<decltype(message.limit)> == kMaxListedCriteria);
  if (const Conversion finite =
          all_finite({{"limit", message.limit}, {"caution_fraction", message.caution_fraction}});
      !finite) {
    return finite;
  }
  if (!is_time(message.utime)) {
    return {Refusal::kTime, "utime"};
  }
  return message.num_criteria >= 0 && message.num_criteria <= kMaxListedCriteria
             ? Conversion{}
             : Conversion{Refusal::kCount, "num_criteria"};
}

}  // namespace quickstrip
