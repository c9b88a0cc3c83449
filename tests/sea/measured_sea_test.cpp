// place_on_grid of a measured directional spectrum.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/sea/directional_spectrum.hpp"
#include "core/sea/sea_energy.hpp"
#include "tests/sea/synthetic_spectrum.hpp"
#include "tests/support/sea_on_nodes.hpp"

namespace quickstrip {
namespace {

using testing::sampled;
using testing::swell_or_sea;

std::vector<double> nodes(double from, double to) {
  std::vector<double> omega(kMaxFrequencies);
  for (std::size_t i = 0; i < omega.size(); ++i) {
    omega[i] = from + (to - from) * static_cast<double>(i) / static_cast<double>(omega.size() - 1);
  }
  return omega;
}

struct Figures {
  double m0 = 0.0;
  double mean_deg = 0.0;
  double spreading_deg = 0.0;
  double mean_omega = 0.0;
};

Figures figures(const SeaEnergy& sea, const std::vector<double>& omega) {
  Figures out;
  double c = 0.0;
  double s = 0.0;
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    const double angle = kTwoPi * static_cast<double>(d) / static_cast<double>(kNumDirections);
    for (std::size_t f = 0; f < omega.size(); ++f) {
      const double energy = total_energy_at(sea, d, f);
      out.m0 += energy;
      out.mean_omega += energy * omega[f];
      c += energy * std::cos(angle);
      s += energy * std::sin(angle);
    }
  }
  out.mean_omega /= out.m0;
  out.mean_deg = degrees(std::atan2(s, c));
  out.spreading_deg = degrees(std::sqrt(2.0 - 2.0 * std::hypot(c, s) / out.m0));
  return out;
}

const std::vector<WaveSystem>& crossing_sea() {
  static const std::vector<WaveSystem> kSystems = {swell_or_sea(2.0, 13.0, 45.0, 15.0, 5.0),
                                                   swell_or_sea(3.0, 7.0, 180.0, 30.0, 3.3)};
  return kSystems;
}

TEST(MeasuredSea, KeepsAllEnergyAndTheSystemsAddUp) {
  static SeaEnergy sea;
  const auto spectrum = sampled(crossing_sea());
  const auto omega = nodes(0.18, 3.2);  // around all bands: 0.188 ... 3.14
  ASSERT_TRUE(place_on_grid(*spectrum, omega, sea));
  const double m0 = zeroth_moment(*spectrum);
  EXPECT_EQ(sea.num_systems, 2U);
  EXPECT_NEAR(figures(sea, omega).m0, m0, 1e-12 * m0);
  EXPECT_NEAR(sea.lost_tail, 0.0, 1e-12);
  EXPECT_NEAR(sea.hs, std::sqrt(13.0), 0.03);  // sqrt(2^2 + 3^2), the tail above 0.5 Hz
}

// The integral of omega S over piecewise linear S is exact through hats: both are quadratic pieces.
// As SeaEnergy.DensitiesBetweenTheNodesHoldTheEnergyOfTheNodes.
TEST(MeasuredSea, DensitiesBetweenTheNodesHoldTheEnergyOfTheNodes) {
  static SeaEnergy sea;
  const auto spectrum = sampled(crossing_sea());
  const auto omega = nodes(0.3, 2.5);  // bands lie outside on either side
  ASSERT_TRUE(place_on_grid(*spectrum, omega, sea));
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    for (std::size_t f = 1; f + 1 < omega.size(); ++f) {
      DensityTerms left{};
      DensityTerms right{};
      for (std::size_t s = 0; s < sea.num_systems; ++s) {
        for (std::size_t l = 0; l < kDensityTerms; ++l) {
          left[l] += density_at(sea, s, d, f - 1)[l];
          right[l] += density_at(sea, s, d, f)[l];
        }
      }
      const double expected = (omega[f] - omega[f - 1]) * (left[0] / 2.0 + left[1] / 6.0) +
                              (omega[f + 1] - omega[f]) * (right[0] / 2.0 - right[1] / 6.0);
      EXPECT_NEAR(total_energy_at(sea, d, f), expected, 1e-14) << d << " " << f;
    }
  }
}

TEST(MeasuredSea, GivesTheFirstMomentOfThePiecewiseLinearSpectrum) {
  static SeaEnergy sea;
  const auto spectrum = sampled({swell_or_sea(3.0, 9.0, 90.0, 30.0, 3.3)});
  const auto omega = nodes(0.18, 3.2);
  ASSERT_TRUE(place_on_grid(*spectrum, omega, sea));
  const auto row = [&spectrum](std::size_t f) {
    double sum = 0.0;
    for (std::size_t d = 0; d < spectrum->directions.size(); ++d) {
      sum += spectrum->density[f][d];
    }
    return sum;
  };
  double m0 = 0.0;
  double m1 = 0.0;
  for (std::size_t f = 0; f + 1 < spectrum->frequencies.size(); ++f) {
    const double a = spectrum->frequencies[f];
    const double b = spectrum->frequencies[f + 1];
    m0 += (b - a) * (row(f) + row(f + 1)) / 2.0;
    m1 += (b - a) * (a * row(f) + b * row(f + 1) + (a + b) * (row(f) + row(f + 1))) / 6.0;
  }
  EXPECT_NEAR(figures(sea, omega).mean_omega, m1 / m0, 1e-12);
}

