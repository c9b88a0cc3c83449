#include "sim/seaway/motion_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "msgs/convert/encode.hpp"
#include "msgs/convert/sea_message.hpp"
#include "msgs/convert/units.hpp"
#include "msgs/files/lcm_log.hpp"
#include "quickstrip/motion_t.hpp"
#include "quickstrip/own_ship_t.hpp"
#include "sim/seaway/crossings.hpp"

namespace quickstrip::seaway {
namespace {

constexpr std::int16_t kSimulatorId = 100;
constexpr double kMostOwnShip = 20e6;  // messages; 4 GB
constexpr std::int64_t kSeaPeriod_us = 30LL * 60 * 1'000'000;
constexpr std::size_t kAccelerometers = 4;
constexpr double kNotKnown = -1.0;

struct SeriesFigures {
  double rms = 0.0;
  double period = 0.0;  // 0 without a zero crossing
  double largest = 0.0;
};

SeriesFigures figures_of(const std::vector<double>& x, double dt) {
  SeriesFigures out;
  for (const double value : x) {
    out.rms += value * value;
    out.largest = std::max(out.largest, std::fabs(value));
  }
  const auto n = static_cast<double>(x.size());
  out.rms = std::sqrt(out.rms / n);
  std::vector<Crossing> zeros;
  list_crossings(x, dt, 0.0, 1.0, zeros);
  out.period = zeros.empty() ? 0.0 : n * dt / static_cast<double>(zeros.size());
  return out;
}

}  // namespace

struct MotionLog::Inside {
  LcmLogWriter writer;
  MotionLogOptions options;
  Plan plan;
  const Hull* hull = nullptr;
  const Watch* watch = nullptr;
  sea_state_t sea{};
  wave_spectrum_t spectrum{};
  bool is_measured = false;
  std::int64_t now = 0;  // of the next own-ship message
  std::int64_t next_sea = 0;
  std::int32_t num_own_ship = 0;
  std::int32_t num_sea = 0;
  std::int32_t num_motion = 0;
  std::array<std::uint8_t, kMaxMessageBytes> bytes{};

  template <typename Message>
  FileStatus append(const char* channel, const Message& message) {
    return writer.append(message.utime, options.prefix + channel, encode(message, bytes));
  }

  FileStatus add_sea() {
    ++num_sea;
    const auto stamp = [&](auto& message) {
      message.utime = next_sea;
      message.seq = num_sea;
      message.source_id = kSimulatorId;
    };
    stamp(sea);
    stamp(spectrum);
    next_sea += kSeaPeriod_us;
    return is_measured ? append("WAVE_SPECTRUM", spectrum) : append("SEA_STATE", sea);
  }

  FileStatus add_own_ship() {
    own_ship_t message{};
    message.utime = now;
    message.seq = ++num_own_ship;
    message.source_id = kSimulatorId;
    message.valid =
        std::int32_t{own_ship_t::VALID_HEADING} | std::int32_t{own_ship_t::VALID_SPEED_THROUGH_WATER};
    message.heading_deg = degrees(wrap_two_pi(plan.heading.radians));
    message.speed_through_water_kn = to_knots(plan.speed);
    now += std::llround(options.own_ship_period_s * 1e6);
    return append("OWN_SHIP", message);
  }

  SeriesFigures channel_figures(Quantity quantity, std::size_t place, const Series& series, double dt) const {
    return figures_of(series[find_channel(*watch, quantity, static_cast<std::uint8_t>(place))], dt);
  }

