// Gauss-Legendre points on the quarter contour, clustered towards the waterline, where the potential of an
// oscillating section has its weak singularity.
#pragma once

#include <cstddef>
#include <vector>

namespace quickstrip {

/// theta = (pi/2)(1 - (1-v)^2), v the Gauss points of (0, 1).
class ContourQuadrature {
 public:
  explicit ContourQuadrature(int num_points);
  [[nodiscard]] std::size_t size() const { return theta_.size(); }
  [[nodiscard]] double theta(std::size_t j) const { return theta_[j]; }
  [[nodiscard]] double weight(std::size_t j) const { return weight_[j]; }

 private:
  std::vector<double> theta_;
  std::vector<double> weight_;
};

/// The rule of this many points, made once and kept. Not for several threads.
const ContourQuadrature& contour_quadrature(int num_points);

}  // namespace quickstrip
