#include "sim/section_table/contour_quadrature.hpp"

#include <cmath>
#include <map>
#include <mutex>
#include <utility>

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
  static std::map<int, ContourQuadrature> rules;  // its members stay where they are
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  return rules.try_emplace(num_points, num_points).first->second;
}

ContourHarmonics::ContourHarmonics(const ContourQuadrature& rule, std::size_t top_frequency)
    : rule_(&rule), count_(top_frequency + 1), cosines_(rule.size() * count_), sines_(rule.size() * count_) {
  for (std::size_t j = 0; j < rule.size(); ++j) {
    for (std::size_t f = 0; f < count_; ++f) {
      const double angle = static_cast<double>(f) * rule.theta(j);
      cosines_[j * count_ + f] = std::cos(angle);
      sines_[j * count_ + f] = std::sin(angle);
    }
  }
}

const ContourHarmonics& contour_harmonics(int num_points, std::size_t top_frequency) {
  static std::map<std::pair<int, std::size_t>, ContourHarmonics> tables;
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  const auto key = std::pair(num_points, top_frequency);
  const auto found = tables.find(key);
  return found != tables.end()
             ? found->second
             : tables.try_emplace(key, contour_quadrature(num_points), top_frequency).first->second;
}

}  // namespace quickstrip