  motion_t motion_message(const Series& series, double dt) const {
    motion_t message{};
    message.source_id = kSimulatorId;
    message.valid = std::int32_t{motion_t::VALID_ROLL} | std::int32_t{motion_t::VALID_PITCH} |
                    std::int32_t{motion_t::VALID_HEAVE} | std::int32_t{motion_t::VALID_MAXIMA};
    const SeriesFigures roll = channel_figures(Quantity::kRoll, 0, series, dt);
    const SeriesFigures pitch = channel_figures(Quantity::kPitch, 0, series, dt);
    const SeriesFigures heave = channel_figures(Quantity::kHeave, 0, series, dt);
    message.roll_rms_deg = degrees(roll.rms);
    message.roll_zero_crossing_s = roll.period;
    message.roll_max_deg = degrees(roll.largest);
    message.pitch_rms_deg = degrees(pitch.rms);
    message.pitch_zero_crossing_s = pitch.period;
    message.pitch_max_deg = degrees(pitch.largest);
    message.heave_rms_m = heave.rms;
    message.heave_zero_crossing_s = heave.period;
    const std::size_t count = std::min(kAccelerometers, hull->points.size());
    message.num_accelerometers = static_cast<std::int8_t>(count);
    for (std::size_t i = 0; i < kAccelerometers; ++i) {
      message.a_x_rms_m_s2[i] = kNotKnown;
      message.a_y_rms_m_s2[i] = kNotKnown;
      message.a_z_rms_m_s2[i] = kNotKnown;
      message.a_z_zero_crossing_s[i] = kNotKnown;
    }
    for (std::size_t i = 0; i < count; ++i) {
      message.x_m[i] = hull->points[i].x;
      message.y_m[i] = hull->points[i].y;
      message.z_m[i] = hull->points[i].z;
      message.a_x_rms_m_s2[i] = channel_figures(Quantity::kLongitudinalAcceleration, i, series, dt).rms;
      message.a_y_rms_m_s2[i] = channel_figures(Quantity::kLateralAcceleration, i, series, dt).rms;
      const SeriesFigures up = channel_figures(Quantity::kVerticalAcceleration, i, series, dt);
      message.a_z_rms_m_s2[i] = up.rms;
      message.a_z_zero_crossing_s[i] = up.period;
    }
    return message;
  }
};

MotionLog::MotionLog() : inside_(std::make_unique<Inside>()) {}
MotionLog::~MotionLog() = default;

FileStatus MotionLog::open(const std::string& path, const MotionLogOptions& options, const Plan& plan,
                           const Hull& hull, const Watch& watch, const SeaView& sea) {
  const double messages = plan.hours * 3600.0 / options.own_ship_period_s;
  if (messages > kMostOwnShip) {
    return FileError{fmt::format("{}: {:g} hours with own ship every {:g} s: at most {:.0f} hours are wanted",
                                 path, plan.hours, options.own_ship_period_s,
                                 kMostOwnShip * options.own_ship_period_s / 3600.0)};
  }
  Inside& in = *inside_;
  in.options = options;
  in.plan = plan;
  in.hull = &hull;
  in.watch = &watch;
  in.now = options.start_utime;
  in.next_sea = options.start_utime;
  in.is_measured = sea.measured != nullptr;
  if (in.is_measured) {
    to_message(*sea.measured, in.spectrum);
    in.spectrum.source_kind = options.spectrum_source;
  } else {
    to_message(*sea.systems, in.sea);
    in.sea.source_kind = sea_state_t::SOURCE_MODEL;
  }
  return in.writer.open(path);
}

FileStatus MotionLog::add_block(const Simulation& simulation, std::size_t block, const Series& series) {
  Inside& in = *inside_;
  const std::int64_t end =
      in.options.start_utime + std::llround(simulation.block_s * 1e6 * static_cast<double>(block + 1));
  while (in.now < end || in.next_sea < end) {
    const FileStatus status = in.now <= in.next_sea ? in.add_own_ship() : in.add_sea();
    if (!status) {
      return status;
    }
  }
  motion_t motion = in.motion_message(series, simulation.dt());
  motion.utime = end;
  motion.seq = ++in.num_motion;
  motion.window_s = simulation.block_s;
  return in.append("MOTION", motion);
}

FileStatus MotionLog::finish() {
  return inside_->writer.finish();
}

}  // namespace quickstrip::seaway
