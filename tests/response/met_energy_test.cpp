#include "core/response/met_energy.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace quickstrip {
namespace {

constexpr double kTurn = kTwoPi / static_cast<double>(kNumDirections);

/// One system of three bands that overlap, each spread over direction in its own way.
class MetEnergyTest : public testing::Test {
 protected:
  MetEnergyTest() {
    SystemEnergy& system = sea_->part[0];
    sea_->num_systems = 1;
    sea_->num_bands = 3;
    system.first = 0;
    system.count = 3;
    for (std::size_t b = 0; b < 3; ++b) {
      EnergyBand& band = sea_->band[b];
      band.first = 2 + 3 * b;
      band.last = band.first + 4;
      for (std::size_t f = band.first; f <= band.last; ++f) {
        band.node[f] = 0.5 + 0.1 * static_cast<double>(f * (b + 1));
        band.density[f][1] = f < band.last ? 0.01 * static_cast<double>(f) : 0.0;
      }
      for (std::size_t d = 0; d < kNumDirections; ++d) {
        system.factor[b][d] = static_cast<double>((7 * d + 11 * b) % 13) / 13.0;
      }
    }
  }
  /// What comes from relative direction m, any of the circle, at node f.
  [[nodiscard]] double energy(double heading_index, std::size_t m, std::size_t f) const {
    const auto h = static_cast<std::size_t>(heading_index);
    const double part = heading_index - static_cast<double>(h);
    double sum = 0.0;
    for (std::size_t b = 0; b < 3; ++b) {
      // from = heading + half a turn - m
      const std::size_t d = (h + kNumDirections / 2 + kNumDirections - m) % kNumDirections;
      const DirectionWeights& factor = sea_->part[0].factor[b];
      sum += ((1.0 - part) * factor[d] + part * factor[(d + 1) % kNumDirections]) * sea_->band[b].node[f];
    }
    return sum;
  }

  std::unique_ptr<SeaEnergy> sea_ = std::make_unique<SeaEnergy>();
  MetEnergy met_;
};

TEST_F(MetEnergyTest, BothSidesTogetherAndTheirDifference) {
  for (const double heading : {0.0, 5.25, 71.75}) {
    for (const std::size_t m : {std::size_t{1}, std::size_t{17}, std::size_t{35}}) {
      ASSERT_TRUE(meet_energy(*sea_, 0, bracket_heading(Heading{heading * kTurn}), m, met_));
      for (std::size_t f = 0; f < kMaxFrequencies; ++f) {
        const double starboard = energy(heading, m, f);
        const double port = energy(heading, kNumDirections - m, f);
        EXPECT_NEAR(met_.even.node[f], starboard + port, 1e-12);
        EXPECT_NEAR(met_.odd.node[f], starboard - port, 1e-12);
      }
      EXPECT_EQ(met_.even.first, 2U);
      EXPECT_EQ(met_.even.last, 12U);
    }
  }
}

TEST_F(MetEnergyTest, AheadAndAsternCountOnce) {
  for (const std::size_t m : {std::size_t{0}, kNumDirections / 2}) {
    ASSERT_TRUE(meet_energy(*sea_, 0, bracket_heading(Heading{3.0 * kTurn}), m, met_));
    for (std::size_t f = 0; f < kMaxFrequencies; ++f) {
      EXPECT_NEAR(met_.even.node[f], energy(3.0, m, f), 1e-12);
      EXPECT_EQ(met_.odd.node[f], met_.even.node[f]);
    }
  }
}

TEST_F(MetEnergyTest, DensityGoesWithEnergy) {
  ASSERT_TRUE(meet_energy(*sea_, 0, bracket_heading(Heading{0.0}), 9, met_));
  const std::size_t f = 3;  // only the first band's
  EXPECT_NEAR(met_.even.density[f][1] / met_.even.node[f],
              sea_->band[0].density[f][1] / sea_->band[0].node[f], 1e-15);
  EXPECT_NEAR(met_.odd.density[f][1] / met_.odd.node[f], sea_->band[0].density[f][1] / sea_->band[0].node[f],
              1e-15);
}

TEST_F(MetEnergyTest, NothingWhereNoWaveComesFrom) {
  for (std::size_t b = 0; b < 3; ++b) {
    sea_->part[0].factor[b].fill(0.0);
  }
  EXPECT_FALSE(meet_energy(*sea_, 0, bracket_heading(Heading{1.0}), 9, met_));
  for (std::size_t f = 0; f < kMaxFrequencies; ++f) {
    EXPECT_EQ(met_.even.node[f], 0.0);
    EXPECT_EQ(met_.odd.node[f], 0.0);
  }
}

}  // namespace
}  // namespace quickstrip
