#include "sim/section_table/spline_coefficients.hpp"

#include "core/base/check.hpp"
#include "core/base/interpolation.hpp"
#include "sim/section_table/linear_solve.hpp"

namespace quickstrip {
namespace {

// Along the axis whose neighbouring values lie `stride` apart.
void replace_along(std::span<const double> nodes, std::size_t stride, std::vector<double>& values) {
  const std::size_t n = nodes.size();
  std::vector<double> matrix(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    const SplineStencil stencil = spline_stencil(nodes, nodes[i]);
    for (std::size_t k = 0; k < 4; ++k) {
      matrix[i * n + stencil.first + k] = stencil.weight[k];
    }
  }
  const std::size_t num_lines = values.size() / n;
  const auto place = [n, stride](std::size_t line, std::size_t i) {
    return (line / stride * n + i) * stride + line % stride;
  };
  std::vector<double> lines(values.size());
  for (std::size_t line = 0; line < num_lines; ++line) {
    for (std::size_t i = 0; i < n; ++i) {
      lines[line * n + i] = values[place(line, i)];
    }
  }
  solve_in_place(matrix, lines, n, num_lines);
  for (std::size_t line = 0; line < num_lines; ++line) {
    for (std::size_t i = 0; i < n; ++i) {
      values[place(line, i)] = lines[line * n + i];
    }
  }
}

}  // namespace

void replace_by_spline_coefficients(const std::array<std::span<const double>, 3>& nodes,
                                    std::size_t num_quantities, std::vector<double>& values) {
  QS_CHECK(values.size() == nodes[0].size() * nodes[1].size() * nodes[2].size() * num_quantities);
  replace_along(nodes[2], num_quantities, values);
  replace_along(nodes[1], nodes[2].size() * num_quantities, values);
  replace_along(nodes[0], nodes[1].size() * nodes[2].size() * num_quantities, values);
}

}  // namespace quickstrip
