#include "sim/seaway/crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quickstrip::seaway {
namespace {

// The cubic through samples at -1, 0, 1, 2, as c0 + c1 t + c2 t^2 + c3 t^3.
struct Cubic {
  explicit Cubic(const std::array<double, 4>& y)
      : c0(y[1]),
        c1(-y[0] / 3.0 - y[1] / 2.0 + y[2] - y[3] / 6.0),
        c2(0.5 * (y[0] + y[2]) - y[1]),
        c3((y[3] - y[0]) / 6.0 + 0.5 * (y[1] - y[2])) {}
  [[nodiscard]] double value(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
  [[nodiscard]] double slope(double t) const { return c1 + t * (2.0 * c2 + t * 3.0 * c3); }
  double c0, c1, c2, c3;
};

// y[1] < 0 <= y[2].
Crossing crossing_between(const std::array<double, 4>& y, double at, double dt) {
  const Cubic cubic(y);
  double low = 0.0;
  double high = 1.0;
  constexpr int kHalvings = 20;  // a millionth of a step
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (cubic.value(middle) < 0.0 ? low : high) = middle;
  }
  return {(at + high) * dt, std::max(cubic.slope(high), 0.0) / dt};
}

// An extreme at the middle one of three samples, all on one side: where the parabola passes zero upwards, if
// it reaches it.
bool crosses_beside(double before, double middle, double after, double& offset, double& slope) {
  const double curvature = before - 2.0 * middle + after;
  const double tilt = 0.5 * (after - before);
  const double root2 = tilt * tilt - 2.0 * curvature * middle;
  if (!(root2 > 0.0) || !(std::fabs(curvature) > 0.0)) {
    return false;
  }
  slope = std::sqrt(root2);  // upwards at (slope - tilt) / curvature
  offset = (slope - tilt) / curvature;
  return std::fabs(offset) <= 1.0;
}

}  // namespace

void list_crossings(std::span<const double> x, double dt, double level, double sign,
                    std::vector<Crossing>& out) {
  out.clear();
  const std::size_t n = x.size();
  const auto y = [&](std::size_t i) { return sign * x[i < n ? i : i - n] - level; };
  double before = y(n - 1);
  double here = y(0);
  for (std::size_t i = 0; i < n; ++i) {
    const double next = y(i + 1);
    const auto at = static_cast<double>(i);
    if (here < 0.0 && next >= 0.0) {
      out.push_back(crossing_between({before, here, next, y(i + 2)}, at, dt));
    }
    const bool is_crest_below = here < 0.0 && before < 0.0 && next < 0.0 && here >= before && here > next;
    const bool is_trough_above = here >= 0.0 && before >= 0.0 && next >= 0.0 && here <= before && here < next;
    if (is_crest_below || is_trough_above) {
      double offset = 0.0;
      double slope = 0.0;
      if (crosses_beside(before, here, next, offset, slope)) {
        out.push_back({std::max(0.0, at + offset) * dt, slope / dt});
      }
    }
    before = here;
    here = next;
  }
  std::sort(out.begin(), out.end(), [](const Crossing& a, const Crossing& b) { return a.time < b.time; });
}

std::size_t encounters_with_event(std::span<const Crossing> zeros, std::span<const Crossing> events) {
  if (zeros.empty()) {
    return 0;
  }
  std::size_t count = 0;
  std::size_t zero = 0;                 // of zeros passed
  std::size_t last = zeros.size() + 1;  // encounter of the event before; none yet
  for (const Crossing& event : events) {
    while (zero < zeros.size() && zeros[zero].time <= event.time) {
      ++zero;
    }
    const std::size_t encounter = zero % zeros.size();  // before the first: goes on from the last
    count += encounter != last ? 1U : 0U;
    last = encounter;
  }
  return std::min(count, zeros.size());
}

}  // namespace quickstrip::seaway
