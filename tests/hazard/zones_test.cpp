// Zones of several wave systems on all courses: which way round, which systems count, what is not known.
#include "core/hazard/zones.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;

struct System {
  double hs;
  double tp;
  double from_deg;
};

/// A ship of 150 m, GM 1 m, measured roll period 15 s; in waves her GM varies by +-2 % of the wave height.
class ZonesTest : public testing::Test {
 protected:
  void SetUp() override {
    for (std::size_t i = 0; i < omega_.size(); ++i) {
      omega_[i] = 0.2 + 1.8 * static_cast<double>(i) / static_cast<double>(omega_.size() - 1);
    }
    ship_.lpp = 150.0;
    ship_.gravity = kStandardGravity;
    ship_.gm = 1.0;
    ship_.roll = {RollPeriodSource::kMeasured, 15.0, 15.0, 0.0};
    ship_.gm_in_waves.is_known = true;
    ship_.gm_in_waves.length = ship_.lpp;
    for (std::size_t n = 0; n < GmInWaves::kNumHeights; ++n) {
      const float change = 0.02F * 1.5F * static_cast<float>(n);
      ship_.gm_in_waves.by_height[n] = {-change, change, 0.0F};
    }
    ship_.num_speeds = 2;
    ship_.speeds = {0.0, 15.0};
    ship_.roll_damping_ratio = {0.02F, 0.06F};
  }
  void sea(const std::vector<System>& systems) {
    SeaState state;
    for (const System& s : systems) {
      ASSERT_TRUE(state.systems.push_back({.hs = s.hs, .period = s.tp, .from = {radians(s.from_deg)}}));
    }
    ASSERT_TRUE(place_on_grid(state, omega_, *energy_).ok());
    prepare_zones(ship_, *energy_, omega_, zones_);
  }
  [[nodiscard]] unsigned bits(double heading_deg, double knots) const {
    return zone_bits(ship_, zones_, {radians(heading_deg)}, knots * kKnot);
  }
  [[nodiscard]] ZoneFinding only_finding(double heading_deg, double knots) const {
    StaticVector<ZoneFinding, kMaxWaveSystems> findings;
    list_zone_findings(ship_, zones_, {radians(heading_deg)}, knots * kKnot, findings);
    EXPECT_EQ(findings.size(), 1u);
    return findings.empty() ? ZoneFinding{} : findings[0];
  }

  ZoneShip ship_;
  std::unique_ptr<SeaEnergy> energy_ = std::make_unique<SeaEnergy>();
  std::array<double, kMaxFrequencies> omega_{};
  Zones zones_;
};

// A swell from each quadrant: running before it is the surf-riding zone, on the courses about the opposite
// direction and no other; half a turn further round there is none.
TEST_F(ZonesTest, SurfRidingLiesOnTheCoursesThatRunBeforeTheSwellInAllFourQuadrants) {
  const double knots = 1.8 * std::sqrt(150.0) / std::cos(radians(40.0)) + 0.1;
  for (const double from : {40.0, 130.0, 220.0, 310.0}) {
    sea({{3.0, 12.0, from}});
    for (double heading = 0.0; heading < 360.0; heading += 5.0) {
      const double off = std::abs(degrees(wrap_pi(radians(heading - from + 180.0))));
      EXPECT_EQ((bits(heading, knots) & kHazardSurfRiding) != 0, off <= 40.0 + 1e-6)
          << from << " " << heading;
    }
  }
}

// Ship heading 000, 25 degrees of the waves' way: from 155 is her starboard quarter, from 205 her port
// quarter, from 025 her starboard bow.
TEST_F(ZonesTest, ASwellFromTheStarboardQuarterIsFoundThere) {
  for (const double heading : {0.0, 90.0, 180.0, 270.0}) {
    sea({{3.0, 12.0, std::fmod(heading + 155.0, 360.0)}});
    const ZoneFinding quarter = only_finding(heading, 26.0);
    EXPECT_NEAR(degrees(quarter.mu.radians), 25.0, 1e-9);
    EXPECT_NE(quarter.bits & kHazardSurfRiding, 0);
    EXPECT_NE(bits(heading, 26.0) & kHazardSurfRiding, 0u);
    EXPECT_EQ(bits(heading + 50.0 + 25.0, 26.0) & kHazardSurfRiding,
              0u);                                                  // 75 degrees more: waves from her beam
    EXPECT_NE(bits(heading - 50.0, 26.0) & kHazardSurfRiding, 0u);  // now 25 degrees on her port quarter
    sea({{3.0, 12.0, std::fmod(heading + 205.0, 360.0)}});
    EXPECT_NEAR(degrees(only_finding(heading, 26.0).mu.radians), -25.0, 1e-9);
    EXPECT_EQ(bits(heading - 75.0, 26.0) & kHazardSurfRiding, 0u);
    EXPECT_NE(bits(heading + 50.0, 26.0) & kHazardSurfRiding, 0u);
  }
}

