// Computes the whole section table and writes it as the C++ source that core holds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <span>
#include <vector>

namespace quickstrip {

struct GeneratedTable {
  std::vector<float> coefficients;  // of the spline, as core/strip/section_table_data.hpp lays them out
  std::size_t not_converged = 0;
  int most_multipoles = 0;
};

/// About a minute on one core. `progress` is called with the share done, 0 ... 1; may be empty.
GeneratedTable generate_table(const std::function<void(double)>& progress);

/// 1: values, for Lagrange interpolation; 2: coefficients of a spline.
inline constexpr std::uint32_t kSectionTableVersion = 2;

/// FNV-1a 64 of version, nodes and coefficients, as core recomputes it.
std::uint64_t table_checksum(const GeneratedTable& table);

void write_table(const GeneratedTable& table, std::ostream& out);

/// Largest difference of a coefficient from another table of the same nodes, relative to 1 + |coefficient|.
double largest_difference(const GeneratedTable& table, std::span<const float> coefficients);

}  // namespace quickstrip
