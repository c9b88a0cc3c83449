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
  constexpr int kHalvings = 14;  // 6e-5 of a step
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (cubic.value(middle) < 0.0 ? low : high) = middle;
  }
  return {(at + high) * dt, std::max(cubic.slope(high), 0.0) / dt};
}

// Around a turn that alone lies beyond the level: the rising root of the parabola through its neighbours.
Crossing crossing_at_turn(double before, double middle, double after, double at, double dt) {
  const double curvature = before - 2.0 * middle + after;
  const double tilt = 0.5 * (after - before);
  const double slope = std::sqrt(std::max(0.0, tilt * tilt - 2.0 * curvature * middle));
  const double offset = std::fabs(curvature) > 0.0 ? (slope - tilt) / curvature : 0.0;
  return {(at + std::clamp(offset, -1.0, 1.0)) * dt, slope / dt};
}

double height_of_turn(double before, double middle, double after) {
  const double curvature = before - 2.0 * middle + after;
  const double tilt = 0.5 * (after - before);
  return std::fabs(curvature) > 0.0 ? middle - 0.5 * tilt * tilt / curvature : middle;
}

// A periodic series on one side of a level, y < 0 before and y >= 0 after a crossing.
struct View {
  std::span<const double> x;
  double sign = 1.0;
  double level = 0.0;
  double operator()(std::size_t i) const {
    while (i >= x.size()) {  // twice at most; a division costs more than all the rest
      i -= x.size();
    }
    return sign * x[i] - level;
  }
};

Crossing crossing_within(const View& y, std::size_t from, std::size_t to, double dt) {
  const std::size_t n = y.x.size();
  const auto around = [&](std::size_t i) {
    return crossing_at_turn(y(i + n - 1), y(i), y(i + 1), static_cast<double>(i), dt);
  };
  if (!(y(from) < 0.0)) {
    return around(from);
  }
  for (std::size_t i = from; i < to; ++i) {
    if (y(i + 1) >= 0.0) {
      return crossing_between({y(i + n - 1), y(i), y(i + 1), y(i + 2)}, static_cast<double>(i), dt);
    }
  }
  return around(to);
}

}  // namespace

void list_rises(std::span<const double> x, std::vector<Rise>& out) {
  out.clear();
  const std::size_t n = x.size();
  const auto at = [&](std::size_t i) { return x[i >= 2 * n ? i - 2 * n : i >= n ? i - n : i]; };
  // The first sample from which it falls, and behind it the first trough.
  std::size_t start = 0;
  while (start < n && !(at(start + 1) < at(start))) {
    ++start;
  }
  if (start == n) {
    return;  // a constant
  }
  bool is_falling = true;
  Rise rise;
  for (std::size_t i = start + 1; i <= start + n; ++i) {
    const double here = at(i);
    const double next = at(i + 1);
    if (is_falling ? next > here : next < here) {
      const double height = height_of_turn(at(i + n - 1), here, next);
      if (is_falling) {
        rise = {i, 0, height, 0.0};
      } else {
        rise.crest = i;
        rise.high = height;
        out.push_back(rise);
      }
      is_falling = !is_falling;
    }
  }
}

void list_crossings(std::span<const double> x, std::span<const Rise> rises, double dt, double level,
                    double sign, std::vector<Crossing>& out) {
  out.clear();
  const View y{x, sign, level};
  const auto n = static_cast<double>(x.size());
  for (std::size_t r = 0; r < rises.size(); ++r) {
    // Of the mirror image the falls rise: from a crest to the trough of the next rise.
    const bool is_last = r + 1 == rises.size();
    const Rise& next = rises[is_last ? 0 : r + 1];
    const double low = sign > 0.0 ? rises[r].low : -rises[r].high;
    const double high = sign > 0.0 ? rises[r].high : -next.low;
    if (!(low < level && high >= level)) {
      continue;
    }
    const std::size_t from = sign > 0.0 ? rises[r].trough : rises[r].crest;
    const std::size_t to = sign > 0.0 ? rises[r].crest : next.trough + (is_last ? x.size() : 0);
    Crossing found = crossing_within(y, from, to, dt);
    found.time -= found.time >= n * dt ? n * dt : 0.0;
    found.time += found.time < 0.0 ? n * dt : 0.0;
    out.push_back(found);
  }
  const auto earlier = [](const Crossing& a, const Crossing& b) { return a.time < b.time; };
  std::sort(out.begin(), out.end(), earlier);
}

void list_crossings(std::span<const double> x, double dt, double level, double sign,
                    std::vector<Crossing>& out) {
  std::vector<Rise> rises;
  list_rises(x, rises);
  list_crossings(x, rises, dt, level, sign, out);
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
