#include "core/base/interpolation.hpp"

#include <gtest/gtest.h>

#include <array>

namespace quickstrip {
namespace {

TEST(LagrangeStencil, ReproducesAParabolaOnUnevenNodes) {
  const std::array<double, 5> nodes = {0.0, 0.3, 1.0, 1.2, 4.0};
  const auto parabola = [](double x) { return 3.0 - 2.0 * x + 0.5 * x * x; };
  for (double x = -0.5; x < 5.0; x += 0.05) {
    const LagrangeStencil s = lagrange_stencil(nodes, x);
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += s.weight[i] * parabola(nodes[s.first + i]);
    }
    EXPECT_NEAR(sum, parabola(x), 1e-13) << x;  // rounding only
  }
}

// Coefficients of x^n in B-splines are symmetric means of the three inner knots (Marsden's identity), written
// here from the knots; independent of any solved system.
TEST(SplineStencil, ReproducesACubicFromTheBlossomsOfItsKnots) {
  const std::array<double, 7> nodes = {0.0, 0.3, 1.0, 1.2, 2.5, 3.5, 4.0};
  // First node four times, not the second nor the last but one, last node four times.
  const std::array<double, 11> knots = {0.0, 0.0, 0.0, 0.0, 1.0, 1.2, 2.5, 4.0, 4.0, 4.0, 4.0};
  const auto cubic = [](double x) { return 3.0 - 2.0 * x + 0.5 * x * x - 0.7 * x * x * x; };
  std::array<double, 7> coefficients{};
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const double a = knots[i + 1];
    const double b = knots[i + 2];
    const double c = knots[i + 3];
    coefficients[i] = 3.0 - 2.0 * (a + b + c) / 3.0 + 0.5 * (a * b + b * c + c * a) / 3.0 - 0.7 * a * b * c;
  }
  for (double x = -0.2; x < 4.3; x += 0.05) {
    const SplineStencil s = spline_stencil(nodes, x);
    ASSERT_LE(s.first + 4, nodes.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      sum += s.weight[i] * coefficients[s.first + i];
    }
    EXPECT_NEAR(sum, cubic(x), 1e-12) << x;  // rounding only
  }
}

TEST(SplineStencil, WeightsAreNotNegativeAndSumToOneWithinTheNodes) {
  const std::array<double, 4> nodes = {-1.0, 0.0, 0.5, 4.0};  // the least: one cubic
  for (double x = -1.0; x <= 4.0; x += 0.01) {
    const SplineStencil s = spline_stencil(nodes, x);
    EXPECT_EQ(s.first, 0U);
    double sum = 0.0;
    for (const double weight : s.weight) {
      EXPECT_GE(weight, -1e-15);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
  }
}

}  // namespace
}  // namespace quickstrip
