#include "core/sea/sea_energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/constants.hpp"
#include "core/base/legendre.hpp"
#include "core/sea/moments.hpp"
#include "core/sea/spectrum.hpp"
#include "tests/support/sea_on_nodes.hpp"

namespace quickstrip {
namespace {

std::vector<double> nodes(double from = 0.25, double to = 2.5, std::size_t n = kMaxFrequencies) {
  std::vector<double> omega(n);
  for (std::size_t i = 0; i < n; ++i) {
    omega[i] = from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(n - 1));
  }
  return omega;
}

WaveSystem system_from(double hs, double tp, double from_deg, double spreading_deg,
                       SpectrumShape shape = SpectrumShape::kJonswap) {
  WaveSystem system;
  system.hs = hs;
  system.period = tp;
  system.from.radians = radians(from_deg);
  system.spreading = radians(spreading_deg);
  system.shape = shape;
  return system;
}

SeaState sea_of(std::initializer_list<WaveSystem> systems) {
  SeaState sea;
  for (const WaveSystem& system : systems) {
    EXPECT_TRUE(sea.systems.push_back(system));
  }
  return sea;
}

double energy_of(const SeaEnergy& sea, std::size_t system) {
  double sum = 0.0;
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    for (std::size_t f = 0; f < sea.num_frequencies; ++f) {
      sum += energy_at(sea, system, d, f);
    }
  }
  return sum;
}

double total(const SeaEnergy& sea) {
  double sum = 0.0;
  for (std::size_t s = 0; s < sea.num_systems; ++s) {
    sum += energy_of(sea, s);
  }
  return sum;
}

TEST(SeaEnergy, SumIsTheZerothMomentOfEachSystemAndOfAll) {
  static SeaEnergy energy;
  const SeaState sea = sea_of({system_from(4.0, 9.0, 40.0, 30.0), system_from(1.5, 14.0, 200.0, 12.0),
                               system_from(0.4, 4.0, 300.0, 0.0, SpectrumShape::kNeumann)});
  const auto omega = nodes();
  ASSERT_TRUE(place_on_grid(sea, omega, energy));
  ASSERT_EQ(energy.num_systems, 3U);
  EXPECT_EQ(energy.num_frequencies, omega.size());
  double m0 = 0.0;
  for (std::size_t s = 0; s < 3; ++s) {
    const double expected = sea.systems[s].hs * sea.systems[s].hs / 16.0;
    EXPECT_NEAR(energy_of(energy, s), expected, 1e-13);
    m0 += expected;
  }
  EXPECT_NEAR(total(energy), m0, 1e-13);
  EXPECT_NEAR(energy.hs, 4.0 * std::sqrt(m0), 1e-13);
}

// The hat function of a node is (P_0 + P_1)/2 before it and (P_0 - P_1)/2 behind it, so its energy follows
// from the first two terms of the densities on both sides: an identity.
TEST(SeaEnergy, DensitiesBetweenTheNodesHoldTheEnergyOfTheNodes) {
  static SeaEnergy energy;
  const SeaState sea =
      sea_of({system_from(4.0, 9.0, 40.0, 30.0), system_from(1.5, 14.0, 200.0, 0.0),
              system_from(0.1, 1.0, 10.0, 20.0)});  // the last lies above all nodes: no density
  const auto omega = nodes();
  ASSERT_TRUE(place_on_grid(sea, omega, energy));
  for (std::size_t s = 0; s < 2; ++s) {
    for (std::size_t d = 0; d < kNumDirections; ++d) {
      for (std::size_t f = 0; f < omega.size(); ++f) {
        double expected = 0.0;
        if (f > 0) {
          const DensityTerms left = density_at(energy, s, d, f - 1);
          expected += (omega[f] - omega[f - 1]) * (left[0] / 2.0 + left[1] / 6.0);
        }
        if (f + 1 < omega.size()) {
          const DensityTerms right = density_at(energy, s, d, f);
          expected += (omega[f + 1] - omega[f]) * (right[0] / 2.0 - right[1] / 6.0);
        }
        EXPECT_NEAR(energy_at(energy, s, d, f), expected, 1e-14) << s << " " << d << " " << f;
      }
    }
  }
  for (const DensityTerms& terms : energy.band[2].density) {
    EXPECT_EQ(terms, DensityTerms{});
  }
}

