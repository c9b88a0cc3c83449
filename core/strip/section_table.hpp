// Added mass and damping of Lewis sections from a table, by second-degree Lagrange interpolation in breadth-
// draught ratio, fullness and frequency, as SEAQUICK does [Journee1992] §4, neighbouring parabolas blended.
// What is interpolated are smooth quantities, scaled by closed forms (core/hull/section_coordinates.hpp):
// added masses (heave less its logarithm) and signed wave amplitudes, so that b33, b22, b44 >= 0 and b24^2 =
// b22 b44 hold exactly. Assumes deep water and what the Lewis form assumes. Range: 0.05 <= H0 <= 10, sigma
// from the re-entrant limit to the upper limit of the Lewis form, every frequency: exact limits at zero,
// asymptotes above the last node.
// Expected error against the direct solution (`quickstrip-section-table --accuracy 4000`; 24 and 44 to the
// 22-44 mean): practical forms, median <= 0.011 %, 99 % of points <= 0.33 %, b24 0.8 %; bulbous and tunnelled
// ones, median <= 0.013 %, 99 % <= 0.9 %. Worst b33, b44 4.5 % next to the re-entrant limit at H0 = 1, b24
// 11 % where the lever changes sign.
// Cost: a column 0.2 us, coefficients 0.35 us, measured; 328,208 bytes of constants.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/interpolation.hpp"
#include "core/base/result.hpp"
#include "core/hull/section_coefficients.hpp"
#include "core/hull/section_coordinates.hpp"

namespace quickstrip {

/// Weights of four neighbouring nodes: between two nodes, the parabola through the three to the left and that
/// to the right (second-degree Lagrange) blend linearly. Without it the parabolas leave steps, which slopes
/// over frequency and the ship's length would see. At the ends the one parabola alone.
struct ParabolicBlend {
  std::size_t first = 0;
  std::array<double, 4> weight{};
};

/// The position of a section in the table and its scales; made by section_table_column.
struct SectionTableColumn {
  ParabolicBlend h0;
  ParabolicBlend fullness;
  std::array<SectionQuantities, 4> scales{};  // at the section's H0, at the four nodes of fullness
  std::array<double, 4> bluntness{};          // at the same places
  LewisAddedMass lateral_at_infinity;
  double heave_at_infinity = 0.0;
  double breadth = 0.0;  // B / M
  double area = 0.0;     // A / M^2
};

/// kNotFinite; kOutOfRange outside the table.
Result<SectionTableColumn> section_table_column(double h0, double sigma);

/// xi = omega^2 B / 2g >= 0, finite, of the section used. a33 grows as -ln xi towards xi = 0 and is given for
/// xi = 1e-12 below that. Normalised as section_coefficients.hpp says.
SectionCoefficients section_coefficients(const SectionTableColumn& column, double xi);

/// The checksum over the data as they are in memory. Cost: about 1 ms.
bool section_table_is_intact();
std::uint32_t section_table_version();
std::uint64_t section_table_checksum();
std::size_t section_table_numbers();  // stored, nodes included
std::size_t section_table_bytes();

}  // namespace quickstrip
