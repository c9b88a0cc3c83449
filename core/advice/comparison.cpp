#include "core/advice/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/check.hpp"
#include "core/response/window_rms.hpp"

namespace quickstrip {
namespace {

/// Place among the tracked responses; none: not tracked.
std::optional<std::size_t> tracked_of(Quantity quantity, std::size_t place) {
  switch (quantity) {
    case Quantity::kRoll:
      return 0;
    case Quantity::kPitch:
      return 1;
    case Quantity::kHeave:
      return 2;
    case Quantity::kLongitudinalAcceleration:
      return 3 + 3 * place;
    case Quantity::kLateralAcceleration:
      return 4 + 3 * place;
    case Quantity::kVerticalAcceleration:
      return 5 + 3 * place;
    default:
      return std::nullopt;
  }
}

std::optional<std::size_t> point_near(const Hull& hull, const MeasuredAcceleration& at) {
  for (std::size_t i = 0; i < hull.points.size(); ++i) {
    const auto& point = hull.points[i];
    if (std::hypot(point.x - at.x, point.y - at.y, point.z - at.z) <= kAccelerometerNearby) {
      return i;
    }
  }
  return std::nullopt;
}

}  // namespace

void PredictedMotion::forget() {
  bins_.fill(Bin{});
  gaps_.fill(Gap{});
}

void PredictedMotion::note(double time, const CellResponse& present) {
  const double number = std::floor(time / kBin);
  const double start = number * kBin;
  const double turn = std::floor(number / static_cast<double>(kNumBins)) * static_cast<double>(kNumBins);
  Bin& bin = bins_[static_cast<std::size_t>(number - turn) % kNumBins];
  if (bin.start != start) {
    bin = Bin{};
    bin.start = start;
  }
  bin.count += 1.0F;
  bin.roll_damping += present.cell.roll_damping_ratio;
  for (const QuantityResponse& response : present.quantities) {
    const auto tracked = tracked_of(response.quantity, response.place);
    if (!tracked) {
      continue;
    }
    const double variance = response.rms * response.rms;
    Sums& sums = bin.sums[*tracked];
    sums.variance += static_cast<float>(variance);
    sums.t1 += static_cast<float>(variance * response.t1);
    sums.t2 += static_cast<float>(variance * response.t2);
  }
}

PredictedMotion::Mean PredictedMotion::mean_of(std::size_t tracked, double from, double to) const {
  Mean mean;
  double count = 0.0;
  for (const Bin& bin : bins_) {
    const double part = std::min(to, bin.start + kBin) - std::max(from, bin.start);
    if (!(part > 0.0) || !(bin.count > 0.0F)) {
      continue;
    }
    const double weight = part / static_cast<double>(bin.count);
    const Sums& sums = bin.sums[tracked];
    mean.variance += weight * static_cast<double>(sums.variance);
    mean.t1 += weight * static_cast<double>(sums.t1);
    mean.t2 += weight * static_cast<double>(sums.t2);
    mean.roll_damping += weight * static_cast<double>(bin.roll_damping);
    count += part;
  }
  if (!(count > 0.0)) {
    return mean;
  }
  if (mean.variance > 0.0) {
    mean.t1 /= mean.variance;
    mean.t2 /= mean.variance;
  }
  mean.variance /= count;
  mean.roll_damping /= count;
  mean.covered = count;
  return mean;
}

void PredictedMotion::compare_one(std::size_t tracked, double window, double end, double height_part,
                                  ComparedLine& line, Comparison& out) {
  const Mean mean = mean_of(tracked, end - window, end);
  out.predicted_over = std::max(out.predicted_over, mean.covered);
  Gap& gap = gaps_[tracked];
  if (!(mean.covered >= kLeastCoverage * window) || !(mean.variance > 0.0)) {
    gap = {};
    return;
  }
  line.predicted_rms = std::sqrt(mean.variance);
  const double damping = line.quantity == Quantity::kRoll ? mean.roll_damping : 0.0;
  const double deviation = std::hypot(window_rms_deviation(mean.t1, mean.t2, window, damping), height_part);
  line.low_rms = std::max(0.0, line.predicted_rms * (1.0 - kConfidenceBounds * deviation));
  line.high_rms = line.predicted_rms * (1.0 + kConfidenceBounds * deviation);
  const int side = line.measured_rms > line.high_rms ? 1 : line.measured_rms < line.low_rms ? -1 : 0;
  line.state = side > 0   ? GapState::kAbovePredicted
               : side < 0 ? GapState::kBelowPredicted
                          : GapState::kAgrees;
  if (side == 0 || side != gap.side || end < gap.since) {
    gap = {.side = side, .since = end};
  }
  line.gap_since = side == 0 ? 0.0 : end - gap.since;
  out.has_lasting_gap = out.has_lasting_gap || (side != 0 && line.gap_since >= kLastingGap);
}

void PredictedMotion::compare(const MeasuredMotion& measured, const Hull& hull, double end,
                              double height_part, Comparison& out) {
  out = Comparison{};
  const auto add = [&](Quantity quantity, std::optional<std::size_t> place,
                       const std::optional<double>& rms) {
    if (!rms) {
      return;
    }
    ComparedLine line{.quantity = quantity, .is_place_known = place.has_value(), .measured_rms = *rms};
    if (place) {
      line.place = static_cast<std::uint8_t>(*place);
      compare_one(*tracked_of(quantity, *place), measured.window, end, height_part, line, out);
    }
    QS_CHECK(out.lines.push_back(line));
  };
  add(Quantity::kRoll, 0, measured.roll_rms);
  add(Quantity::kPitch, 0, measured.pitch_rms);
  add(Quantity::kHeave, 0, measured.heave_rms);
  for (const MeasuredAcceleration& at : measured.accelerations) {
    const auto point = point_near(hull, at);
    add(Quantity::kLongitudinalAcceleration, point, at.rms_x);
    add(Quantity::kLateralAcceleration, point, at.rms_y);
    add(Quantity::kVerticalAcceleration, point, at.rms_z);
  }
}

}  // namespace quickstrip
