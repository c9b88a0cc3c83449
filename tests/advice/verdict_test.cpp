#include "core/advice/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "tests/advice/scene.hpp"
#include "tests/support/single_precision.hpp"

namespace quickstrip {
namespace {

using synthetic::Scene;

/// One watched roll channel and whatever criteria a test wants; moments by hand.
class VerdictRules : public testing::Test {
 protected:
  VerdictRules() {
    add(Quantity::kRoll, {});
    add(Quantity::kSlamming, {.quantity = Quantity::kSlamming, .level = 5.0, .threshold_velocity = 3.6});
    add(Quantity::kDeckWetness, {.quantity = Quantity::kDeckWetness, .level = 6.0});
  }
  void add(Quantity, const Channel& channel) { EXPECT_TRUE(watch_.channels.push_back(channel)); }
  void limit(Quantity quantity, Statistic statistic, double value, std::uint8_t place = 0) {
    EXPECT_TRUE(
        criteria_.push_back({.quantity = quantity, .place = place, .statistic = statistic, .limit = value}));
  }
  Cell cell(std::uint16_t hazards = 0, double slow_waves = 0.0) {
    return judge(criteria_, bind_criteria(criteria_, watch_), watch_, moments_,
                 {.quality = 4, .hazards = hazards, .low_encounter_share = slow_waves});
  }
  ResponseMoments& roll() { return moments_[0]; }
  ResponseMoments& bow() { return moments_[1]; }
  ResponseMoments& deck() { return moments_[2]; }

  Watch watch_;
  Criteria criteria_;
  std::array<ResponseMoments, 3> moments_{};
};

TEST_F(VerdictRules, GoodCautionAndExceededFollowTheLimitAndItsFraction) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  roll().m0 = std::pow(0.0749, 2);
  EXPECT_EQ(cell().verdict, Verdict::kGood);
  roll().m0 = std::pow(0.0751, 2);
  EXPECT_EQ(cell().verdict, Verdict::kCaution);
  roll().m0 = std::pow(0.1001, 2);
  EXPECT_EQ(cell().verdict, Verdict::kExceeded);
}

TEST_F(VerdictRules, RmsIsNeverJudgedAgainstASignificantValue) {
  limit(Quantity::kRoll, Statistic::kSignificant, 0.1);
  roll().m0 = std::pow(0.06, 2);  // significant 0.12
  EXPECT_EQ(cell().verdict, Verdict::kExceeded);
  EXPECT_NEAR(static_cast<double>(cell().values[0]), 0.12, 1e-7);  // float
}

TEST_F(VerdictRules, TheSmallestMarginGoverns) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  limit(Quantity::kDeckWetness, Statistic::kProbability, 0.05);
  roll().m0 = std::pow(0.05, 2);  // margin 2
  deck().m0 = 36.0 / (2.0 * std::log(20.0)) / 2.25;
  EXPECT_EQ(cell().governing, 1);
  EXPECT_NEAR(static_cast<double>(cell().margin), 1.5, 1e-6);  // float
}

// "Near a limit: deck wetness 0.9 %, limit 5 %" was said when it was the roll that gave cause for caution.
TEST_F(VerdictRules, CautionIsGovernedByTheCriterionThatCausesIt) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  limit(Quantity::kDeckWetness, Statistic::kProbability, 0.05);
  roll().m0 = std::pow(0.1 / 1.3, 2);                            // margin 1.3, above 0.75 of the limit
  deck().m0 = 36.0 / (2.0 * std::log(20.0)) / std::pow(1.2, 2);  // margin 1.2, P = 1.3 %
  EXPECT_EQ(cell().verdict, Verdict::kCaution);
  EXPECT_EQ(cell().governing, 0);
  EXPECT_NEAR(static_cast<double>(cell().margin), 1.3, 1e-6);  // float
}

TEST_F(VerdictRules, NoCellIsGoodWithACriterionThatIsNotWatched) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  limit(Quantity::kVerticalAcceleration, Statistic::kRms, 1.5, kNowhere);
  roll().m0 = std::pow(0.02, 2);
  EXPECT_EQ(cell().verdict, Verdict::kUnknown);
  EXPECT_EQ(cell().values[1], kNotComputed);
  EXPECT_EQ(cell().governing, 0);
  roll().m0 = std::pow(0.08, 2);
  EXPECT_EQ(cell().verdict, Verdict::kCaution);
  roll().m0 = std::pow(0.2, 2);
  EXPECT_EQ(cell().verdict, Verdict::kExceeded);
}

