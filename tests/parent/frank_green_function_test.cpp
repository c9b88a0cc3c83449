// The wave source: its function F against the exponential integral, its integrals along a panel against
// quadrature, and the conditions that make it one.
#include "sim/parent/green_function.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "core/base/constants.hpp"
#include "sim/section_table/exponential_integral.hpp"

namespace quickstrip {
namespace {

using Complex = std::complex<double>;

Complex integral_at(Complex w, double k) {
  return wave_integral(w, k, std::log(-w), std::exp(k * w));
}

TEST(WaveIntegral, IsTheExponentialIntegralOfTheTableGenerator) {
  // F = e^{Kw} {E1(Kw) + i pi}, by other series at other places (to 1e-13 of scipy.special.exp1).
  for (int ring = -60; ring < 34; ++ring) {  // |t| of 1e-6 ... 1700
    for (int ray = 0; ray <= 32; ++ray) {
      const Complex t = std::polar(std::exp(0.225 * ring), 0.5 * kPi * (1.0 + ray / 32.0));
      const Complex w(std::min(0.0, t.real()), t.imag());
      const Complex expected = scaled_exponential_integral(w) + Complex(0.0, kPi) * std::exp(w);
      // The power series' cancellation, e^8 of 2e-16, and where the fraction stops.
      EXPECT_LT(std::abs(integral_at(w, 1.0) - expected), 5e-12 * std::abs(expected)) << w;
      EXPECT_LT(std::abs(integral_at(std::conj(w), 1.0) - std::conj(expected)), 5e-12 * std::abs(expected));
    }
  }
}

// In phase with the source: ln|u| - ln|W| - 2 Re F(W).
double source(Complex point, Complex at, double k) {
  const Complex image = point + std::conj(at);
  return std::log(std::abs(point - at)) - std::log(std::abs(image)) - 2.0 * integral_at(image, k).real();
}

TEST(WaveSource, ObeysTheConditionOfTheFreeSurface) {
  for (const double k : {0.02, 0.3, 1.0, 4.0}) {
    for (const double y : {-3.0, -0.2, 0.4, 2.5}) {
      const Complex at(-0.8, 0.1);
      constexpr double step = 1e-4;
      const double here = source({0.0, y}, at, k);
      const double slope =
          (3.0 * here - 4.0 * source({-step, y}, at, k) + source({-2.0 * step, y}, at, k)) / (2.0 * step);
      EXPECT_NEAR(slope, k * here, 1e-6);  // one-sided difference, step^2
    }
  }
}

constexpr std::array<double, 5> kNode = {-0.906179845938664, -0.538469310105683, 0.0, 0.538469310105683,
                                         0.906179845938664};
constexpr std::array<double, 5> kWeight = {0.236926885056189, 0.478628670499366, 0.568888888888889,
                                           0.478628670499366, 0.236926885056189};

template <typename Function>
double integrated(Complex from, Complex to, Function f) {  // 40 pieces of five points
  double total = 0.0;
  for (int piece = 0; piece < 40; ++piece) {
    for (std::size_t i = 0; i < kNode.size(); ++i) {
      total += kWeight[i] * f(from + (to - from) * ((piece + 0.5 * (1.0 + kNode[i])) / 40.0));
    }
  }
  return total * std::abs(to - from) / 80.0;
}

TEST(PointOfChain, GivesTheIntegralsOfTheSourceOverPanels) {
  const std::vector<Complex> ends = {{-2.0, 0.0}, {-1.7, 0.6}, {-0.9, 1.4}, {0.0, 1.3}};
  // The mirror image of a point looks at panels across the centre plane, where Im W changes sign.
  for (const Complex point :
       {Complex(-1.2, 0.4), Complex(-1.2, -0.4), Complex(0.0, 0.5), Complex(-3.0, 1.0)}) {
    const PointOfChain chain(point, ends, -1);
    for (const double k : {0.05, 0.7, 3.0}) {
      std::vector<Complex> waves;
      for (const Complex end : ends) {
        waves.push_back(std::exp(k * end));
      }
      std::vector<PanelInfluence> influence;
      chain.influence(k, waves, influence);
      for (std::size_t j = 0; j + 1 < ends.size(); ++j) {
        const Complex normal = Complex(0.0, 1.0) * (ends[j + 1] - ends[j]) / std::abs(ends[j + 1] - ends[j]);
        constexpr double step = 1e-5;
        const double potential =
            integrated(ends[j], ends[j + 1], [&](Complex at) { return source(point, at, k); });
        const double slope = integrated(ends[j], ends[j + 1], [&](Complex at) {
          // away from the surface: nothing lies above it
          const Complex inner = at.real() + step * normal.real() > 0.0 ? Complex(-step, 0.0) : Complex();
          return (source(point, at + inner + step * normal, k) -
                  source(point, at + inner - step * normal, k)) /
                 (2.0 * step);
        });
        EXPECT_NEAR(influence[j].potential, potential, 1e-8) << point << k << j;
        EXPECT_NEAR(influence[j].normal, slope, 1e-4) << point << k << j;  // differences, and moved by 1e-5
      }
    }
  }
}

}  // namespace
}  // namespace quickstrip
