#include "sim/sea_files/maximum_entropy.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

constexpr double kLimit = 0.99;         // of |c1| and |f2| as given
constexpr double kInnerLimit = 0.9999;  // of those fed to the formula while correcting
constexpr int kMaxCorrections = 40;
constexpr double kTolerance = 1e-9;
constexpr std::size_t kFinePerDirection = 8;
constexpr std::size_t kNumFine = kFinePerDirection * kNumDirections;

struct Coefficients {
  Complex c1;
  Complex c2;
};

// e^{-i theta} at the middles of eight parts of each direction's 5 degrees.
const std::array<Complex, kNumFine>& fine_phases() {
  static const std::array<Complex, kNumFine> kPhases = [] {
    std::array<Complex, kNumFine> phases;
    for (std::size_t i = 0; i < kNumFine; ++i) {
      const double part = static_cast<double>(i) + 0.5 - 0.5 * static_cast<double>(kFinePerDirection);
      phases[i] = std::polar(1.0, -kTwoPi * part / static_cast<double>(kNumFine));
    }
    return phases;
  }();
  return kPhases;
}

// f2 = (c2 - c1^2) / (1 - |c1|^2): the reflection coefficient whose length must stay below 1.
Coefficients admissible(const Coefficients& given, double limit, bool& clamped) {
  Coefficients out = given;
  if (std::abs(out.c1) > limit) {
    out.c1 *= limit / std::abs(out.c1);
    clamped = true;
  }
  const double room = 1.0 - std::norm(out.c1);
  Complex f2 = (out.c2 - out.c1 * out.c1) / room;
  if (std::abs(f2) > limit) {
    f2 *= limit / std::abs(f2);
    out.c2 = out.c1 * out.c1 + room * f2;
    clamped = true;
  }
  return out;
}

std::array<double, kNumDirections> on_grid(const Coefficients& c) {
  const Complex f1 = (c.c1 - c.c2 * std::conj(c.c1)) / (1.0 - std::norm(c.c1));
  const Complex f2 = c.c2 - c.c1 * f1;
  std::array<double, kNumDirections> density{};
  double sum = 0.0;
  for (std::size_t i = 0; i < kNumFine; ++i) {
    const Complex e = fine_phases()[i];
    const double value = 1.0 / std::norm(1.0 - e * (f1 + e * f2));
    density[i / kFinePerDirection] += value;
    sum += value;
  }
  const double scale = static_cast<double>(kNumDirections) / (kTwoPi * sum);
  for (double& d : density) {
    d *= scale;
  }
  return density;
}

Coefficients coefficients_of(const std::array<double, kNumDirections>& density) {
  constexpr double kStep = kTwoPi / static_cast<double>(kNumDirections);
  Coefficients c;
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    const double angle = kStep * static_cast<double>(d);
    c.c1 += density[d] * kStep * std::polar(1.0, angle);
    c.c2 += density[d] * kStep * std::polar(1.0, 2.0 * angle);
  }
  return c;
}

}  // namespace

DirectionalDistribution maximum_entropy(Complex c1, Complex c2) {
  DirectionalDistribution best;
  const Coefficients wanted = admissible({c1, c2}, kLimit, best.clamped);
  Coefficients fed = wanted;
  best.residual = 10.0;
  for (int i = 0; i < kMaxCorrections && best.residual > kTolerance; ++i) {
    const auto density = on_grid(fed);
    const Coefficients got = coefficients_of(density);
    const double residual = std::max(std::abs(wanted.c1 - got.c1), std::abs(wanted.c2 - got.c2));
    if (residual < best.residual) {
      best.residual = residual;
      best.density = density;
    }
    bool ignored = false;
    fed = admissible({fed.c1 + wanted.c1 - got.c1, fed.c2 + wanted.c2 - got.c2}, kInnerLimit, ignored);
  }
  return best;
}

}  // namespace quickstrip
