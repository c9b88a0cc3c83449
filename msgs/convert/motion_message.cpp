#include "msgs/convert/motion_message.hpp"

#include "core/base/angles.hpp"
#include "core/base/check.hpp"
#include "msgs/convert/field_checks.hpp"
#include "msgs/convert/received_checks.hpp"

namespace quickstrip {
namespace {

std::optional<double> known(double value) {
  return value >= 0.0 ? std::optional<double>(value) : std::nullopt;  // -1: not known
}

}  // namespace

Conversion to_measured_motion(const motion_t& message, MeasuredMotion& out) {
  if (const Conversion checked = check_motion(message); !checked) {
    return checked;
  }
  out = MeasuredMotion{};
  out.window = message.window_s;
  if (has(message.valid, motion_t::VALID_ROLL)) {
    out.roll_rms = radians(message.roll_rms_deg);
    out.roll_period = message.roll_zero_crossing_s;
  }
  if (has(message.valid, motion_t::VALID_PITCH)) {
    out.pitch_rms = radians(message.pitch_rms_deg);
    out.pitch_period = message.pitch_zero_crossing_s;
  }
  if (has(message.valid, motion_t::VALID_HEAVE)) {
    out.heave_rms = message.heave_rms_m;
    out.heave_period = message.heave_zero_crossing_s;
  }
  if (has(message.valid, motion_t::VALID_MAXIMA)) {
    out.roll_max = radians(message.roll_max_deg);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(message.num_accelerometers); ++i) {
    QS_CHECK(out.accelerations.push_back({message.x_m[i], message.y_m[i], message.z_m[i],
                                          known(message.a_x_rms_m_s2[i]), known(message.a_y_rms_m_s2[i]),
                                          known(message.a_z_rms_m_s2[i])}));
  }
  return {};
}

}  // namespace quickstrip
