// What the advisor makes of the statistics, with the S-175: swell-up, quality that travels with the number,
// propeller emergence as a criterion, and moments against two thousand frequencies.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <span>

#include "core/advice/nordforsk.hpp"
#include "core/advice/quality.hpp"
#include "core/advisor.hpp"
#include "core/response/relative_motion.hpp"
#include "core/response/short_term.hpp"
#include "core/sea/spectrum.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "msgs/files/hull_file.hpp"

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;

/// Two advisors of one ship, with swell-up and without.
class StatisticsOfTheS175 : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    hull_ = std::make_unique<Hull>();
    ASSERT_TRUE(read_hull_file(QUICKSTRIP_SOURCE_DIR "/sim/hulls/s175.hull.toml", *hull_).ok());
    Criteria criteria = *nordforsk_merchant(*hull_);
    ASSERT_TRUE(criteria.push_back({.name = Name("propeller"),
                                    .quantity = Quantity::kPropellerEmergence,
                                    .statistic = Statistic::kProbability,
                                    .limit = 0.25}));
    on_ = std::make_unique<Advisor>();
    off_ = std::make_unique<Advisor>();
    StripMethod method;
    ASSERT_TRUE(on_->configure(*hull_, criteria, method).ok());
    method.swell_up = SwellUp::kOff;
    ASSERT_TRUE(off_->configure(*hull_, criteria, method).ok());
  }
  static void TearDownTestSuite() {
    on_.reset();
    off_.reset();
    hull_.reset();
  }
  /// Her storm: what the paper's ship and the recorded hurricane have in common.
  void SetUp() override {
    WaveSystem storm;
    storm.hs = 9.0;
    storm.period = 11.0;
    storm.period_kind = PeriodKind::kMean;
    storm.from = {radians(30.0)};
    storm.spreading = radians(25.0);
    ASSERT_TRUE(sea_.systems.push_back(storm));
  }
  const StepOutput& step(Advisor& advisor, std::optional<double> depth = std::nullopt) {
    OwnShip ship{.heading = {radians(30.0)}, .speed = 16.0 * kKnot};
    ship.water_depth = depth;
    return advisor.step({.sea_state = &sea_, .own_ship = &ship});
  }
  static const QuantityResponse& of(const StepOutput& output, Quantity quantity) {
    for (const QuantityResponse& response : output.present.quantities) {
      if (response.quantity == quantity) {
        return response;
      }
    }
    ADD_FAILURE();
    return output.present.quantities[0];
  }

  static std::unique_ptr<Hull> hull_;
  static std::unique_ptr<Advisor> on_;
  static std::unique_ptr<Advisor> off_;
  SeaState sea_;
};

std::unique_ptr<Hull> StatisticsOfTheS175::hull_;
std::unique_ptr<Advisor> StatisticsOfTheS175::on_;
std::unique_ptr<Advisor> StatisticsOfTheS175::off_;

TEST_F(StatisticsOfTheS175, WithoutSwellUpEveryCellOfTheStormIsSaidToBeSafer) {
  const Grid& on = step(*on_).grid;
  const Grid& off = step(*off_).grid;
  float most_slams = 0.0F;
  float most_wet = 0.0F;
  for (std::size_t v = 0; v < on.num_speeds; ++v) {
    for (std::size_t h = 0; h < on.num_headings; ++h) {
      const Cell& a = on.cells[v][h];
      const Cell& b = off.cells[v][h];
      EXPECT_GE(a.slam_probability, b.slam_probability);
      EXPECT_GE(a.slams_per_hour, b.slams_per_hour);
      EXPECT_GE(a.wetness_probability, b.wetness_probability);
      EXPECT_EQ(a.rms_roll, b.rms_roll);  // motions are the same
      EXPECT_GE(b.margin, a.margin);
      most_slams = std::max(most_slams, a.slam_probability - b.slam_probability);
      most_wet = std::max(most_wet, a.wetness_probability - b.wetness_probability);
    }
  }
  EXPECT_GT(most_slams, 0.05F);
  EXPECT_GT(most_wet, 0.20F);
  const auto line = [](const char* what, const QuantityResponse& with, const QuantityResponse& without) {
    std::printf("  %-20s probability %.4f off, %.4f onboard; per hour %.1f, %.1f\n", what,
                without.probability, with.probability, without.per_hour, with.per_hour);
  };
  std::printf("S-175, Hs 9 m, T1 11 s from ahead, 16 kn:\n");
  for (const auto& [what, quantity] :
       {std::pair{"slamming", Quantity::kSlamming}, std::pair{"deck wetness", Quantity::kDeckWetness},
        std::pair{"propeller emergence", Quantity::kPropellerEmergence}}) {
    const QuantityResponse with = of(step(*on_), quantity);
    line(what, with, of(step(*off_), quantity));
  }
}

