// Roll, pitch and heave of the last minutes, and their figures for QS_MOTION.
//
// Definitions: RMS about the mean of the window; zero-crossing period = time between the first and the last
// up-crossing of the mean over their number less one, crossings interpolated between samples; greatest single
// amplitude about the mean; mean heel and trim. A crossing counts after the signal has been a tenth of its
// RMS below the mean: noise about the mean makes no waves (of a narrow-band Gaussian signal 0.5 % of the
// waves are smaller, exp(-0.1^2/2)). A gap of more than 3 s is no motion: no crossing is looked for across
// it, and its time is not counted in window_s.
//
// Range: at least 1 Hz (periods above 4 s); above 50 samples a second (25 for windows of 20 min) samples are
// thinned, not averaged: no aliasing for what a ship does. Memory 1.5 MB: static. No heap, no clock.
// Cost: a sample below 0.1 microseconds, figures some 0.5 ms.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "quickstrip/motion_t.hpp"

namespace quickstrip::nmea {

struct ChannelFigures {
  double mean = 0.0;
  double rms = 0.0;              // about the mean
  double zero_crossing_s = 0.0;  // only with num_waves above 0
  double max = 0.0;              // greatest single amplitude about the mean
  double covered_s = 0.0;        // the span less its gaps
  std::int64_t num_waves = 0;    // between the first and the last up-crossing
  std::int64_t num_samples = 0;
};

/// One quantity's samples.
class MotionChannel {
 public:
  void set_window(double window_s) { window_s_ = window_s; }
  /// Samples before the last one begin the window anew (a clock was set back).
  void take(double value, std::int64_t utime);
  void forget_before(std::int64_t utime);
  [[nodiscard]] ChannelFigures figures() const;
  /// Of a channel with samples.
  [[nodiscard]] std::int64_t newest_utime() const { return sample(size_ - 1).utime; }
  [[nodiscard]] bool is_silent(std::int64_t now, double after_s) const;

 private:
  static constexpr std::size_t kCapacity = 1U << 15U;
  struct Sample {
    std::int64_t utime = 0;
    double value = 0.0;
  };
  [[nodiscard]] const Sample& sample(std::size_t i) const { return ring_[(begin_ + i) % kCapacity]; }
  void find_waves(ChannelFigures& figures) const;

  std::array<Sample, kCapacity> ring_{};
  std::size_t begin_ = 0;
  std::size_t size_ = 0;
  double window_s_ = 1200.0;
};

class MotionWindow {
 public:
  explicit MotionWindow(double window_s);

  void take_roll(double roll_deg, std::int64_t utime) { roll_.take(roll_deg, utime); }
  void take_pitch(double pitch_deg, std::int64_t utime) { pitch_.take(pitch_deg, utime); }
  void take_heave(double heave_m, std::int64_t utime) { heave_.take(heave_m, utime); }

  /// Nothing until a quantity covers a quarter of the window with at least ten waves; what does not, or has
  /// been silent for 10 s, is not marked valid. utime is that of the newest sample; `seq` and `source_id` are
  /// the caller's. Means and maxima need roll and pitch both (they share a bit).
  [[nodiscard]] std::optional<motion_t> motion(std::int64_t now);

 private:
  double window_s_;
  MotionChannel roll_;
  MotionChannel pitch_;
  MotionChannel heave_;
};

}  // namespace quickstrip::nmea
