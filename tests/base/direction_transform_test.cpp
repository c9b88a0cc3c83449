#include "core/base/direction_transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quickstrip {
namespace {

constexpr std::size_t kWidth = 8;
constexpr std::size_t kHalf = kNumDirections / 2;
constexpr double kRoundingOfSums = 1e-13;  // 72 terms of order one

double angle(std::size_t m) {
  return 2.0 * std::numbers::pi * static_cast<double>(m) / static_cast<double>(kNumDirections);
}

// Five functions without any pattern.
HalfCircle<kWidth> rows() {
  HalfCircle<kWidth> out{};
  for (std::size_t m = 0; m <= kHalf; ++m) {
    for (std::size_t c = 0; c < 5; ++c) {
      out[m][c] = std::sin(1.7 * static_cast<double>(m * m + 3 * c) + 0.3);
    }
  }
  return out;
}

TEST(DirectionTransform, IsTheSumOverTheWholeCircle) {
  const auto in = rows();
  HalfCircle<kWidth> cosine{};
  HalfCircle<kWidth> sine{};
  cosine_transform(in, 5, cosine);
  sine_transform(in, 5, sine);
  for (std::size_t k = 0; k <= kHalf; ++k) {
    for (std::size_t c = 0; c < 5; ++c) {
      double even = 0.0;
      double odd = 0.0;
      for (std::size_t m = 0; m < kNumDirections; ++m) {
        const std::size_t folded = m <= kHalf ? m : kNumDirections - m;
        const double side = m == 0 || m == kHalf ? 0.0 : m < kHalf ? 1.0 : -1.0;
        even += in[folded][c] * std::cos(static_cast<double>(k) * angle(m));
        odd += side * in[folded][c] * std::sin(static_cast<double>(k) * angle(m));
      }
      EXPECT_NEAR(cosine[k][c], even, kRoundingOfSums) << k << " " << c;
      EXPECT_NEAR(sine[k][c], odd, kRoundingOfSums) << k << " " << c;
    }
  }
}

TEST(DirectionTransform, IsItsOwnInverseButForTheNumberOfDirections) {
  const auto in = rows();
  HalfCircle<kWidth> there{};
  HalfCircle<kWidth> back{};
  cosine_transform(in, 5, there);
  cosine_transform(there, 5, back);
  for (std::size_t m = 0; m <= kHalf; ++m) {
    EXPECT_NEAR(back[m][3] / static_cast<double>(kNumDirections), in[m][3], kRoundingOfSums) << m;
  }
}

TEST(DirectionTransform, HasTheCosinesOfItsDirections) {
  for (std::size_t k = 0; k <= kHalf; ++k) {
    for (std::size_t m = 0; m <= kHalf / 2; ++m) {
      const std::size_t j = k * m % kNumDirections;
      EXPECT_NEAR(direction_transform::kCosine[k][m], std::cos(angle(j)), 1e-15);  // of the angle
      EXPECT_NEAR(direction_transform::kSine[k][m], std::sin(angle(j)), 1e-15);    // of the angle
    }
  }
}

}  // namespace
}  // namespace quickstrip
