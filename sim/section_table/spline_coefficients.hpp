// Coefficients of the not-a-knot cubic spline (Theilheimer polynomial) through values on a grid; what
// core/base/interpolation.hpp evaluates.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace quickstrip {

/// values: [first axis][second][third][quantity], replaced by as many coefficients. Nodes of an axis: four or
/// more, strictly increasing. The collocation matrix is banded, positive and well conditioned: rounding only.
void replace_by_spline_coefficients(const std::array<std::span<const double>, 3>& nodes,
                                    std::size_t num_quantities, std::vector<double>& values);

}  // namespace quickstrip
