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

}  // namespace
}  // namespace quickstrip
