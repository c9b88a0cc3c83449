#include "core/advice/interruptions_margin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/response/interruptions.hpp"

namespace quickstrip {

double sum_of_interruptions(double level, std::span<const ResponseMoments> sides) {
  double sum = 0.0;
  for (const ResponseMoments& side : sides) {
    sum += interruptions_per_minute(level, side.m0, side.m2);
  }
  return sum;
}

double interruptions_margin(double limit, double level, std::span<const ResponseMoments> sides) {
  constexpr int kMostSteps = 60;
  constexpr double kEnough = 1e-12;  // of x
  const auto most = [](const ResponseMoments& side) {
    return interruptions_per_minute(0.0, side.m0, side.m2);
  };
  double x = 0.0;
  double all = 0.0;
  for (const ResponseMoments& side : sides) {
    all += most(side);
    if (most(side) > limit) {
      x = std::max(x, std::log(most(side) / limit) * 2.0 * side.m0 / (level * level));
    }
  }
  if (!(all > limit)) {
    return std::numeric_limits<double>::infinity();  // fewer oscillations than interruptions allowed
  }
  for (int i = 0; i < kMostSteps; ++i) {
    double sum = 0.0;
    double fall = 0.0;
    for (const ResponseMoments& side : sides) {
      const double exponent = side.m0 > 0.0 ? level * level / (2.0 * side.m0) : 0.0;
      const double number = most(side) * std::exp(-exponent * x);
      sum += number;
      fall += exponent * number;
    }
    const double step = std::log(sum / limit) * sum / fall;
    x += step;
    if (!(std::fabs(step) > kEnough * x)) {
      break;
    }
  }
  return 1.0 / std::sqrt(x);
}

}  // namespace quickstrip
