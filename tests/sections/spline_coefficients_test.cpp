// Laws of the not-a-knot cubic spline (Theilheimer polynomial): generator's coefficients, core's stencil.
#include "sim/section_table/spline_coefficients.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/base/interpolation.hpp"

namespace quickstrip {
namespace {

constexpr std::array<double, 9> kUneven = {-2.0, -1.7, -0.9, 0.0, 0.1, 0.4, 1.5, 2.9, 3.0};

// Spline along one axis; the others hold one cubic each.
constexpr std::array<double, 4> kFour = {0.0, 0.2, 0.7, 1.0};

template <typename Function>
std::vector<double> coefficients_of(const Function& f) {
  std::vector<double> values;
  for (const double x : kUneven) {
    for (const double y : kFour) {
      for (const double z : kUneven) {
        values.push_back(f(x, y, z));
      }
    }
  }
  replace_by_spline_coefficients({kUneven, kFour, kUneven}, 1, values);
  return values;
}

double spline_at(const std::vector<double>& coefficients, double x, double y, double z) {
  const SplineStencil sx = spline_stencil(kUneven, x);
  const SplineStencil sy = spline_stencil(kFour, y);
  const SplineStencil sz = spline_stencil(kUneven, z);
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t place =
            ((sx.first + i) * kFour.size() + sy.first + j) * kUneven.size() + sz.first + k;
        sum += sx.weight[i] * sy.weight[j] * sz.weight[k] * coefficients[place];
      }
    }
  }
  return sum;
}

TEST(SplineCoefficients, ReproduceCubicsOfThreeVariables) {
  const auto cubic = [](double x, double y, double z) {
    return (1.0 + x - 0.3 * x * x * x) * (2.0 - y * y + 0.5 * y * y * y) *
           (0.1 + z + z * z - 0.2 * z * z * z);
  };
  const std::vector<double> coefficients = coefficients_of(cubic);
  for (double x = -2.0; x <= 3.0; x += 0.37) {
    for (double y = 0.0; y <= 1.0; y += 0.13) {
      for (double z = -2.0; z <= 3.0; z += 0.41) {
        EXPECT_NEAR(spline_at(coefficients, x, y, z), cubic(x, y, z), 1e-11);  // rounding of values up to 40
      }
    }
  }
}

TEST(SplineCoefficients, GiveTheValuesBackAtTheNodes) {
  const auto wild = [](double x, double y, double z) {
    return std::sin(7.0 * x + 3.0 * y) + std::cos(9.0 * z);
  };
  const std::vector<double> coefficients = coefficients_of(wild);
  for (const double x : kUneven) {
    for (const double y : kFour) {
      for (const double z : kUneven) {
        EXPECT_NEAR(spline_at(coefficients, x, y, z), wild(x, y, z), 1e-12);
      }
    }
  }
}

// Theilheimer's form: a cubic and a truncated cube at every node from the third to the last but two. One of
// those is a spline, and so comes back between the nodes; a cube that starts at the second node does not.
TEST(SplineCoefficients, HoldTheilheimersTruncatedCubesAndNoOthers) {
  const auto cube_from = [](double knot) {
    return [knot](double x, double, double) { return std::pow(std::max(0.0, x - knot), 3.0); };
  };
  const auto worst = [&](double knot) {
    const auto f = cube_from(knot);
    const std::vector<double> coefficients = coefficients_of(f);
    double most = 0.0;
    for (double x = -2.0; x <= 3.0; x += 0.01) {
      most = std::max(most, std::abs(spline_at(coefficients, x, 0.5, 0.5) - f(x, 0.0, 0.0)));
    }
    return most;
  };
  for (std::size_t i = 2; i + 2 < kUneven.size(); ++i) {
    EXPECT_LT(worst(kUneven[i]), 1e-11) << i;  // rounding of values up to 60
  }
  EXPECT_GT(worst(kUneven[1]), 1e-4);
  EXPECT_GT(worst(kUneven[kUneven.size() - 2]), 1e-5);
}

}  // namespace
}  // namespace quickstrip
