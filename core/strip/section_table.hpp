// Added mass and damping of Lewis sections from a table over breadth-draught ratio, fullness and frequency,
// as SEAQUICK has it [Journee1992] §4, by the Theilheimer polynomial (not-a-knot cubic spline) that the paper
// recommends for more speed and accuracy; its coefficients are stored, one for each node.
// What is interpolated are smooth quantities, scaled by closed forms (core/hull/section_coordinates.hpp):
// added masses (heave less its logarithm) and signed wave amplitudes, so that b33, b22, b44 >= 0 and b24^2 =
// b22 b44 hold exactly. A section's column, the spline over frequency alone, is worked out once.
// Assumes deep water and what the Lewis form assumes. Range: 0.05 <= H0 <= 10, sigma from the re-entrant
// limit to the upper limit of the Lewis form, every frequency: exact limits at zero, asymptotes above the
// last node.
// Expected error against the direct solution (`quickstrip-section-table --accuracy 10000`, which prints
// Lagrange interpolation on the same nodes beside it; 24 and 44 to the 22-44 mean): median <= 0.0024 %; of
// practical forms 99 % of points <= 0.04 %, of bulbous and tunnelled ones <= 0.07 %; worst 0.9 %, b22 next to
// the re-entrant limit at xi = 39. The direct solution itself is within 0.02 % of boundary elements.
// Cost: a column 1.4 us, coefficients 0.08 us, measured; 952 bytes a column, 237,080 bytes of constants.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/result.hpp"
#include "core/hull/section_coefficients.hpp"
#include "core/hull/section_coordinates.hpp"

namespace quickstrip {

/// What the coefficients need beside the smooth quantities: closed forms of the section.
struct TabulatedForm {
  double bluntness = 0.0;
  LewisAddedMass lateral_at_infinity;
  double heave_at_infinity = 0.0;
  double breadth = 0.0;  // B / M
  double area = 0.0;     // A / M^2
};

/// A section's part of the table; made by section_table_column.
struct SectionTableColumn {
  TabulatedForm form;
  /// Coefficients of the spline over frequency, times the scales: [frequency][quantity].
  std::array<float, kNumTabulatedFrequencies * kNumSectionQuantities> spline{};
};

/// Where a section lies in the table.
struct TablePosition {
  double log_h0 = 0.0;
  double fullness = 0.0;
  SectionQuantities scales{};
  TabulatedForm form;
};

/// kNotFinite; kOutOfRange outside the table.
Result<SectionTableColumn> section_table_column(double h0, double sigma);

/// xi = omega^2 B / 2g >= 0, finite, of the section used. a33 grows as -ln xi towards xi = 0 and is given for
/// xi = 1e-12 below that. Normalised as section_coefficients.hpp says.
SectionCoefficients section_coefficients(const SectionTableColumn& column, double xi);

/// The two halves of the above, for whoever interpolates otherwise: the place of a section, and coefficients
/// from the smooth quantities (not scaled) at kappa_in_table.
Result<TablePosition> table_position(double h0, double sigma);
double kappa_in_table(const TabulatedForm& form, double xi);  // at most that of the last node
SectionCoefficients coefficients_of(const TabulatedForm& form, SectionQuantities smooth, double xi);

/// The checksum over the data as they are in memory. Cost: about 0.1 ms.
bool section_table_is_intact();
std::uint32_t section_table_version();
std::uint64_t section_table_checksum();
std::size_t section_table_numbers();  // stored, nodes included
std::size_t section_table_bytes();

}  // namespace quickstrip