TEST_F(VerdictRules, NoCellIsGoodWithoutAnyCriterion) {
  EXPECT_EQ(cell().verdict, Verdict::kUnknown);
  EXPECT_EQ(cell().governing, kNoCriterion);
  limit(Quantity::kRoll, Statistic::kRms, 0.1, kNowhere);
  EXPECT_EQ(cell().verdict, Verdict::kUnknown);
}

TEST_F(VerdictRules, MoreThanAFifthBelowTheEncounterFloorIsUnknownUnlessExceeded) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  roll().m0 = std::pow(0.05, 2);
  roll().m0_low_encounter = 0.199 * roll().m0;
  EXPECT_EQ(cell().verdict, Verdict::kGood);
  EXPECT_NE(cell().quality & kQualityLowEncounter, 0u);
  EXPECT_EQ(cell().hazards & kHazardFollowingUnwatched, 0);
  roll().m0_low_encounter = 0.201 * roll().m0;
  EXPECT_EQ(cell().verdict, Verdict::kUnknown);
  EXPECT_NE(cell().hazards & kHazardFollowingUnwatched, 0);
  roll() = {.m0 = std::pow(0.08, 2), .m0_low_encounter = 0.3 * std::pow(0.08, 2)};
  EXPECT_EQ(cell().verdict, Verdict::kUnknown);
  roll() = {.m0 = std::pow(0.11, 2), .m0_low_encounter = 0.3 * std::pow(0.11, 2)};
  EXPECT_EQ(cell().verdict, Verdict::kExceeded);
}

TEST_F(VerdictRules, MoreThanAFifthOfTheWavesPassingSlowlyIsUnknownWhateverTheMotions) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  roll().m0 = std::pow(0.05, 2);
  EXPECT_EQ(cell(0, 0.19).verdict, Verdict::kGood);
  EXPECT_EQ(cell(0, 0.21).verdict, Verdict::kUnknown);
  EXPECT_NE(cell(0, 0.21).hazards & kHazardFollowingUnwatched, 0);
}

TEST_F(VerdictRules, AZoneIsCautionAndItsWarningIsExceededWhateverTheMotions) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  roll().m0 = std::pow(0.01, 2);
  for (std::size_t i = 0; i < kNumHazardBits; ++i) {
    const auto bit = static_cast<std::uint16_t>(1u << i);
    const bool is_warning = (bit & kSevereZoneBits) != 0;
    const bool is_zone = (bit & kZoneBits) != 0;
    const bool is_unknown = bit == kHazardZonesUnknown || bit == kHazardFollowingUnwatched;
    const Verdict expected = is_warning   ? Verdict::kExceeded
                             : is_zone    ? Verdict::kCaution
                             : is_unknown ? Verdict::kUnknown
                                          : Verdict::kGood;
    EXPECT_EQ(cell(bit).verdict, expected) << i;
    EXPECT_EQ(cell(bit).margin, cell().margin);  // margin and governing criterion are the motions' own
  }
  // Where linear motions say nothing the zone still does.
  EXPECT_EQ(cell(kHazardSurfRiding, 0.5).verdict, Verdict::kCaution);
  EXPECT_EQ(cell(kHazardSurfRiding | kHazardSurfRidingWaves, 0.5).verdict, Verdict::kExceeded);
  EXPECT_EQ(cell(kHazardSurfRiding | kHazardZonesUnknown).verdict, Verdict::kCaution);
}

TEST_F(VerdictRules, ZoneOnlyMotionOnlyAndBothAreToldApart) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  const auto told = [&](double rms, std::uint16_t zones) {
    roll().m0 = rms * rms;
    const unsigned hazards = cell(zones).hazards;
    return std::pair((hazards & kZoneBits) != 0, (hazards & kHazardMotions) != 0);
  };
  EXPECT_EQ(told(0.05, 0), std::pair(false, false));
  EXPECT_EQ(told(0.05, kHazardSynchronousRoll), std::pair(true, false));
  EXPECT_EQ(told(0.08, 0), std::pair(false, true));
  EXPECT_EQ(told(0.11, kHazardSynchronousRoll), std::pair(true, true));
}

TEST_F(VerdictRules, AMomentThatIsNotANumberMakesTheCellUnknownWithoutValues) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    roll().m0 = bad;
    EXPECT_EQ(cell().verdict, Verdict::kUnknown);
    EXPECT_EQ(cell().values[0], kNotComputed);
    EXPECT_EQ(cell().governing, kNoCriterion);
    EXPECT_EQ(cell().margin, 0.0F);
    EXPECT_EQ(cell().quality, 4u);
  }
}

