#include "core/response/window_rms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/angles.hpp"

namespace quickstrip {

double window_rms_deviation(double t1, double t2, double window, double damping_ratio) {
  if (!(t1 > 0.0) || !(t2 > 0.0) || !(window > 0.0)) {
    return 1.0;
  }
  const double ratio = t1 / t2;
  const double width = std::sqrt(std::max(0.0, ratio * ratio - 1.0)) * kTwoPi / t1;
  const double root_pi = std::sqrt(std::numbers::pi);
  const bool is_resonant = damping_ratio > 0.0;
  const double of_bell = width > 0.0 ? root_pi / (width * window) : 0.0;
  const double of_resonance = is_resonant ? t2 / (damping_ratio * kTwoPi * window) : 0.0;
  if (!(width > 0.0) && !is_resonant) {
    return 1.0;  // a sine: one window says nothing of the next
  }
  return std::min(1.0, 0.5 * std::sqrt(std::max(of_bell, of_resonance)));
}

}  // namespace quickstrip
