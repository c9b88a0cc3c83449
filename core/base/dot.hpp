// Sums of products over groups of four (lanes.hpp), in vectors where the machine has them. By Eigen, because
// compilers make scalars of it; so included where sums are taken, and in no header.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/eigen.hpp"
#include "core/base/lanes.hpp"

namespace quickstrip {

/// Sum of products over a range: eight partial sums in the precision of the second factor, added up in
/// double.
template <typename From, typename Real, std::size_t N>
double dot(const std::array<From, N>& a, const std::array<Real, N>& b, const LaneRange& range) {
  using Lanes = Eigen::Array<Real, kLanes, 1>;
  const auto product = [&](std::size_t i) -> Lanes {
    const Eigen::Map<const Eigen::Array<From, kLanes, 1>> one(a.data() + i);
    const Eigen::Map<const Lanes> other(b.data() + i);
    return one.template cast<Real>() * other;
  };
  Lanes even = Lanes::Zero();
  Lanes odd = Lanes::Zero();
  std::size_t i = range.first;
  // bounded: counts to the end of the range
  for (; i + 2 * kLanes <= range.end; i += 2 * kLanes) {
    even += product(i);
    odd += product(i + kLanes);
  }
  if (i < range.end) {
    even += product(i);
  }
  const Lanes sums = even + odd;
  const auto sum = [&sums](Eigen::Index j) { return static_cast<double>(sums[j]); };
  return (sum(0) + sum(2)) + (sum(1) + sum(3));
}

}  // namespace quickstrip
