#include "sim/section_table/contour_quadrature.hpp"

#include <cmath>
#include <map>

#include "core/base/constants.hpp"

namespace quickstrip {

ContourQuadrature::ContourQuadrature(int num_points) {
  for (int i = 0; i < num_points; ++i) {
    // Newton on the Legendre polynomial, from Tricomi's estimate of its root.
    double x = std::cos(kPi * (i + 0.75) / (num_points + 0.5));
    double slope = 0.0;
    for (int step = 0; step < 6; ++step) {
      double previous = 1.0;
      double value = x;
      for (int n = 2; n <= num_points; ++n) {
        const double next = ((2.0 * n - 1.0) * x * value - (n - 1.0) * previous) / n;
        previous = value;
        value = next;
      }
      slope = num_points * (x * value - previous) / (x * x - 1.0);
      x -= value / slope;
    }
    const double gauss_weight = 2.0 / ((1.0 - x * x) * slope * slope);
    const double from_waterline = 0.5 * (1.0 + x);  // 1 - v
    theta_.push_back(0.5 * kPi * (1.0 - from_waterline * from_waterline));
    weight_.push_back(0.5 * gauss_weight * kPi * from_waterline);
  }
}

const ContourQuadrature& contour_quadrature(int num_points) {
  static std::map<int, ContourQuadrature> rules;
  return rules.try_emplace(num_points, num_points).first->second;
}

}  // namespace quickstrip
