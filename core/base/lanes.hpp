// Arrays in groups of four, as the vectors of a processor hold them: loops over whole groups need no
// remainder.
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

}  // namespace quickstrip
