// How far the amplitudes of this hull's motions are from those of another source, curve by curve.
//
// A curve is one motion at one speed and direction over the wave frequencies of the window. Its deviation is
// the root mean square of the difference of amplitudes in per cent of its scale, max(peak, a quarter of the
// largest peak of that motion over the directions at that speed), peaks being those of the other source in
// the window: a motion that hardly exists in one direction is not blown up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/strip/loaded_hull.hpp"
#include "core/strip/motion_transfer.hpp"
#include "sim/hull_tool/transfer_file.hpp"

namespace quickstrip::hull_tool {

/// The frequencies that count, bounds excluded [rad/s].
struct ComparisonWindow {
  double omega_from = 0.2;
  double omega_to = 1.6;
  double encounter_from =
      0.1;  // of the signed frequency of encounter: below it strip theory has nothing to say
};

enum class ComparisonPoint : std::uint8_t {
  kWaterline,  // the x of G, on the waterline amidships: VERES
  kGravity,    // G: Quickstrip itself
};

struct CurveDeviation {
  double speed_kn = 0.0;
  double mu_deg = 0.0;
  std::size_t motion = 0;  // 0 ... 5
  std::size_t num_frequencies = 0;
  double peak = 0.0;  // of the other source in the window [m/m, rad/m]
  double scale = 0.0;
  double rms_percent = 0.0;
  double worst_percent = 0.0;  // of the scale, signed: ours less theirs
  double worst_omega = 0.0;
};

/// Motions at G in the waves of these values, one each.
using MotionSolver = std::function<std::vector<MotionTransfer>(const std::vector<TransferValue>&)>;

/// By speed, direction and motion, in the order in which they first come. A curve without a frequency in the
/// window, or whose motion is nil in every direction, is left out. `solve`: motions of another program for
/// this hull; none: the hull's own.
std::vector<CurveDeviation> compare_transfer(const LoadedHull& hull, const std::vector<TransferValue>& values,
                                             const ComparisonWindow& window, ComparisonPoint point,
                                             const MotionSolver& solve = {});

}  // namespace quickstrip::hull_tool
