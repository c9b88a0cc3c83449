#include "firmware/display/trends.hpp"

#include <algorithm>

namespace quickstrip {
namespace {

constexpr std::int64_t kMinute_us = 60'000'000;

void worsen(TrendSample& kept, const TrendSample& sample) {
  const bool knows_both = kept.margin >= 0.0 && sample.margin >= 0.0;
  kept.margin = knows_both ? std::min(kept.margin, sample.margin) : std::max(kept.margin, sample.margin);
  kept.roll_rms_deg = std::max(kept.roll_rms_deg, sample.roll_rms_deg);
  kept.hs_m = std::max(kept.hs_m, sample.hs_m);
  kept.verdict = sample.verdict < 0 || kept.verdict < 0 ? -1 : std::max(kept.verdict, sample.verdict);
}

}  // namespace

void Trends::add(std::int64_t utime, TrendSample sample) {
  sample.minute = utime / kMinute_us;
  if (!samples_.empty() && sample.minute < samples_.back().minute) {
    samples_.clear();
  }
  if (!samples_.empty() && sample.minute == samples_.back().minute) {
    worsen(samples_.back(), sample);
    return;
  }
  samples_.push_back(sample);
  const auto oldest = sample.minute - static_cast<std::int64_t>(kMaxSamples) + 1;
  while (samples_.front().minute < oldest) {  // the newest is never older than that
    samples_.pop_front();
  }
}

}  // namespace quickstrip
