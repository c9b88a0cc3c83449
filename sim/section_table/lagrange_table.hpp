// The section table by second-degree Lagrange interpolation, as [Journee1992] §4 has it, for comparison with
// the spline that core uses: the same nodes, and the values that the spline has there.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/strip/section_table.hpp"

namespace quickstrip {

/// As SectionTableColumn; values at the nodes of frequency instead of spline coefficients.
struct LagrangeColumn {
  TabulatedForm form;
  std::array<float, kNumTabulatedFrequencies * kNumSectionQuantities> values{};
};

class LagrangeTable {
 public:
  LagrangeTable();
  [[nodiscard]] Result<LagrangeColumn> column(double h0, double sigma) const;

  /// Scaled smooth quantities at a node: [log H0 below, above][fullness][frequency].
  [[nodiscard]] SectionQuantities at_node(std::size_t h0, std::size_t fullness, std::size_t frequency) const;

 private:
  std::vector<float> values_;  // laid out as the coefficients in core
};

SectionCoefficients section_coefficients(const LagrangeColumn& column, double xi);

}  // namespace quickstrip