// JONSWAP of gamma 7 has the steepest flank there is; the cubic of an interval of 5 % follows it.
TEST(SeaEnergy, DensityWithinAnIntervalFollowsTheSpectrum) {
  const Spectrum spectrum = *spectrum_of(
      WaveSystem{4.0, 12.0, PeriodKind::kPeak, WaveFrom{0.0}, 0.0, SpectrumShape::kJonswap, 7.0});
  const double highest = density(spectrum, spectrum.peak_frequency);
  double worst = 0.0;
  const auto omega = nodes(0.19, 2.2);
  for (std::size_t i = 0; i + 1 < omega.size(); ++i) {
    const DensityTerms terms = density_terms(spectrum, omega[i], omega[i + 1]);
    for (double t = 0.0; t <= 1.0; t += 0.125) {
      const auto p = legendre(t);
      const double cubic = terms[0] * p[0] + terms[1] * p[1] + terms[2] * p[2] + terms[3] * p[3];
      const double exact = density(spectrum, omega[i] + t * (omega[i + 1] - omega[i]));
      worst = std::max(worst, std::fabs(cubic - exact) / highest);
    }
  }
  EXPECT_LT(worst, 0.01);  // the width of the peak jumps at its top: a kink in the second derivative
}

// The fraction of Bretschneider outside the nodes is closed.
TEST(SeaEnergy, LostTailIsTheEnergyOutsideTheNodes) {
  static SeaEnergy energy;
  const auto omega = nodes(0.5, 1.8);
  ASSERT_TRUE(
      place_on_grid(sea_of({system_from(1.1, 7.0, 0.0, 0.0, SpectrumShape::kBretschneider)}), omega, energy));
  const double wp = kTwoPi / 7.0;
  const auto below = [wp](double w) { return std::exp(-1.25 * std::pow(wp / w, 4)); };
  EXPECT_NEAR(energy.lost_tail, 1.0 - below(1.8) + below(0.5), 1e-9);
  EXPECT_NEAR(total(energy), 1.1 * 1.1 / 16.0, 1e-14);
}

// A wave-following response |H|^2 = omega^2 is not linear: 48 nodes give m2 within 0.1 % of the closed one.
TEST(SeaEnergy, ResponseVarianceConverges) {
  static SeaEnergy energy;
  const auto omega = nodes(0.2, 4.0);
  const WaveSystem system = system_from(3.0, 10.0, 123.0, 25.0);
  ASSERT_TRUE(place_on_grid(sea_of({system}), omega, energy));
  double variance = 0.0;
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    for (std::size_t f = 0; f < omega.size(); ++f) {
      variance += total_energy_at(energy, d, f) * omega[f] * omega[f];
    }
  }
  const double expected = moment_between(*spectrum_of(system), 2, 0.2, 4.0);
  EXPECT_NEAR(variance, expected, 2e-3 * expected);
}

TEST(SeaEnergy, SaysWhatEachSystemIs) {
  static SeaEnergy energy;
  WaveSystem system = system_from(3.0, 8.0, -30.0, 25.0, SpectrumShape::kBretschneider);
  system.period_kind = PeriodKind::kMean;
  ASSERT_TRUE(place_on_grid(sea_of({system}), nodes(), energy));
  EXPECT_EQ(energy.system[0].period_kind, PeriodKind::kPeak);
  EXPECT_NEAR(energy.system[0].period, 8.0 / 0.772, 0.01);  // T1 = 0.772 Tp, three printed digits
  EXPECT_NEAR(degrees(energy.system[0].from.radians), 330.0, 1e-9);
  EXPECT_EQ(energy.system[0].hs, 3.0);
}

