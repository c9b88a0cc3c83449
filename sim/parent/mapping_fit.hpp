// Least squares behind close_fit: the powers of a conformal mapping nearest to a contour.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim/parent/section_contour.hpp"
#include "sim/section_table/conformal_mapping.hpp"

namespace quickstrip {

/// w = -{x_0 Z + sum_n x_n Z^{-(2n-1)}} [m]; whether it is conformal has not been asked.
struct MappingFit {
  std::array<double, kMaxMappingCoefficients + 1> powers{};
  std::size_t num_coefficients = 0;
  double rms_error = 0.0;      // m, along the contour's length
  double largest_error = 0.0;  // m, of the contour's points from the mapped one
};

class MappingFitter {
 public:
  /// A surface-piercing contour.
  explicit MappingFitter(const SectionContour& contour);

  /// The fit with one coefficient more than the last (the first: 1, an ellipse).
  MappingFit next();

 private:
  struct Sample {
    Offset point;
    double weight = 0.0;  // share of the length
    double theta = 0.0;   // of the nearest point of the mapped contour
  };
  void project(const MappingFit& fit, std::vector<Sample>& samples) const;
  [[nodiscard]] MappingFit step(const MappingFit& fit, double damping) const;

  std::vector<Sample> samples_;
  MappingFit fit_;
};

}  // namespace quickstrip
