// The error of the section table against the direct solution at seeded random points, off the nodes: by the
// spline that core uses, and by Lagrange interpolation on the same nodes. And what both cost.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "core/hull/section_coefficients.hpp"

namespace quickstrip {

inline constexpr std::size_t kNumCoefficients = 8;
std::array<double, kNumCoefficients> as_array(const SectionCoefficients& c);  // order of the contract
const char* coefficient_name(std::size_t k);

/// kPractical: re-entrant limit ... conventional limit x 1.05 (real midships lie above the conventional
/// limit: S-175, sigma 0.968 at H0 1.337). kFull: from there to the upper limit of the Lewis form.
enum class SectionRegion { kPractical, kFull };

/// Errors of every coefficient at every point, sorted. Relative; 24 to the 22-44 mean, 44 to itself or that
/// mean if larger; where a value crosses zero, to 1 % of its largest over frequency.
using CoefficientErrors = std::array<std::vector<double>, kNumCoefficients>;

struct AccuracyStudy {
  CoefficientErrors spline;
  CoefficientErrors lagrange;
  std::array<double, kNumCoefficients> worst_h0{};  // of the spline
  std::array<double, kNumCoefficients> worst_sigma{};
  std::array<double, kNumCoefficients> worst_xi{};
  std::size_t not_converged = 0;
};

/// H0 log-uniform over the table, sigma uniform over the region, xi log-uniform 0.001 ... 40. The direct
/// solution has 1.5 times the multipoles that the adaptive one asked for.
AccuracyStudy measure_accuracy(SectionRegion region, int num_points, std::uint32_t seed);

/// share 0 ... 1 of sorted errors: 0.5 the median, 1 the worst.
double quantile(const std::vector<double>& sorted, double share);

void print_accuracy(const AccuracyStudy& study, const char* title, std::ostream& out);

/// Nanoseconds for a section's column and for its coefficients at one frequency, by a plain loop; the
/// benchmark is tests/bench/section_table_bench.cpp.
void print_times(std::ostream& out);

}  // namespace quickstrip