TEST_F(StatisticsOfTheS175, TheFreeboardFallsWithSpeedAloneAndTheGridAgreesWithTheCell) {
  const StepOutput& output = step(*on_);
  const Cell& cell = output.grid.cells[16][6];
  const QuantityResponse& wetness = of(output, Quantity::kDeckWetness);
  EXPECT_NEAR(static_cast<double>(cell.wetness_probability), wetness.probability, 1e-6);
  const Hydrostatics& hydrostatics = on_->loading_summary().hydrostatics;
  const auto model = swell_up_model(SwellUp::kOnboard, *hull_, hull_->loading, hydrostatics);
  ASSERT_TRUE(model);
  const double rise = static_swell_up(*model, 175.0).rise(16.0 * kKnot);
  EXPECT_NEAR(rise, 0.75 * 25.4 / model->entrance_length * std::pow(16.0 * kKnot, 2) / kStandardGravity,
              1e-12);
  const double freeboard = 16.0 - 9.5 - rise;
  EXPECT_NEAR(wetness.probability, std::exp(-0.5 * std::pow(freeboard / wetness.rms, 2)), 1e-12);
}

TEST_F(StatisticsOfTheS175, PropellerEmergenceIsJudgedLikeAnyOtherCriterion) {
  const StepOutput& output = step(*on_);
  const QuantityResponse& propeller = of(output, Quantity::kPropellerEmergence);
  EXPECT_NEAR(propeller.probability, std::exp(-0.5 * std::pow(3.0 / propeller.rms, 2)), 1e-12);  // 9.5 - 6.5
  const std::size_t criterion = on_->criteria().size() - 1;
  EXPECT_NEAR(static_cast<double>(output.advice.present.values[criterion]), propeller.probability, 1e-6);
  EXPECT_NEAR(static_cast<double>(output.grid.cells[16][6].values[criterion]), propeller.probability, 1e-6);
}

TEST_F(StatisticsOfTheS175, ShallowWaterAndSwellUpOutsideItsRangeAreSaidInEveryCell) {
  EXPECT_EQ(step(*on_).quality & kQualityShallowWater, 0u);  // depth not known
  // Tp = T1 / 0.7722 = 14.2 s: half the wave length is 158 m.
  EXPECT_EQ(step(*on_, 160.0).quality & kQualityShallowWater, 0u);
  EXPECT_NE(step(*on_, 156.0).quality & kQualityShallowWater, 0u);
  EXPECT_NE(step(*on_, 156.0).grid.cells[3][3].quality & kQualityShallowWater, 0u);
  EXPECT_NE(step(*on_, std::nan("")).quality & kQualityShallowWater, 0u);
  sea_.systems[0].period = 3.0;  // waves of 23 m: three draughts speak
  sea_.systems[0].hs = 0.5;
  EXPECT_EQ(step(*on_, 28.6).quality & kQualityShallowWater, 0u);
  EXPECT_NE(step(*on_, 28.4).quality & kQualityShallowWater, 0u);
  EXPECT_NE(step(*on_).grid.cells[3][3].quality & kQualitySwellUpRange, 0u);  // CB 0.57
  EXPECT_EQ(step(*off_).grid.cells[3][3].quality & kQualitySwellUpRange, 0u);
}

TEST_F(StatisticsOfTheS175, WhatTheHullItselfIsSaidToLackIsSaid) {
  const auto loaded = std::make_unique<LoadedHull>();
  ASSERT_TRUE(load(*hull_, hull_->loading, StripMethod{}, *loaded).ok());
  EXPECT_EQ(on_->hull_quality(), hull_quality(*loaded, hull_->loading));
  Loading loading = hull_->loading;
  EXPECT_EQ(hull_quality(*loaded, loading), kQualityReplacedSection);  // her ends
  loaded->has_replaced_section = false;
  EXPECT_EQ(hull_quality(*loaded, loading), 0u);
  loaded->roll_damping.outside_range = kOutsideMidshipCoefficient;
  EXPECT_EQ(hull_quality(*loaded, loading), kQualityRollDampingRange);
  loaded->breadth = 0.34 * loaded->lpp;
  loading.free_surface_correction.reset();
  EXPECT_EQ(hull_quality(*loaded, loading),
            kQualityRollDampingRange | kQualityLowLengthBreadth | kQualityFreeSurfaceUnknown);
  const double limit = 0.35 * std::sqrt(kStandardGravity * 175.0);
  EXPECT_EQ(speed_quality(0.999 * limit, 175.0, kStandardGravity), 0u);
  EXPECT_EQ(speed_quality(1.001 * limit, 175.0, kStandardGravity), kQualityHighFroude);
}

