#include "firmware/nmea/motion_window.hpp"

#include <algorithm>
#include <cmath>

#include "msgs/convert/field_checks.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip::nmea {
namespace {

constexpr double kGap_s = 3.0;
constexpr double kHysteresis = 0.1;  // of the RMS
constexpr double kLeastCovered = 0.25;
constexpr double kSilent_s = 10.0;  // after which no window is told any more
constexpr std::int64_t kLeastWaves = 10;

std::int64_t microseconds(double seconds) {
  return static_cast<std::int64_t>(seconds * kMicrosecondsPerSecond);
}

bool is_enough(const ChannelFigures& figures, double window_s) {
  return figures.covered_s >= kLeastCovered * window_s && figures.num_waves >= kLeastWaves;
}

}  // namespace

void MotionChannel::take(double value, std::int64_t utime) {
  if (size_ > 0) {
    const std::int64_t last = sample(size_ - 1).utime;
    if (utime < last) {
      size_ = 0;
    } else if (utime == last || seconds_between(last, utime) < window_s_ / static_cast<double>(kCapacity)) {
      return;  // thinned
    }
  }
  forget_before(utime - microseconds(window_s_));
  if (size_ == kCapacity) {
    begin_ = (begin_ + 1) % kCapacity;
    --size_;
  }
  ring_[(begin_ + size_) % kCapacity] = {utime, value};
  ++size_;
}

void MotionChannel::forget_before(std::int64_t utime) {
  while (size_ > 0 && sample(0).utime < utime) {
    begin_ = (begin_ + 1) % kCapacity;
    --size_;
  }
}

bool MotionChannel::is_silent(std::int64_t now, double after_s) const {
  return size_ == 0 || seconds_between(newest_utime(), now) > after_s;
}

ChannelFigures MotionChannel::figures() const {
  ChannelFigures figures;
  figures.num_samples = static_cast<std::int64_t>(size_);
  if (size_ < 2) {
    return figures;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    sum += sample(i).value;
  }
  figures.mean = sum / static_cast<double>(size_);
  double sum_of_squares = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    const double deviation = sample(i).value - figures.mean;
    sum_of_squares += deviation * deviation;
    figures.max = std::max(figures.max, std::fabs(deviation));
    const double step = i > 0 ? seconds_between(sample(i - 1).utime, sample(i).utime) : 0.0;
    figures.covered_s += step <= kGap_s ? step : 0.0;
  }
  figures.rms = std::sqrt(sum_of_squares / static_cast<double>(size_));
  find_waves(figures);
  return figures;
}

void MotionChannel::find_waves(ChannelFigures& figures) const {
  const double below = figures.mean - kHysteresis * figures.rms;
  double waves_s = 0.0;
  double last_crossing = -1.0;  // [s] since the first sample; negative: none since the last gap
  bool was_below = false;
  for (std::size_t i = 1; i < size_; ++i) {
    const Sample& from = sample(i - 1);
    const Sample& to = sample(i);
    const double step = seconds_between(from.utime, to.utime);
    if (step > kGap_s) {
      last_crossing = -1.0;
      was_below = false;
      continue;
    }
    was_below = was_below || from.value < below;
    if (!was_below || !(from.value < figures.mean && to.value >= figures.mean)) {
      continue;
    }
    const double crossing = seconds_between(sample(0).utime, from.utime) +
                            step * (figures.mean - from.value) / (to.value - from.value);
    if (last_crossing >= 0.0) {
      waves_s += crossing - last_crossing;
      ++figures.num_waves;
    }
    last_crossing = crossing;
    was_below = false;
  }
  if (figures.num_waves > 0) {
    figures.zero_crossing_s = waves_s / static_cast<double>(figures.num_waves);
  }
}

MotionWindow::MotionWindow(double window_s) : window_s_(window_s) {
  roll_.set_window(window_s);
  pitch_.set_window(window_s);
  heave_.set_window(window_s);
}

std::optional<motion_t> MotionWindow::motion(std::int64_t now) {
  using M = motion_t;
  motion_t message{};
  const auto put = [&](MotionChannel& channel, std::int32_t bit, double& rms, double& period) {
    channel.forget_before(now - microseconds(window_s_));
    if (channel.is_silent(now, kSilent_s)) {
      return std::optional<ChannelFigures>();
    }
    const ChannelFigures figures = channel.figures();
    if (!is_enough(figures, window_s_)) {
      return std::optional<ChannelFigures>();
    }
    message.valid |= bit;
    message.utime = std::max(message.utime, channel.newest_utime());
    rms = figures.rms;
    period = figures.zero_crossing_s;
    message.window_s = std::max(message.window_s, figures.covered_s);
    return std::optional<ChannelFigures>(figures);
  };
  const auto roll = put(roll_, M::VALID_ROLL, message.roll_rms_deg, message.roll_zero_crossing_s);
  const auto pitch = put(pitch_, M::VALID_PITCH, message.pitch_rms_deg, message.pitch_zero_crossing_s);
  put(heave_, M::VALID_HEAVE, message.heave_rms_m, message.heave_zero_crossing_s);
  if (message.valid == 0) {
    return {};
  }
  if (roll && pitch) {  // own masks for both together: one alone would leave a field that means nothing
    message.valid |= bits({M::VALID_MEANS, M::VALID_MAXIMA});
    message.mean_heel_deg = roll->mean;
    message.mean_trim_deg = pitch->mean;
    message.roll_max_deg = std::min(roll->max, 90.0);
    message.pitch_max_deg = std::min(pitch->max, 90.0);
  }
  return message;
}

}  // namespace quickstrip::nmea
