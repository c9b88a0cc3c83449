#include "sim/section_table/linear_solve.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/check.hpp"

namespace quickstrip {

void solve_in_place(std::vector<double>& matrix, std::vector<double>& right, std::size_t n,
                    std::size_t num_columns) {
  QS_CHECK(matrix.size() == n * n && right.size() >= n * num_columns);
  const auto row = [&matrix, n](std::size_t i) { return std::span<double>(matrix).subspan(i * n, n); };
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(row(i)[k]) > std::abs(row(pivot)[k])) {
        pivot = i;
      }
    }
    if (pivot != k) {
      std::swap_ranges(row(k).begin(), row(k).end(), row(pivot).begin());
      for (std::size_t c = 0; c < num_columns; ++c) {
        std::swap(right[c * n + k], right[c * n + pivot]);
      }
    }
    const double* const from = row(k).data();
    for (std::size_t i = k + 1; i < n; ++i) {
      double* const to = row(i).data();
      const double factor = to[k] / from[k];
      for (std::size_t j = k + 1; j < n; ++j) {
        to[j] -= factor * from[j];
      }
      for (std::size_t c = 0; c < num_columns; ++c) {
        right[c * n + i] -= factor * right[c * n + k];
      }
    }
  }
  for (std::size_t c = 0; c < num_columns; ++c) {
    for (std::size_t k = n; k-- > 0;) {
      double value = right[c * n + k];
      for (std::size_t j = k + 1; j < n; ++j) {
        value -= row(k)[j] * right[c * n + j];
      }
      right[c * n + k] = value / row(k)[k];
    }
  }
}

}  // namespace quickstrip