// Each system has its own zone; a cell is in the zones of all.
TEST_F(ZonesTest, SystemsAreLookedAtOneByOne) {
  sea({{3.0, 12.0, 0.0}, {3.0, 12.0, 90.0}});
  const double knots = 24.0;
  EXPECT_NE(bits(180.0, knots) & kHazardSurfRiding, 0u);
  EXPECT_NE(bits(270.0, knots) & kHazardSurfRiding, 0u);
  EXPECT_EQ(bits(0.0, knots) & kHazardSurfRiding, 0u);
  EXPECT_EQ(bits(225.0 + 90.0, knots) & kHazardSurfRiding, 0u);
  // Two systems of 5 m are not one of 7 m: the gate of 6 m is each one's own.
  sea({{5.0, 12.0, 0.0}, {5.0, 12.0, 0.0}});
  EXPECT_EQ(bits(180.0, knots) & kHazardSurfRidingWaves, 0u);
  sea({{6.1, 12.0, 0.0}, {1.0, 12.0, 90.0}});
  EXPECT_NE(bits(180.0, knots) & kHazardSurfRidingWaves, 0u);
  EXPECT_EQ(bits(270.0, knots) & kHazardSurfRidingWaves, 0u);
}

TEST_F(ZonesTest, WavesTooLowOrTooShortForTheShipAreNoSystem) {
  sea({{1.49, 12.0, 0.0}});  // below 0.01 L
  EXPECT_EQ(bits(180.0, 24.0), 0u);
  sea({{1.51, 12.0, 0.0}});
  EXPECT_NE(bits(180.0, 24.0), 0u);
  sea({{1.6, 4.8, 0.0}});  // 36 m, below 0.25 L
  EXPECT_EQ(bits(180.0, 24.0), 0u);
  sea({{1.6, 5.1, 0.0}});
  EXPECT_NE(bits(180.0, 24.0), 0u);
}

TEST_F(ZonesTest, WithoutStabilityInWavesNoSeaFromAbaftTheBeamIsFullyLookedAt) {
  ship_.gm_in_waves = GmInWaves{};
  sea({{2.0, 9.0, 0.0}});
  for (double heading = 0.0; heading < 360.0; heading += 5.0) {
    const double mu = std::abs(degrees(wrap_pi(radians(heading + 180.0))));
    EXPECT_EQ((bits(heading, 10.0) & kHazardZonesUnknown) != 0, mu < 60.0 - 1e-6) << heading;
    EXPECT_EQ(bits(heading, 10.0) & kSevereZoneBits, 0u);
  }
}

TEST_F(ZonesTest, WithoutARollPeriodLikewise) {
  ship_.roll = RollPeriodBand{};
  sea({{2.0, 9.0, 0.0}});
  EXPECT_NE(bits(180.0, 10.0) & kHazardZonesUnknown, 0u);
  EXPECT_EQ(bits(0.0, 10.0) & kHazardZonesUnknown, 0u);
  EXPECT_EQ(bits(180.0, 10.0) & (kHazardSynchronousRoll | kHazardParametricRoll), 0u);
  EXPECT_NE(bits(180.0, 24.0) & kHazardSurfRiding, 0u);  // needs no roll period
}

// GM on the crest is 1 - 0.02 H: below 0.05 m in an effective wave of more than 47 m; here the table is made
// ten times steeper.
TEST_F(ZonesTest, StabilityLostOnTheCrestIsAWarningWithItsZone) {
  for (GmChange& change : ship_.gm_in_waves.by_height) {
    change.least *= 10.0F;
  }
  const double knots = 0.752 * std::sqrt(150.0) / kKnot;
  sea({{3.0, 11.0, 0.0}});  // effective wave of about 4 m: 0.2 m are left
  EXPECT_EQ(bits(180.0, knots + 0.1) & (kHazardPureLoss | kHazardPureLossGm), 0u);
  sea({{5.5, 11.0, 0.0}});  // none left, though the waves are not yet 0.04 L high
  EXPECT_EQ(bits(180.0, knots + 0.1) & (kHazardPureLoss | kHazardPureLossGm),
            kHazardPureLoss | kHazardPureLossGm);
  EXPECT_EQ(bits(180.0, knots - 0.1) & (kHazardPureLoss | kHazardPureLossGm), 0u);
  EXPECT_EQ(bits(0.0, knots + 0.1) & (kHazardPureLoss | kHazardPureLossGm), 0u);
}

// Doubling every length and height, times by sqrt 2: the same bits (Froude). GM of 0.05 m apart.
TEST_F(ZonesTest, FollowFroudesLaw) {
  sea({{4.0, 10.0, 30.0}, {6.2, 13.0, 100.0}});
  std::vector<unsigned> small;
  for (double heading = 0.0; heading < 360.0; heading += 7.0) {
    for (double knots = 2.0; knots < 26.0; knots += 3.1) {
      small.push_back(bits(heading, knots));
    }
  }
  ship_.lpp *= 2.0;
  ship_.gm *= 2.0;
  ship_.gm_in_waves.length *= 2.0;
  for (GmChange& change : ship_.gm_in_waves.by_height) {
    change = {2.0F * change.least, 2.0F * change.greatest, 2.0F * change.mean};
  }
  ship_.roll.shortest *= std::sqrt(2.0);
  ship_.roll.longest *= std::sqrt(2.0);
  ship_.speeds[1] *= std::sqrt(2.0);
  for (double& omega : omega_) {
    omega /= std::sqrt(2.0);
  }
  sea({{8.0, 10.0 * std::sqrt(2.0), 30.0}, {12.4, 13.0 * std::sqrt(2.0), 100.0}});
  std::size_t i = 0;
  for (double heading = 0.0; heading < 360.0; heading += 7.0) {
    for (double knots = 2.0; knots < 26.0; knots += 3.1) {
      EXPECT_EQ(bits(heading, std::sqrt(2.0) * knots), small[i++]) << heading << " " << knots;
    }
  }
}

}  // namespace
}  // namespace quickstrip
