// Dense real equations, as many as unknowns or more, by Householder reflections.
// (Not Eigen: its allocation is forbidden by macro in core, and a program may hold one definition only.)
#pragma once

#include <cstddef>
#include <vector>

namespace quickstrip {

/// matrix: columns of `rows` one after the other, rows >= columns, destroyed. right: right-hand sides of
/// `rows` one after the other; the first `columns` values of each are replaced by the solution.
void least_squares(std::vector<double>& matrix, std::vector<double>& right, std::size_t rows,
                   std::size_t columns);

}  // namespace quickstrip