TEST_F(StatisticsOfTheS175, WideBandIsSaidOfWatchedResponsesAndTheirBandwidthIsGiven) {
  const StepOutput& output = step(*on_);
  const QuantityResponse& slamming = of(output, Quantity::kSlamming);
  EXPECT_GT(slamming.bandwidth, kWideBandwidth);
  EXPECT_NE(output.present.cell.quality & kQualityWideBand, 0u);
  EXPECT_EQ(of(output, Quantity::kSurge).bandwidth, static_cast<double>(kNotComputed));  // not watched
  EXPECT_LT(of(output, Quantity::kRoll).bandwidth, kWideBandwidth);
}

TEST_F(StatisticsOfTheS175, MomentsAreThoseOfTwoThousandFrequencies) {
  // Long-crested, from 40 degrees on the bow: a direction and a speed that are solved.
  sea_.systems[0].spreading = 0.0;
  sea_.systems[0].from = {radians(0.0)};
  const double speed = 16.0 * kKnot;
  const EncounterAngle mu{radians(-140.0)};  // heading 40, from 0
  OwnShip ship{.heading = {radians(40.0)}, .speed = speed};
  const StepOutput& output = off_->step({.sea_state = &sea_, .own_ship = &ship});
  const Result<Spectrum> spectrum = spectrum_of(sea_.systems[0]);
  ASSERT_TRUE(spectrum);
  const auto floating = std::make_unique<LoadedHull>();
  ASSERT_TRUE(load(*hull_, hull_->loading, StripMethod{}, *floating).ok());
  const LoadedHull& loaded = *floating;
  const Position station{157.5 - loaded.hydrostatics.lcb, 0.0, 0.0};
  struct Sums {
    double m0 = 0.0;
    double m2 = 0.0;
  };
  std::array<Sums, 4> sums{};  // heave, pitch, vertical acceleration at the bridge, relative motion
  constexpr int kFrequencies = 2000;
  const double from = off_->transfer_functions().omega[0];
  const double to = off_->transfer_functions().omega[off_->transfer_functions().num_frequencies - 1];
  const double step_of = (to - from) / kFrequencies;
  const PointOfInterest& bridge = hull_->points[0];
  const Position point{bridge.x - loaded.hydrostatics.lcb, bridge.y, bridge.z - loaded.hydrostatics.kg};
  for (int i = 0; i < kFrequencies; ++i) {
    const double omega = from + (i + 0.5) * step_of;
    const MotionTransfer t = motion_transfer(loaded, omega, mu, speed);
    const double energy = density(*spectrum, omega) * step_of;
    const double we2 = t.encounter_frequency * t.encounter_frequency;
    const std::array<double, 4> h2{
        std::norm(t.motion[2]), std::norm(t.motion[4]),
        std::norm(point_acceleration(t, point, kStandardGravity).z),
        std::norm(relative_motion(t, station, omega * omega / kStandardGravity, mu))};
    for (std::size_t j = 0; j < sums.size(); ++j) {
      sums[j].m0 += h2[j] * energy;
      sums[j].m2 += h2[j] * we2 * energy;
    }
  }
  const std::array<Quantity, 4> quantities{Quantity::kHeave, Quantity::kPitch,
                                           Quantity::kVerticalAcceleration, Quantity::kSlamming};
  for (std::size_t j = 0; j < sums.size(); ++j) {
    const QuantityResponse& response = of(output, quantities[j]);
    const double m0 = response.rms * response.rms;
    const double m2 = m0 * std::pow(kTwoPi / response.t2, 2);
    std::printf("  quantity %d: m0 %+.2f %%, m2 %+.2f %% of 2,000 frequencies\n",
                static_cast<int>(quantities[j]), 100.0 * (m0 / sums[j].m0 - 1.0),
                100.0 * (m2 / sums[j].m2 - 1.0));
    EXPECT_NEAR(m0 / sums[j].m0, 1.0, 0.01);  // |H|^2 is a straight line between 48 frequencies
    EXPECT_NEAR(m2 / sums[j].m2, 1.0, 0.01);
  }
}

TEST_F(StatisticsOfTheS175, AmplitudesGrowWithTheWavesAndAMirroredSeaHasTheMirroredAnswer) {
  const double once = of(step(*on_), Quantity::kDeckWetness).rms;
  sea_.systems[0].hs *= 0.5;
  EXPECT_NEAR(of(step(*on_), Quantity::kDeckWetness).rms, 0.5 * once, 1e-12 * once);
  sea_.systems[0].from = {radians(70.0)};  // 40 degrees to starboard of the course
  const StepOutput& starboard = step(*on_);
  const double roll = of(starboard, Quantity::kRoll).rms;
  const double slamming = of(starboard, Quantity::kSlamming).probability;
  sea_.systems[0].from = {radians(350.0)};  // to port
  EXPECT_NEAR(of(step(*on_), Quantity::kRoll).rms, roll, 1e-9 * roll);
  EXPECT_NEAR(of(step(*on_), Quantity::kSlamming).probability, slamming, 1e-9);
}

}  // namespace
}  // namespace quickstrip
