#include "core/sea/partition.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/sea/directional_spectrum.hpp"
#include "tests/sea/synthetic_spectrum.hpp"

namespace quickstrip {
namespace {

using testing::sampled;
using testing::swell_or_sea;

WavePartition divided(const DirectionalSpectrum& spectrum) {
  static PartitionWorkspace workspace;
  WavePartition out;
  EXPECT_TRUE(divide_into_systems(spectrum, workspace, out));
  return out;
}

double energy_of(const WavePartition& partition) {
  double sum = 0.0;
  for (std::size_t s = 0; s < partition.num_systems; ++s) {
    sum += partition.m0[s];
  }
  return sum;
}

double from_deg(const WaveSystem& system) {
  return degrees(system.from.radians);
}

TEST(Partition, OneSystemStaysOneAndKeepsItsFigures) {
  const auto spectrum = sampled({swell_or_sea(3.0, 9.0, 350.0, 30.0, 3.3)});
  const WavePartition p = divided(*spectrum);
  ASSERT_EQ(p.num_systems, 1U);
  // Trapezoids over bands of 4.6 %, and the tail above 0.5 Hz: 1 %.
  EXPECT_NEAR(p.system[0].hs, 3.0, 0.03);
  EXPECT_NEAR(p.system[0].period, 9.0, 0.02 * 9.0);  // half a band
  EXPECT_NEAR(from_deg(p.system[0]), 350.0, 1e-6);
  EXPECT_NEAR(degrees(p.system[0].spreading), 30.0, 0.01);
  EXPECT_EQ(p.system[0].period_kind, PeriodKind::kPeak);
}

// Swell from the north-east under a wind sea from the south: far apart in direction and period.
TEST(Partition, SwellAndWindSeaComeApartWithTheirHeights) {
  const auto spectrum =
      sampled({swell_or_sea(2.0, 13.0, 45.0, 15.0, 5.0), swell_or_sea(3.0, 7.0, 180.0, 30.0, 3.3)});
  const WavePartition p = divided(*spectrum);
  ASSERT_EQ(p.num_systems, 2U);
  EXPECT_NEAR(p.system[0].hs, 3.0, 0.03 * 3.0);  // the boundary cuts skirts: a few per cent
  EXPECT_NEAR(p.system[1].hs, 2.0, 0.03 * 2.0);
  EXPECT_NEAR(p.system[0].period, 7.0, 0.02 * 7.0);
  EXPECT_NEAR(p.system[1].period, 13.0, 0.02 * 13.0);
  EXPECT_NEAR(from_deg(p.system[0]), 180.0, 2.0);
  EXPECT_NEAR(from_deg(p.system[1]), 45.0, 2.0);
}

// The same direction: only the frequency tells them apart; the sea's skirt reaches under the swell.
TEST(Partition, SwellAndSeaFromOneDirectionComeApartByPeriod) {
  const auto spectrum =
      sampled({swell_or_sea(2.0, 15.0, 100.0, 15.0, 5.0), swell_or_sea(2.5, 6.0, 100.0, 30.0, 3.3)});
  const WavePartition p = divided(*spectrum);
  ASSERT_EQ(p.num_systems, 2U);
  EXPECT_NEAR(p.system[0].hs, 2.5, 0.05 * 2.5);
  EXPECT_NEAR(p.system[1].hs, 2.0, 0.05 * 2.0);
}

TEST(Partition, CrossingSeasOfOnePeriodComeApartByDirection) {
  const auto spectrum =
      sampled({swell_or_sea(2.0, 9.0, 30.0, 20.0, 3.3), swell_or_sea(1.8, 9.0, 130.0, 20.0, 3.3)});
  const WavePartition p = divided(*spectrum);
  ASSERT_EQ(p.num_systems, 2U);
  EXPECT_NEAR(p.system[0].hs, 2.0, 0.05 * 2.0);
  EXPECT_NEAR(p.system[1].hs, 1.8, 0.05 * 1.8);
}

TEST(Partition, TwoSystemsWithoutAValleyStayOne) {
  const auto spectrum =
      sampled({swell_or_sea(2.0, 9.0, 100.0, 30.0, 1.0), swell_or_sea(2.0, 9.5, 115.0, 30.0, 1.0)});
  EXPECT_EQ(divided(*spectrum).num_systems, 1U);
}

TEST(Partition, SystemsComeInDescendingOrderOfEnergyAndAreAtMostSix) {
  std::vector<WaveSystem> systems;
  for (int i = 0; i < 8; ++i) {
    systems.push_back(swell_or_sea(1.0 + 0.15 * i, i % 2 == 0 ? 14.0 : 7.0, 45.0 * i, 8.0, 5.0));
  }
  const auto spectrum = sampled(systems);
  const WavePartition p = divided(*spectrum);
  EXPECT_EQ(p.num_systems, kMaxWaveSystems);
  for (std::size_t s = 1; s < p.num_systems; ++s) {
    EXPECT_GE(p.m0[s - 1], p.m0[s]);
  }
  const double m0 = zeroth_moment(*spectrum);
  EXPECT_NEAR(energy_of(p), m0, 1e-12 * m0);
}

// Noise on every cell: hundreds of peaks. No energy is lost, every cell belongs to a system, twice the same.
TEST(Partition, LosesNoEnergyInNoiseAndIsDeterministic) {
  std::mt19937 random(20190904);
  std::uniform_real_distribution<double> factor(0.0, 2.0);
  const auto spectrum =
      sampled({swell_or_sea(2.0, 13.0, 45.0, 15.0, 5.0), swell_or_sea(3.0, 7.0, 180.0, 30.0, 3.3)});
  for (std::size_t f = 0; f < spectrum->frequencies.size(); ++f) {
    for (std::size_t d = 0; d < spectrum->directions.size(); ++d) {
      spectrum->density[f][d] *= factor(random);
    }
  }
  const WavePartition p = divided(*spectrum);
  const WavePartition again = divided(*spectrum);
  const double m0 = zeroth_moment(*spectrum);
  EXPECT_NEAR(energy_of(p), m0, 1e-12 * m0);
  EXPECT_EQ(p.system_of, again.system_of);
  for (std::size_t f = 0; f < spectrum->frequencies.size(); ++f) {
    for (std::size_t d = 0; d < spectrum->directions.size(); ++d) {
      EXPECT_LT(p.system_of[f][d], p.num_systems);
    }
  }
}

// Checkerboard: the densest set of peaks that there can be, all alike.
TEST(Partition, StandsAsManyPeaksAsThereCanBe) {
  auto spectrum = sampled({swell_or_sea(1.0, 8.0, 0.0, 40.0, 1.0)});
  for (std::size_t f = 0; f < spectrum->frequencies.size(); ++f) {
    for (std::size_t d = 0; d < spectrum->directions.size(); ++d) {
      spectrum->density[f][d] = f % 3 == 0 && d % 3 == 0 ? 1.0 : 0.0;
    }
  }
  const WavePartition p = divided(*spectrum);
  const double m0 = zeroth_moment(*spectrum);
  EXPECT_LE(p.num_systems, kMaxWaveSystems);
  EXPECT_NEAR(energy_of(p), m0, 1e-12 * m0);
}

TEST(Partition, RefusesWhatIsNoSpectrum) {
  static PartitionWorkspace workspace;
  static WavePartition out;
  const auto good = sampled({swell_or_sea(1.0, 8.0, 0.0, 40.0, 1.0)});
  const auto error_after = [&](auto&& spoil) {
    auto spoilt = std::make_unique<DirectionalSpectrum>(*good);
    spoil(*spoilt);
    return divide_into_systems(*spoilt, workspace, out).error();
  };
  using S = DirectionalSpectrum;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_after([](S&) {}), Error::kNone);
  EXPECT_EQ(error_after([&](S& s) { s.density[3][4] = nan; }), Error::kNotFinite);
  EXPECT_EQ(error_after([&](S& s) { s.density[3][4] = -1e-9; }), Error::kOutOfRange);
  EXPECT_EQ(error_after([&](S& s) { s.frequencies[3] = nan; }), Error::kNotFinite);
  EXPECT_EQ(error_after([&](S& s) { s.frequencies[3] = s.frequencies[4]; }), Error::kOutOfRange);
  EXPECT_EQ(error_after([&](S& s) { s.frequencies[0] = 0.0; }), Error::kOutOfRange);
  EXPECT_EQ(error_after([&](S& s) { s.directions[7] = nan; }), Error::kNotFinite);
  EXPECT_EQ(error_after([&](S& s) { s.directions[7] += 0.02; }), Error::kOutOfRange);
  EXPECT_EQ(error_after([&](S& s) { QS_CHECK(s.directions.resize(71)); }), Error::kOutOfRange);
  EXPECT_EQ(error_after([](S& s) { s.density = {}; }), Error::kEmptySpectrum);
  EXPECT_EQ(error_after([](S& s) { s.frequencies.clear(); }), Error::kOutOfRange);
}

}  // namespace
}  // namespace quickstrip
