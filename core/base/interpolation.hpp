// Interpolation between unequally spaced nodes, [Journee1992] §4: second-degree Lagrange polynomials, and the
// Theilheimer polynomial, which is the not-a-knot cubic spline.
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

/// Weights of the polynomial through all `nodes`, into the first of `weights`. `nodes` distinct, at most as
/// many as weights.
void lagrange_weights(std::span<const double> nodes, double x, std::span<double> weights);

/// Where x lies in a not-a-knot cubic spline: the first of four neighbouring coefficients, and the cubic
/// B-splines at x that multiply them (their sum is 1).
struct SplineStencil {
  std::size_t first = 0;
  std::array<double, 4> weight{};
};

/// The spline through n nodes has n coefficients, so it takes no more memory than the values; they follow
/// from the values by a linear system that is solved beforehand. Its knots are the nodes but the second and
/// the last but one: one cubic over the first two intervals, and over the last two. `nodes` strictly
/// increasing, at least four. Outside the nodes the end cubic is continued. Cost: about 20 ns.
SplineStencil spline_stencil(std::span<const double> nodes, double x);

}  // namespace quickstrip
