// The last twelve hours, a sample a minute, in bounded memory: kept here, so that a page that is loaded again
// has them. Of each minute the worst is kept: the smallest margin, the largest roll and wave height.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

namespace quickstrip {

struct TrendSample {
  std::int64_t minute = 0;  // since the epoch
  double margin = -1.0;     // factor on wave height; -1: not known
  double roll_rms_deg = -1.0;
  double hs_m = -1.0;
  int verdict = 0;  // advice_t.VERDICT_...; -1: no advice
};

class Trends {
 public:
  static constexpr std::size_t kMaxSamples = 720;  // 12 h

  /// Time that goes back (another log is played) begins anew.
  void add(std::int64_t utime, TrendSample sample);
  [[nodiscard]] const std::deque<TrendSample>& samples() const { return samples_; }

 private:
  std::deque<TrendSample> samples_;
};

}  // namespace quickstrip
