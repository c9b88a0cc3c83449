// Computes the whole section table and writes it as the C++ source that core holds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <vector>

namespace quickstrip {

struct GeneratedTable {
  std::vector<float> values;
  std::size_t not_converged = 0;
  int most_multipoles = 0;
};

/// About a minute on one core. `progress` is called with the share done, 0 ... 1; may be empty.
GeneratedTable generate_table(const std::function<void(double)>& progress);

inline constexpr std::uint32_t kSectionTableVersion = 1;

/// FNV-1a 64 of version, nodes and values, as core recomputes it.
std::uint64_t table_checksum(const GeneratedTable& table);

void write_table(const GeneratedTable& table, std::ostream& out);

/// Largest difference of a value from another table of the same nodes, relative to 1 + |value|.
double largest_difference(const GeneratedTable& table, std::size_t num_values, const float* values);

}  // namespace quickstrip
