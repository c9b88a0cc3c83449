// Sums over arrays in groups of four, so that the compiler may use vectors without reordering anything.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/capacity.hpp"

namespace quickstrip {

inline constexpr std::size_t kLanes = 4;
static_assert(kMaxFrequencies % kLanes == 0 && kMaxPeakPoints % kLanes == 0);

/// Places first ... end - 1 of an array, whole groups.
struct LaneRange {
  std::size_t first = 0;
  std::size_t end = 0;

  [[nodiscard]] bool is_empty() const { return first >= end; }
};

/// The whole groups that hold places first ... last.
constexpr LaneRange lanes_that_hold(std::size_t first, std::size_t last) {
  return {first / kLanes * kLanes, last / kLanes * kLanes + kLanes};
}

constexpr std::size_t whole_lanes(std::size_t count) {
  return (count + kLanes - 1) / kLanes * kLanes;
}

/// Sum of products over a range: four partial sums.
template <std::size_t N>
double dot(const std::array<double, N>& a, const std::array<double, N>& b, const LaneRange& range) {
  std::array<double, kLanes> sums{};
  for (std::size_t i = range.first; i < range.end; i += kLanes) {
    for (std::size_t j = 0; j < kLanes; ++j) {
      sums[j] += a[i + j] * b[i + j];
    }
  }
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

}  // namespace quickstrip