TEST(MeasuredSea, SeventyTwoDirectionsOnTheGridStayAsTheyAre) {
  static SeaEnergy sea;
  auto spectrum = sampled({swell_or_sea(3.0, 9.0, 90.0, 30.0, 3.3)});
  for (auto& row : spectrum->density) {
    for (std::size_t d = 0; d < row.size(); ++d) {
      row[d] = d == 20 ? row[d] : 0.0;  // 100 degrees alone
    }
  }
  ASSERT_TRUE(place_on_grid(*spectrum, nodes(0.18, 3.2), sea));
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    EXPECT_EQ(total_energy_at(sea, d, 10) > 0.0, d == 20) << d;
  }
}

// Radars and models bring 24, 36 or 70 directions, from 7.5 degrees on, or turned round and unsorted.
TEST(MeasuredSea, OtherDirectionsKeepEnergyMeanAndSpreading) {
  static SeaEnergy sea;
  const auto omega = nodes(0.18, 3.2);
  for (const std::size_t n : {24U, 36U, 70U, 72U}) {
    for (const double first_deg : {0.0, 2.5, 187.5}) {
      const auto spectrum = sampled({swell_or_sea(3.0, 9.0, 73.0, 30.0, 3.3)}, n, first_deg);
      ASSERT_TRUE(place_on_grid(*spectrum, omega, sea));
      const Figures f = figures(sea, omega);
      const double m0 = zeroth_moment(*spectrum);
      EXPECT_NEAR(f.m0, m0, 1e-12 * m0);
      EXPECT_NEAR(f.mean_deg, 73.0, 0.1);
      EXPECT_NEAR(f.spreading_deg, 30.0, n == 24 ? 0.7 : 0.3);  // interpolation widens: by step^2 / 6
    }
  }
}

TEST(MeasuredSea, CounterClockwiseDirectionsAreTheSameSea) {
  static SeaEnergy clockwise;
  static SeaEnergy counter;
  const auto omega = nodes(0.18, 3.2);
  const auto spectrum = sampled(crossing_sea());
  auto reversed = std::make_unique<DirectionalSpectrum>(*spectrum);
  const std::size_t n = spectrum->directions.size();
  for (std::size_t d = 0; d < n; ++d) {
    reversed->directions[d] = spectrum->directions[n - 1 - d];
    for (std::size_t f = 0; f < spectrum->frequencies.size(); ++f) {
      reversed->density[f][d] = spectrum->density[f][n - 1 - d];
    }
  }
  ASSERT_TRUE(place_on_grid(*spectrum, omega, clockwise));
  ASSERT_TRUE(place_on_grid(*reversed, omega, counter));
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    for (std::size_t f = 0; f < omega.size(); ++f) {
      EXPECT_NEAR(total_energy_at(counter, d, f), total_energy_at(clockwise, d, f), 1e-14);
    }
  }
}

TEST(MeasuredSea, TurningTheSpectrumByGridStepsTurnsTheEnergy) {
  static SeaEnergy first;
  static SeaEnergy turned;
  const auto omega = nodes(0.3, 2.0);
  const auto spectrum = sampled(crossing_sea());
  auto shifted = std::make_unique<DirectionalSpectrum>(*spectrum);
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    for (std::size_t f = 0; f < spectrum->frequencies.size(); ++f) {
      shifted->density[f][(d + 13) % kNumDirections] = spectrum->density[f][d];
    }
  }
  ASSERT_TRUE(place_on_grid(*spectrum, omega, first));
  ASSERT_TRUE(place_on_grid(*shifted, omega, turned));
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    for (std::size_t f = 0; f < omega.size(); ++f) {
      EXPECT_NEAR(total_energy_at(turned, (d + 13) % kNumDirections, f), total_energy_at(first, d, f),
                  1e-14);  // order of sums
    }
  }
}

TEST(MeasuredSea, TailOutsideTheNodesIsCountedAndGivenBack) {
  static SeaEnergy sea;
  const auto spectrum = sampled({swell_or_sea(3.0, 7.0, 90.0, 30.0, 1.0)});
  const auto omega = nodes(0.4, 1.6);
  ASSERT_TRUE(place_on_grid(*spectrum, omega, sea));
  const double m0 = zeroth_moment(*spectrum);
  EXPECT_NEAR(figures(sea, omega).m0, m0, 1e-12 * m0);
  // The closed fraction of Bretschneider above 1.6, less that above the last band; bands are 4.6 % wide.
  const double wp = kTwoPi / 7.0;
  const auto below = [wp](double w) { return std::exp(-1.25 * std::pow(wp / w, 4)); };
  EXPECT_NEAR(sea.lost_tail, (below(kPi) - below(1.6)) / below(kPi), 0.002);
}

TEST(MeasuredSea, BeyondTheNodesTheHeightStays) {
  static SeaEnergy sea;
  const auto spectrum = sampled({swell_or_sea(0.5, 2.4, 90.0, 30.0, 3.3)});
  const auto omega = nodes(0.1, 0.6);
  ASSERT_TRUE(place_on_grid(*spectrum, omega, sea));
  const double m0 = zeroth_moment(*spectrum);
  EXPECT_NEAR(figures(sea, omega).m0, m0, 1e-12 * m0);
  EXPECT_NEAR(figures(sea, omega).mean_omega, 0.6, 1e-12);
  EXPECT_NEAR(sea.lost_tail, 1.0, 1e-6);
}

}  // namespace
}  // namespace quickstrip
