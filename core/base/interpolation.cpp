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

}  // namespace quickstrip
