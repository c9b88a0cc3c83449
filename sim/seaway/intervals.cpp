#include "sim/seaway/intervals.hpp"

#include <algorithm>
#include <cmath>

namespace quickstrip::seaway {
namespace {

constexpr double kNormal95 = 1.6448536269514722;
constexpr int kMaxTerms = 100'000;  // of the series: some 10 sqrt(shape) are needed

// P(shape, x), regularised: the series below shape + 1, the continued fraction above [AbramowitzStegun1964]
// 6.5.29, 6.5.31.
double gamma_below(double shape, double x) {
  if (!(x > 0.0)) {
    return 0.0;
  }
  const double front = std::exp(shape * std::log(x) - x - std::lgamma(shape));
  if (x < shape + 1.0) {
    double term = 1.0 / shape;
    double sum = term;
    for (int n = 1; n < kMaxTerms && term > 1e-16 * sum; ++n) {
      term *= x / (shape + n);
      sum += term;
    }
    return sum * front;
  }
  constexpr double kTiny = 1e-300;
  double b = x + 1.0 - shape;
  double c = 1.0 / kTiny;
  double d = 1.0 / b;
  double fraction = d;
  for (int n = 1; n < kMaxTerms; ++n) {
    const double a = -n * (n - shape);
    b += 2.0;
    d = a * d + b;
    d = 1.0 / (std::fabs(d) < kTiny ? kTiny : d);
    c = b + a / c;
    c = std::fabs(c) < kTiny ? kTiny : c;
    fraction *= d * c;
    if (std::fabs(d * c - 1.0) < 1e-15) {
      break;
    }
  }
  return 1.0 - fraction * front;
}

}  // namespace

double gamma_quantile(double shape, double p) {
  double low = 0.0;
  double high = shape + 20.0 * std::sqrt(shape) + 40.0;
  constexpr int kHalvings = 80;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (gamma_below(shape, middle) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double student_quantile_95(std::size_t degrees) {
  const auto n = static_cast<double>(degrees);
  const double z = kNormal95;
  const double z3 = z * z * z;
  const double z5 = z3 * z * z;
  const double z7 = z5 * z * z;
  // [AbramowitzStegun1964] 26.7.5.
  return z + (z3 + z) / (4.0 * n) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n) +
         (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * n * n * n);
}

std::optional<RatioInterval> ratio_interval(std::span<const BlockCount> blocks) {
  double events = 0.0;
  double exposure = 0.0;
  for (const BlockCount& block : blocks) {
    events += block.events;
    exposure += block.exposure;
  }
  if (blocks.size() < kLeastBlocks || !(exposure > 0.0)) {
    return std::nullopt;
  }
  RatioInterval out;
  out.ratio = events / exposure;
  double scatter = 0.0;
  for (const BlockCount& block : blocks) {
    scatter += std::pow(block.events - out.ratio * block.exposure, 2);
  }
  const auto n = static_cast<double>(blocks.size());
  if (scatter > 0.0 && events > 0.0) {
    constexpr double kLeastDispersion = 1e-3;  // almost every encounter has its event
    out.dispersion = std::max(kLeastDispersion, scatter * n / (n - 1.0) / events);
  }
  const double widened = out.dispersion * std::pow(student_quantile_95(blocks.size() - 1) / kNormal95, 2);
  const double count = events / widened;
  const double tail = 0.5 * (1.0 - kConfidence);
  const double scale = widened / exposure;
  out.low = events > 0.0 ? scale * gamma_quantile(count + 0.5, tail) : 0.0;
  out.high = scale * gamma_quantile(count + 0.5, 1.0 - tail);
  return out;
}

}  // namespace quickstrip::seaway
