#include "core/base/interpolation.hpp"

#include <algorithm>

#include "core/base/check.hpp"

namespace quickstrip {

LagrangeStencil lagrange_stencil(std::span<const double> nodes, double x) {
  QS_CHECK(nodes.size() >= 3);
  // The middle node of the stencil is the node nearest to x, kept off both ends.
  const auto above = std::lower_bound(nodes.begin(), nodes.end(), x);
  std::size_t nearest = static_cast<std::size_t>(above - nodes.begin());
  if (nearest == nodes.size() || (nearest > 0 && x - nodes[nearest - 1] < nodes[nearest] - x)) {
    --nearest;
  }
  const std::size_t middle = std::clamp<std::size_t>(nearest, 1, nodes.size() - 2);

  LagrangeStencil stencil;
  stencil.first = middle - 1;
  const double x0 = nodes[middle - 1];
  const double x1 = nodes[middle];
  const double x2 = nodes[middle + 1];
  stencil.weight[0] = (x - x1) * (x - x2) / ((x0 - x1) * (x0 - x2));
  stencil.weight[1] = (x - x0) * (x - x2) / ((x1 - x0) * (x1 - x2));
  stencil.weight[2] = (x - x0) * (x - x1) / ((x2 - x0) * (x2 - x1));
  return stencil;
}

void lagrange_weights(std::span<const double> nodes, double x, std::span<double> weights) {
  QS_CHECK(nodes.size() <= weights.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    weights[i] = 1.0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      weights[i] *= n == i ? 1.0 : (x - nodes[n]) / (nodes[i] - nodes[n]);
    }
  }
}

SplineStencil spline_stencil(std::span<const double> nodes, double x) {
  const std::size_t n = nodes.size();
  QS_CHECK(n >= 4);
  // Knots: first node four times, all but the second and the last but one, last node four times.
  const auto above =
      static_cast<std::size_t>(std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin());
  SplineStencil stencil;
  stencil.first = std::clamp<std::size_t>(above, 2, n - 2) - 2;
  std::array<double, 6> knot{};  // three on either side of x
  for (std::size_t i = 0; i < knot.size(); ++i) {
    const std::size_t k = stencil.first + 1 + i;
    knot[i] = k < 4 ? nodes.front() : k < n ? nodes[k - 2] : nodes.back();
  }
  // B-splines of degree 1, 2, 3 from those one lower [deBoor1972].
  std::array<double, 4>& b = stencil.weight;
  b[0] = 1.0;
  for (std::size_t degree = 1; degree < 4; ++degree) {
    double carried = 0.0;
    for (std::size_t i = 0; i < degree; ++i) {
      const double right = knot[3 + i];
      const double left = knot[3 + i - degree];
      const double share = b[i] / (right - left);
      b[i] = carried + (right - x) * share;
      carried = (x - left) * share;
    }
    b[degree] = carried;
  }
  return stencil;
}

}  // namespace quickstrip