TEST(SeaEnergy, TurnsWithTheSeaBitForBit) {
  static SeaEnergy first;
  static SeaEnergy turned;
  const auto omega = nodes();
  ASSERT_TRUE(place_on_grid(sea_of({system_from(4.0, 9.0, 41.7, 30.0)}), omega, first));
  for (const std::size_t k : {1U, 18U, 71U}) {
    const double from_deg = 41.7 + 5.0 * static_cast<double>(k);
    ASSERT_TRUE(place_on_grid(sea_of({system_from(4.0, 9.0, from_deg, 30.0)}), omega, turned));
    for (std::size_t d = 0; d < kNumDirections; ++d) {
      EXPECT_EQ(turned.part[0].factor[0][(d + k) % kNumDirections], first.part[0].factor[0][d]);
    }
  }
}

TEST(SeaEnergy, MirroredSeaGivesTheMirroredEnergy) {
  static SeaEnergy starboard;
  static SeaEnergy port;
  ASSERT_TRUE(place_on_grid(sea_of({system_from(4.0, 9.0, 57.0, 20.0)}), nodes(), starboard));
  ASSERT_TRUE(place_on_grid(sea_of({system_from(4.0, 9.0, 303.0, 20.0)}), nodes(), port));
  for (std::size_t d = 0; d < kNumDirections; ++d) {
    for (std::size_t f = 0; f < kMaxFrequencies; ++f) {
      EXPECT_NEAR(total_energy_at(port, (kNumDirections - d) % kNumDirections, f),
                  total_energy_at(starboard, d, f), 1e-15);
    }
  }
}

TEST(SeaEnergy, ASystemBeyondTheNodesKeepsItsHeightOnTheEndNode) {
  static SeaEnergy energy;
  const auto omega = nodes(0.2, 0.8);
  ASSERT_TRUE(place_on_grid(sea_of({system_from(0.2, 2.0, 90.0, 0.0)}), omega, energy));
  EXPECT_NEAR(total_energy_at(energy, 18, omega.size() - 1), 0.04 / 16.0, 1e-16);
  EXPECT_NEAR(energy.lost_tail, 1.0, 1e-6);
}

TEST(SeaEnergy, RefusesBadNodesAndBadSystems) {
  static SeaEnergy energy;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const SeaState good = sea_of({system_from(4.0, 9.0, 40.0, 30.0)});
  const auto nodes_error = [&](std::vector<double> omega) {
    return place_on_grid(good, omega, energy).error();
  };
  EXPECT_EQ(nodes_error({0.5, 1.0}), Error::kOutOfRange);
  EXPECT_EQ(nodes_error({0.5, 1.0, 1.0}), Error::kOutOfRange);
  EXPECT_EQ(nodes_error({0.0, 1.0, 1.5}), Error::kOutOfRange);
  EXPECT_EQ(nodes_error({0.5, nan, 1.5}), Error::kNotFinite);
  EXPECT_EQ(nodes_error(std::vector<double>(kMaxFrequencies + 1, 1.0)), Error::kOutOfRange);
  const auto sea_error = [&](const SeaState& sea) { return place_on_grid(sea, nodes(), energy).error(); };
  EXPECT_EQ(sea_error(SeaState{}), Error::kEmptySpectrum);
  EXPECT_EQ(sea_error(sea_of({system_from(-1.0, 9.0, 40.0, 30.0)})), Error::kOutOfRange);
  EXPECT_EQ(sea_error(sea_of({system_from(1.0, 9.0, nan, 30.0)})), Error::kNotFinite);
  EXPECT_EQ(sea_error(sea_of({system_from(1.0, 9.0, 40.0, 90.0)})), Error::kOutOfRange);
  EXPECT_EQ(energy.num_systems, 0U);
}

}  // namespace
}  // namespace quickstrip
