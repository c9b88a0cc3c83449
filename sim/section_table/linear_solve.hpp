// Dense linear equations by Gaussian elimination with partial pivoting.
#pragma once

#include <cstddef>
#include <vector>

namespace quickstrip {

/// matrix: n x n by rows, destroyed. right: columns of n one after the other, replaced by the solutions.
void solve_in_place(std::vector<double>& matrix, std::vector<double>& right, std::size_t n,
                    std::size_t num_columns);

}  // namespace quickstrip
