#include "sim/parent/least_squares.hpp"

#include <cmath>

namespace quickstrip {
namespace {

// x -= 2 v (v.x), v of unit length
void reflect(const double* v, double* x, std::size_t n, double twice_by_norm) {
  double dot = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    dot += v[i] * x[i];
  }
  dot *= twice_by_norm;
  for (std::size_t i = 0; i < n; ++i) {
    x[i] -= dot * v[i];
  }
}

}  // namespace

void least_squares(std::vector<double>& matrix, std::vector<double>& right, std::size_t rows,
                   std::size_t columns) {
  const std::size_t num_right = right.size() / rows;
  std::vector<double> diagonal(columns);
  for (std::size_t j = 0; j < columns; ++j) {
    double* v = &matrix[j * rows + j];
    const std::size_t n = rows - j;
    double square = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      square += v[i] * v[i];
    }
    const double size = std::copysign(std::sqrt(square), v[0]);
    diagonal[j] = -size;
    v[0] += size;
    const double twice_by_norm = 1.0 / (size * v[0]);
    for (std::size_t k = j + 1; k < columns; ++k) {
      reflect(v, &matrix[k * rows + j], n, twice_by_norm);
    }
    for (std::size_t k = 0; k < num_right; ++k) {
      reflect(v, &right[k * rows + j], n, twice_by_norm);
    }
  }
  for (std::size_t k = 0; k < num_right; ++k) {
    double* x = &right[k * rows];
    for (std::size_t j = columns; j-- > 0;) {
      x[j] /= diagonal[j];
      for (std::size_t i = 0; i < j; ++i) {
        x[i] -= x[j] * matrix[j * rows + i];
      }
    }
  }
}

}  // namespace quickstrip
