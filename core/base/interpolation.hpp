// Second-degree Lagrange interpolation, as in [Journee1992] §4.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace quickstrip {

/// Where x lies among the nodes: the first of three neighbouring nodes, and the three weights (their sum is
/// 1).
struct LagrangeStencil {
  std::size_t first = 0;
  std::array<double, 3> weight{};
};

/// Weights of the parabola through the three nodes nearest to x. `nodes` strictly increasing, at least three.
/// Outside the nodes the end parabola is continued: callers keep x inside or know what they do.
LagrangeStencil lagrange_stencil(std::span<const double> nodes, double x);

}  // namespace quickstrip