TEST_F(VerdictRules, ACalmSeaHasAnUnboundedMarginAndNothingInfinite) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  limit(Quantity::kSlamming, Statistic::kPerHour, 3.0);
  limit(Quantity::kDeckWetness, Statistic::kProbability, 0.05);
  EXPECT_EQ(cell().verdict, Verdict::kGood);
  EXPECT_EQ(cell().margin, kMarginUnbounded);
  EXPECT_EQ(cell().slam_probability, 0.0F);
  EXPECT_EQ(cell().slams_per_hour, 0.0F);
}

TEST_F(VerdictRules, ColumnsOfPlacesThatTheHullLacksSayNotComputed) {
  watch_.channels.clear();
  ASSERT_TRUE(watch_.channels.push_back({}));
  limit(Quantity::kPitch, Statistic::kRms, 0.1, kNowhere);
  const Cell alone =
      judge(criteria_, bind_criteria(criteria_, watch_), watch_, std::span(moments_).first(1), {});
  EXPECT_EQ(alone.rms_bridge_vertical, kNotComputed);
  EXPECT_EQ(alone.slam_probability, kNotComputed);
  EXPECT_EQ(alone.slams_per_hour, kNotComputed);
  EXPECT_EQ(alone.wetness_probability, kNotComputed);
  EXPECT_EQ(alone.roll_exceedance, kNotComputed);  // no roll limit
  EXPECT_EQ(alone.rms_roll, 0.0F);
}

TEST_F(VerdictRules, AtTheRmsRollLimitTheSignificantAmplitudeIsExceededByEToTheMinusTwo) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  roll().m0 = 0.01;
  EXPECT_NEAR(static_cast<double>(cell().roll_exceedance), std::exp(-2.0), 1e-7);  // float
}

TEST_F(VerdictRules, RollAboveTenDegreesRmsIsFlagged) {
  limit(Quantity::kRoll, Statistic::kRms, 0.1);
  roll().m0 = std::pow(radians(10.1), 2);
  EXPECT_NE(cell().quality & kQualityExtremeMotion, 0u);
  roll().m0 = std::pow(radians(9.9), 2);
  EXPECT_EQ(cell().quality & kQualityExtremeMotion, 0u);
}

/// Scaling every wave height by the margin must land exactly on the limit: 1e-6 asked, rounding gives 1e-12.
class MarginLaw : public testing::TestWithParam<Criterion> {};

TEST_P(MarginLaw, WaveHeightsScaledByTheMarginLandOnTheLimit) {
  const Criterion& criterion = GetParam();
  auto scene = std::make_unique<Scene>();
  synthetic::add_system(scene->sea, scene->transfer, 3.0, 7.0, 8, 6);
  Criteria people;
  ASSERT_TRUE(people.push_back(criterion));
  ASSERT_TRUE(list_people_channels(people, scene->watch).ok());
  const std::size_t c = find_channel(scene->watch, criterion.quantity, criterion.place);
  ASSERT_LT(c, scene->watch.channels.size());
  const Channel& channel = scene->watch.channels[c];
  std::array<ResponseMoments, kMaxChannels> all{};
  const auto moments = std::span(all).first(scene->watch.channels.size());
  const auto of_criterion = moments_of(criterion, c, moments);
  ASSERT_TRUE(
      response_moments(scene->transfer, scene->watch, scene->sea, {radians(30.0)}, 4.5, moments).ok());
  const double margin = height_margin(criterion, channel, 0.0, of_criterion);
  ASSERT_GT(margin, 0.05);
  ASSERT_LT(margin, 50.0);
  ASSERT_GT(std::abs(margin - 1.0), 0.02);  // otherwise nothing is tested
  synthetic::scale_heights(scene->sea, margin);
  ASSERT_TRUE(
      response_moments(scene->transfer, scene->watch, scene->sea, {radians(30.0)}, 4.5, moments).ok());
  EXPECT_NEAR(criterion_value(criterion, channel, 0.0, of_criterion) / criterion.limit, 1.0, kSingle);
}

Criterion sick(double limit, double exposure) {
  return {.quantity = Quantity::kMotionSickness,
          .statistic = Statistic::kShareOfPeople,
          .limit = limit,
          .exposure = exposure};
}

Criterion tipping(double per_minute, double half_width_ratio) {
  return {.quantity = Quantity::kMotionInterruptions,
          .statistic = Statistic::kPerMinute,
          .limit = per_minute,
          .stance = {1.2, half_width_ratio}};
}

