// Linear quantisation of the grid's cells: rounded to the nearest step, saturated, never wrapped. The error
// is at most half a step up to the largest value that fits.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

namespace quickstrip {

// Steps of grid_t's fields; its comments say the same.
inline constexpr double kMarginStep = 0.01;
inline constexpr double kProbabilityStep = 0.00005;
inline constexpr double kPerHourStep = 0.1;
inline constexpr double kRollStep_deg = 0.01;
inline constexpr double kAccelerationStep_m_s2 = 0.001;
inline constexpr double kSpeedLossStep_kn = 0.1;

/// -1 for what is negative or NaN: not computed.
template <std::signed_integral Integer>
Integer quantised(double value, double step, Integer largest = std::numeric_limits<Integer>::max()) {
  if (!(value >= 0.0)) {
    return Integer{-1};
  }
  const double steps = std::round(value / step);
  return steps < static_cast<double>(largest) ? static_cast<Integer>(steps) : largest;
}

}  // namespace quickstrip
