#include "core/sea/spreading.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/sea/quadrature.hpp"

namespace quickstrip {
namespace {

constexpr double kStep = kTwoPi / static_cast<double>(kNumDirections);
constexpr double kSpreadingMax = 1.41421356237309515;  // s = 0
// Narrower than this the function is a needle for a 5-degree grid.
constexpr double kNeedle = 0.001;

// Where a direction lies on the grid: nearest node and distance to it in steps, [-0.5, 0.5]. Rounded to
// 2^-20 of a step, so that directions 5 degrees apart have the same distance.
struct GridPlace {
  std::size_t node = 0;
  double offset = 0.0;
};

GridPlace grid_place(WaveFrom from) {
  const double position = std::round(std::ldexp(wrap_two_pi(from.radians) / kStep, 20));
  const double steps = std::ldexp(position, -20);
  const double nearest = std::round(steps);
  return {static_cast<std::size_t>(nearest) % kNumDirections, steps - nearest};
}

// A direction interpolated linearly on the grid loses this part of its first Fourier coefficient.
double hat_attenuation() {
  const double half = std::sin(0.5 * kStep) / (0.5 * kStep);
  return half * half;
}

std::size_t wrapped(std::size_t node, std::ptrdiff_t shift) {
  const auto n = static_cast<std::ptrdiff_t>(kNumDirections);
  return static_cast<std::size_t>((static_cast<std::ptrdiff_t>(node) + shift + n) % n);
}

DirectionWeights needle(const GridPlace& place) {
  DirectionWeights weights{};
  weights[place.node] = 1.0 - std::fabs(place.offset);
  weights[wrapped(place.node, place.offset < 0.0 ? -1 : 1)] += std::fabs(place.offset);
  return weights;
}

// Integrals of cos^2s times the hats, interval by interval from -pi to pi around the nearest node.
DirectionWeights hat_weights(const GridPlace& place, double sigma) {
  const double two_s = 2.0 * spreading_exponent(sigma);
  const auto spread = [two_s](double angle) {
    const double c = std::cos(0.5 * angle);
    return c > 0.0 ? std::exp(two_s * std::log(c)) : (two_s > 0.0 ? 0.0 : 1.0);
  };
  const auto panels =
      static_cast<std::size_t>(std::clamp(std::ceil(kStep / sigma), 1.0, 2.0 * kStep / kNeedle));
  const double reach = 9.0 * sigma + kStep;  // beyond: exp(-40), for wide spreading more than the circle
  constexpr auto kHalf = static_cast<std::ptrdiff_t>(kNumDirections / 2);
  DirectionWeights weights{};
  for (std::ptrdiff_t m = -kHalf; m < kHalf; ++m) {
    const double from = (static_cast<double>(m) - place.offset) * kStep;
    if (std::fabs(from) > reach) {
      continue;
    }
    double& left = weights[wrapped(place.node, m)];
    double& right = weights[wrapped(place.node, m + 1)];
    for_each_gauss_point(0.0, 1.0, panels, [&](double share, double weight) {
      const double part = weight * spread(wrap_pi(from + share * kStep));
      left += part * (1.0 - share);
      right += part * share;
    });
  }
  double sum = 0.0;
  for (std::size_t m = 0; m < kNumDirections; ++m) {  // from the mean on: the same bits after a turn
    sum += weights[(place.node + m) % kNumDirections];
  }
  for (double& w : weights) {
    w /= sum;
  }
  return weights;
}

}  // namespace

Result<DirectionWeights> direction_weights(WaveFrom mean, double spreading) {
  if (!std::isfinite(mean.radians) || !std::isfinite(spreading)) {
    return Error::kNotFinite;
  }
  if (!(spreading >= 0.0 && spreading <= kSpreadingMax && std::fabs(mean.radians) <= 2.0 * kTwoPi)) {
    return Error::kOutOfRange;
  }
  const GridPlace place = grid_place(mean);
  const double r1 = (1.0 - 0.5 * spreading * spreading) / hat_attenuation();
  const double sigma = std::sqrt(std::max(0.0, 2.0 * (1.0 - r1)));
  return sigma < kNeedle ? needle(place) : hat_weights(place, std::min(sigma, kSpreadingMax));
}

MeanDirection mean_direction(double cosine_sum, double sine_sum, double energy) {
  const double r1 = std::min(1.0, std::hypot(cosine_sum, sine_sum) / energy);
  return {WaveFrom{wrap_two_pi(std::atan2(sine_sum, cosine_sum))}, std::sqrt(2.0 * (1.0 - r1))};
}

}  // namespace quickstrip