INSTANTIATE_TEST_SUITE_P(
    EveryStatistic, MarginLaw,
    testing::Values(
        Criterion{.quantity = Quantity::kRoll, .statistic = Statistic::kRms, .limit = 0.05},
        Criterion{.quantity = Quantity::kRoll, .statistic = Statistic::kSignificant, .limit = 0.05},
        Criterion{.quantity = Quantity::kPitch, .statistic = Statistic::kRms, .limit = 0.1},
        Criterion{.quantity = Quantity::kLateralAcceleration, .statistic = Statistic::kRms, .limit = 1.2},
        Criterion{.quantity = Quantity::kSlamming, .statistic = Statistic::kProbability, .limit = 0.02},
        Criterion{.quantity = Quantity::kSlamming, .statistic = Statistic::kPerHour, .limit = 5.0},
        Criterion{.quantity = Quantity::kDeckWetness, .statistic = Statistic::kProbability, .limit = 0.05},
        Criterion{.quantity = Quantity::kDeckWetness, .statistic = Statistic::kPerHour, .limit = 30.0},
        sick(0.1, 0.0), sick(0.2, 4.0 * 3600.0), sick(0.01, 1800.0), tipping(1.0, 0.25), tipping(0.1, 0.25),
        tipping(5.0, 0.17)));

TEST(Margin, OfInterruptionsIsUnboundedWhenThereAreFewerOscillationsThanAllowed) {
  const Criterion criterion = tipping(20.0, 0.25);
  const Channel channel{.quantity = Quantity::kMotionInterruptions, .level = 0.25 * kStandardGravity};
  const std::array sides{ResponseMoments{.m0 = 100.0, .m2 = 100.0},  // 9.5 a minute, each
                         ResponseMoments{.m0 = 90.0, .m2 = 90.0}};
  EXPECT_EQ(height_margin(criterion, channel, 0.0, sides), static_cast<double>(kMarginUnbounded));
  const std::array still{ResponseMoments{}, ResponseMoments{}};
  EXPECT_EQ(height_margin(tipping(1.0, 0.25), channel, 0.0, still), static_cast<double>(kMarginUnbounded));
}

TEST_F(VerdictRules, InterruptionsAreTheSumOfBothSidesAndTheirSystemsToo) {
  Scene scene;
  ASSERT_TRUE(scene.criteria.push_back(tipping(1.0, 0.25)));
  const std::size_t index = scene.criteria.size() - 1;
  ASSERT_TRUE(list_people_channels(scene.criteria, scene.watch).ok());
  scene.channels = bind_criteria(scene.criteria, scene.watch);
  synthetic::add_system(scene.sea, scene.transfer, 6.0, 9.0, 8, 6);
  scene.sweep();
  const std::size_t c = scene.channels.of_criterion[index];
  EXPECT_TRUE(scene.channels.is_watched[c] && scene.channels.is_watched[c + 1]);
  double largest = 0.0;
  for (std::size_t h = 0; h < scene.grid.num_headings; h += 7) {
    const Heading heading{kTwoPi * static_cast<double>(h) / static_cast<double>(scene.grid.num_headings)};
    ASSERT_TRUE(respond(scene.inputs(), heading, scene.grid.speeds[3], scene.response).ok());
    const auto& of = scene.response.quantities;
    const double per_minute = (of[c].per_hour + of[c + 1].per_hour) / 60.0;
    const double value = static_cast<double>(scene.grid.cells[3][h].values[index]);
    EXPECT_NEAR(value, per_minute, 1e-6 * per_minute + 1e-12) << h;  // kept in single precision
    EXPECT_TRUE(!of[c].to_starboard && of[c + 1].to_starboard);
    largest = std::max(largest, value);
  }
  EXPECT_GT(largest, 0.1);
}

TEST(Margin, IsUnboundedWhenThereAreFewerOscillationsThanEventsAllowed) {
  const Criterion criterion{
      .quantity = Quantity::kSlamming, .statistic = Statistic::kPerHour, .limit = 1000.0};
  const Channel channel{.quantity = Quantity::kSlamming, .level = 5.0, .threshold_velocity = 3.6};
  ResponseMoments moments{.m0 = 100.0, .m2 = 100.0};  // 573 an hour
  EXPECT_EQ(height_margin(criterion, channel, 0.0, std::span(&moments, 1)),
            static_cast<double>(kMarginUnbounded));
}

}  // namespace
}  // namespace quickstrip
