// Scatter of the RMS of a window, against records of noise made in time.
#include "core/response/window_rms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/base/angles.hpp"

namespace quickstrip {
namespace {

constexpr double kStep = 0.5;  // s
constexpr int kRecords = 1500;

double relative_deviation(const std::vector<double>& rms) {
  double mean = 0.0;
  double square = 0.0;
  for (const double x : rms) {
    mean += x;
    square += x * x;
  }
  const auto n = static_cast<double>(rms.size());
  mean /= n;
  return std::sqrt(square / n - mean * mean) / mean;
}

TEST(WindowRms, OfANarrowBellScattersAsStated) {
  constexpr double kOmega = 0.6;
  constexpr double kWidth = 0.06;
  constexpr double kWindow = 1200.0;
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0.0, kTwoPi);
  std::vector<double> rms;
  for (int r = 0; r < kRecords; ++r) {
    // 60 components of one amplitude at random frequencies of the bell: all that scatters is how they beat.
    std::vector<double> record(static_cast<std::size_t>(kWindow / kStep), 0.0);
    for (int c = 0; c < 60; ++c) {
      const double omega = kOmega + kWidth * normal(random);
      const double start = phase(random);
      // A rotation for each step: quicker than a cosine.
      double re = std::cos(start);
      double im = std::sin(start);
      const double turn_re = std::cos(omega * kStep);
      const double turn_im = std::sin(omega * kStep);
      for (double& x : record) {
        x += re;
        const double next = re * turn_re - im * turn_im;
        im = re * turn_im + im * turn_re;
        re = next;
      }
    }
    double square = 0.0;
    for (const double x : record) {
      square += x * x;
    }
    rms.push_back(std::sqrt(square / static_cast<double>(record.size())));
  }
  const double t1 = kTwoPi / kOmega;
  const double t2 = kTwoPi / std::hypot(kOmega, kWidth);
  // 1,500 records know a deviation within 2 %; 60 components beat by 1 - 1/60 of what a continuum does.
  EXPECT_NEAR(relative_deviation(rms) / window_rms_deviation(t1, t2, kWindow), 1.0, 0.06);
}

TEST(WindowRms, OfALightlyDampedResonanceScattersAsStated) {
  constexpr double kOmega = 0.5;
  constexpr double kDamping = 0.03;
  constexpr double kWindow = 2400.0;
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  // A second-order recursion whose poles are those of the oscillator.
  const double decay = std::exp(-kDamping * kOmega * kStep);
  const double a1 = 2.0 * decay * std::cos(kOmega * kStep);
  const double a2 = -decay * decay;
  double x1 = 0.0;
  double x2 = 0.0;
  const auto next = [&] {
    const double x = a1 * x1 + a2 * x2 + normal(random);
    x2 = x1;
    x1 = x;
    return x;
  };
  for (int i = 0; i < 10'000; ++i) {
    next();  // until the start is forgotten
  }
  std::vector<double> rms;
  for (int r = 0; r < kRecords; ++r) {
    double square = 0.0;
    const int n = static_cast<int>(kWindow / kStep);
    for (int i = 0; i < n; ++i) {
      const double x = next();
      square += x * x;
    }
    rms.push_back(std::sqrt(square / n));
  }
  const double t = kTwoPi / kOmega;
  // Relative variance of the RMS of a window of 36 decay times: its own higher order is 2 %.
  EXPECT_NEAR(relative_deviation(rms) / window_rms_deviation(t, t, kWindow, kDamping), 1.0, 0.1);
}

TEST(WindowRms, NothingThatMovesIsNotKnownAtAll) {
  EXPECT_EQ(window_rms_deviation(0.0, 0.0, 1200.0), 1.0);
  EXPECT_EQ(window_rms_deviation(10.0, 9.0, 0.0), 1.0);
  EXPECT_EQ(window_rms_deviation(std::nan(""), 9.0, 1200.0), 1.0);
}

}  // namespace
}  // namespace quickstrip
