#include "msgs/convert/received_checks.hpp"

#include <span>

#include "msgs/convert/field_checks.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr int kMaxAccelerometers = 4;
constexpr double kDay_s = 86'400.0;
constexpr Range kMeasuredPeriod_s{0.0, 200.0};
constexpr Range kMeasuredRms_deg{0.0, 90.0};
constexpr Range kMeasuredMean_deg{-90.0, 90.0};
constexpr Range kMeasuredHeave_m{0.0, 30.0};
constexpr Range kMeasuredAcceleration_m_s2{0.0, 50.0};
constexpr std::int32_t kMotionBits = 31;  // VALID_ROLL ... VALID_MAXIMA
static_assert(motion_t::VALID_MAXIMA * 2 - 1 == kMotionBits);

Conversion check_finite(const motion_t& m) {
  return all_finite({field("window_s", m.window_s),
                     field("roll_rms_deg", m.roll_rms_deg),
                     field("roll_zero_crossing_s", m.roll_zero_crossing_s),
                     field("pitch_rms_deg", m.pitch_rms_deg),
                     field("pitch_zero_crossing_s", m.pitch_zero_crossing_s),
                     field("heave_rms_m", m.heave_rms_m),
                     field("heave_zero_crossing_s", m.heave_zero_crossing_s),
                     field("mean_heel_deg", m.mean_heel_deg),
                     field("mean_trim_deg", m.mean_trim_deg),
                     field("roll_max_deg", m.roll_max_deg),
                     field("pitch_max_deg", m.pitch_max_deg),
                     {"x_m", m.x_m},
                     {"y_m", m.y_m},
                     {"z_m", m.z_m},
                     {"a_x_rms_m_s2", m.a_x_rms_m_s2},
                     {"a_y_rms_m_s2", m.a_y_rms_m_s2},
                     {"a_z_rms_m_s2", m.a_z_rms_m_s2},
                     {"a_z_zero_crossing_s", m.a_z_zero_crossing_s}});
}

struct MarkedField {
  std::int32_t bit;
  const char* name;
  double value;
  Range range;
};

Conversion check_marked(const motion_t& m) {
  using M = motion_t;
  const MarkedField fields[] = {
      {M::VALID_ROLL, "roll_rms_deg", m.roll_rms_deg, kMeasuredRms_deg},
      {M::VALID_ROLL, "roll_zero_crossing_s", m.roll_zero_crossing_s, kMeasuredPeriod_s},
      {M::VALID_PITCH, "pitch_rms_deg", m.pitch_rms_deg, kMeasuredRms_deg},
      {M::VALID_PITCH, "pitch_zero_crossing_s", m.pitch_zero_crossing_s, kMeasuredPeriod_s},
      {M::VALID_HEAVE, "heave_rms_m", m.heave_rms_m, kMeasuredHeave_m},
      {M::VALID_HEAVE, "heave_zero_crossing_s", m.heave_zero_crossing_s, kMeasuredPeriod_s},
      {M::VALID_MEANS, "mean_heel_deg", m.mean_heel_deg, kMeasuredMean_deg},
      {M::VALID_MEANS, "mean_trim_deg", m.mean_trim_deg, kMeasuredMean_deg},
      {M::VALID_MAXIMA, "roll_max_deg", m.roll_max_deg, kMeasuredRms_deg},
      {M::VALID_MAXIMA, "pitch_max_deg", m.pitch_max_deg, kMeasuredRms_deg},
  };
  for (const MarkedField& marked : fields) {
    if (has(m.valid, marked.bit) && !marked.range.holds(marked.value)) {
      return {Refusal::kOutOfRange, marked.name};
    }
  }
  return {};
}

Conversion check_accelerometers(const motion_t& m) {
  const auto is_fit = [](double value, Range range) { return value == -1.0 || range.holds(value); };
  for (int i = 0; i < m.num_accelerometers; ++i) {
    for (const double rms : {m.a_x_rms_m_s2[i], m.a_y_rms_m_s2[i], m.a_z_rms_m_s2[i]}) {
      if (!is_fit(rms, kMeasuredAcceleration_m_s2)) {
        return {Refusal::kOutOfRange, "a_x_rms_m_s2, a_y_rms_m_s2 or a_z_rms_m_s2", i};
      }
    }
    if (!is_fit(m.a_z_zero_crossing_s[i], kMeasuredPeriod_s)) {
      return {Refusal::kOutOfRange, "a_z_zero_crossing_s", i};
    }
  }
  return {};
}

}  // namespace

Conversion check_motion(const motion_t& message) {
  if (const Conversion finite = check_finite(message); !finite) {
    return finite;
  }
  if (!is_time(message.utime)) {
    return {Refusal::kTime, "utime"};
  }
  if (message.num_accelerometers < 0 || message.num_accelerometers > kMaxAccelerometers) {
    return {Refusal::kCount, "num_accelerometers"};
  }
  if (const Conversion known = only_known_bits(message.valid, kMotionBits); !known) {
    return known;
  }
  if (!(message.window_s > 0.0 && message.window_s <= kDay_s)) {
    return {Refusal::kOutOfRange, "window_s"};
  }
  if (const Conversion marked = check_marked(message); !marked) {
    return marked;
  }
  return check_accelerometers(message);
}

Conversion check_clock(const clock_t& message) {
  if (const Conversion finite = all_finite({field("rate", message.rate)}); !finite) {
    return finite;
  }
  if (!is_time(message.utime)) {
    return {Refusal::kTime, "utime"};
  }
  return message.rate >= 0.0 || message.rate == -1.0 ? Conversion{}
                                                     : Conversion{Refusal::kOutOfRange, "rate"};
}

Conversion check_acknowledgement(const alert_t& message) {
  if (const Conversion finite = all_finite({field("value", message.value), field("limit", message.limit)});
      !finite) {
    return finite;
  }
  return is_time(message.utime) ? Conversion{} : Conversion{Refusal::kTime, "utime"};
}

}  // namespace quickstrip
