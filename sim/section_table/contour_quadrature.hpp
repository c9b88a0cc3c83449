// Gauss-Legendre points on the quarter contour, clustered towards the waterline, where the potential of an
// oscillating section has its weak singularity.
#pragma once

#include <cstddef>
#include <span>
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

/// The rule of this many points, made once and kept; several threads may ask.
const ContourQuadrature& contour_quadrature(int num_points);

/// cos f theta and sin f theta, f = 0 ... top_frequency, at the points of a rule.
class ContourHarmonics {
 public:
  ContourHarmonics(const ContourQuadrature& rule, std::size_t top_frequency);
  [[nodiscard]] const ContourQuadrature& rule() const { return *rule_; }
  [[nodiscard]] std::size_t count() const { return count_; }  // top frequency + 1
  [[nodiscard]] std::span<const double> cosines(std::size_t j) const { return row(cosines_, j); }
  [[nodiscard]] std::span<const double> sines(std::size_t j) const { return row(sines_, j); }

 private:
  [[nodiscard]] std::span<const double> row(const std::vector<double>& table, std::size_t j) const {
    return std::span<const double>(table).subspan(j * count_, count_);
  }
  const ContourQuadrature* rule_;
  std::size_t count_;
  std::vector<double> cosines_;
  std::vector<double> sines_;
};

/// Of the rule of this many points, made once and kept; several threads may ask.
const ContourHarmonics& contour_harmonics(int num_points, std::size_t top_frequency);

}  // namespace quickstrip
