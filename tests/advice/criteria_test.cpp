#include "core/advice/criteria.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "core/advice/nordforsk.hpp"
#include "core/advice/people_channels.hpp"
#include "core/base/angles.hpp"
#include "tests/response/synthetic.hpp"

namespace quickstrip {
namespace {

class CriteriaProfile : public testing::Test {
 protected:
  CriteriaProfile() { synthetic::fill_box(*hull_); }
  const Criterion& find(const Criteria& criteria, const std::string& name) {
    for (const Criterion& criterion : criteria) {
      if (criterion.name.view() == name) {
        return criterion;
      }
    }
    ADD_FAILURE() << "no criterion " << name;
    return criteria.front();
  }
  double limit(double lpp, const std::string& name) {
    hull_->lpp = lpp;
    const auto criteria = nordforsk_merchant(*hull_);
    return find(*criteria, name).limit;
  }
  Status check(const Criterion& criterion) {
    Criteria criteria;
    EXPECT_TRUE(criteria.push_back(criterion));
    return check_criteria(criteria, *hull_);
  }
  std::unique_ptr<Hull> hull_ = std::make_unique<Hull>();
};

constexpr double kG = kStandardGravity;

TEST_F(CriteriaProfile, NordforskForMerchantShipsHasThePublishedFigures) {
  // NORDFORSK 1987 as in Faltinsen, Sea Loads, table 1.1.
  EXPECT_NEAR(limit(60.0, "roll"), radians(6.0), 1e-15);
  EXPECT_NEAR(limit(60.0, "vertical acc. at fp"), 0.275 * kG, 1e-12);
  EXPECT_NEAR(limit(100.0, "vertical acc. at fp"), 0.275 * kG, 1e-12);
  EXPECT_NEAR(limit(330.0, "vertical acc. at fp"), 0.05 * kG, 1e-12);
  EXPECT_NEAR(limit(400.0, "vertical acc. at fp"), 0.05 * kG, 1e-12);
  EXPECT_NEAR(limit(175.0, "vertical acc. at fp"), (0.275 - 0.225 * 75.0 / 230.0) * kG, 1e-12);
  EXPECT_NEAR(limit(175.0, "vertical acc. at bridge"), 0.15 * kG, 1e-12);
  EXPECT_NEAR(limit(175.0, "lateral acc. at bridge"), 0.12 * kG, 1e-12);
  EXPECT_NEAR(limit(90.0, "slamming at bow"), 0.03, 1e-15);
  EXPECT_NEAR(limit(200.0, "slamming at bow"), 0.02, 1e-15);
  EXPECT_NEAR(limit(320.0, "slamming at bow"), 0.01, 1e-15);
  EXPECT_NEAR(limit(175.0, "deck wetness at bow"), 0.05, 1e-15);
}

TEST_F(CriteriaProfile, NordforskPassesItsOwnCheckAndJudgesByRmsAndProbability) {
  const auto criteria = nordforsk_merchant(*hull_);
  ASSERT_TRUE(criteria.ok());
  EXPECT_TRUE(check_criteria(*criteria, *hull_).ok());
  EXPECT_EQ(criteria->size(), 6u);
  EXPECT_EQ(find(*criteria, "roll").statistic, Statistic::kRms);
  EXPECT_EQ(find(*criteria, "slamming at bow").statistic, Statistic::kProbability);
}

TEST_F(CriteriaProfile, NordforskListsWhatTheHullCannotGiveAsNotWatched) {
  hull_->points.clear();
  hull_->slamming.clear();
  hull_->freeboard.clear();
  const auto criteria = nordforsk_merchant(*hull_);
  ASSERT_TRUE(criteria.ok());
  EXPECT_EQ(criteria->size(), 6u);  // none is left out in silence
  for (const Criterion& criterion : *criteria) {
    EXPECT_EQ(criterion.is_watched(), criterion.quantity == Quantity::kRoll) << criterion.name.view();
  }
  EXPECT_TRUE(check_criteria(*criteria, *hull_).ok());
}

TEST_F(CriteriaProfile, NordforskWatchesEveryPlaceOfARole) {
  ASSERT_TRUE(hull_->points.push_back({Name("bridge wing"), PointRole::kBridge, 20.0, -9.0, 20.0}));
  const auto criteria = nordforsk_merchant(*hull_);
  EXPECT_EQ(find(*criteria, "vertical acc. at bridge wing").place, 2);
  EXPECT_EQ(find(*criteria, "lateral acc. at bridge wing").place, 2);
}

TEST_F(CriteriaProfile, NordforskSaysNoWhenTheProfileIsTooLong) {
  while (hull_->points.push_back({Name("bridge"), PointRole::kBridge, 20.0, 0.0, 20.0})) {
  }
  EXPECT_EQ(nordforsk_merchant(*hull_).error(), Error::kTooMany);
}

TEST_F(CriteriaProfile, NamesAreCutBetweenCharacters) {
  hull_->points[0].name = Name("Br\u00fccke \u00e4\u00e4\u00e4\u00e4\u00e4\u00e4");
  const auto criteria = nordforsk_merchant(*hull_);
  const std::string name((*criteria)[2].name.view());
  EXPECT_LE(name.size(), kMaxNameBytes - 1);
  // A whole number of characters: the last byte ends one (0xA4 after 0xC3), none stands alone.
  EXPECT_EQ(static_cast<unsigned char>(name.back()), 0xA4u);
}

TEST_F(CriteriaProfile, RefusesStatisticsThatDoNotSuitTheQuantity) {
  EXPECT_FALSE(check({.quantity = Quantity::kRoll, .statistic = Statistic::kProbability, .limit = 0.1}).ok());
  EXPECT_FALSE(check({.quantity = Quantity::kSlamming, .statistic = Statistic::kRms, .limit = 0.1}).ok());
  EXPECT_TRUE(check({.quantity = Quantity::kSlamming, .statistic = Statistic::kPerHour, .limit = 5.0}).ok());
}

TEST_F(CriteriaProfile, PeopleAreJudgedByTheirOwnStatisticsAlone) {
  for (const Statistic statistic : {Statistic::kRms, Statistic::kSignificant, Statistic::kProbability,
                                    Statistic::kPerHour, Statistic::kShareOfPeople, Statistic::kPerMinute}) {
    EXPECT_EQ(check({.quantity = Quantity::kMotionSickness, .statistic = statistic, .limit = 0.1}).ok(),
              statistic == Statistic::kShareOfPeople);
    EXPECT_EQ(check({.quantity = Quantity::kMotionInterruptions, .statistic = statistic, .limit = 0.1}).ok(),
              statistic == Statistic::kPerMinute);
  }
  Criterion sick{.quantity = Quantity::kMotionSickness, .statistic = Statistic::kShareOfPeople, .limit = 0.2};
  for (const double exposure : {-1.0, 60.0, 1e6, std::nan("")}) {
    sick.exposure = exposure;
    EXPECT_FALSE(check(sick).ok()) << exposure;
  }
  Criterion standing{
      .quantity = Quantity::kMotionInterruptions, .statistic = Statistic::kPerMinute, .limit = 1.0};
  for (const Stance& stance : {Stance{0.0, 0.25}, Stance{1.2, std::nan("")}, Stance{1.2, 1.0}}) {
    standing.stance = stance;
    EXPECT_FALSE(check(standing).ok());
  }
}

TEST_F(CriteriaProfile, InterruptionsAtOnePlaceHaveOneStance) {
  Criteria criteria;
  const Criterion standing{
      .quantity = Quantity::kMotionInterruptions, .statistic = Statistic::kPerMinute, .limit = 1.0};
  ASSERT_TRUE(criteria.push_back(standing) && criteria.push_back(standing));
  EXPECT_TRUE(check_criteria(criteria, *hull_).ok());
  criteria[1].stance.half_width_ratio = 0.17;
  EXPECT_FALSE(check_criteria(criteria, *hull_).ok());
  criteria[1].place = 1;
  EXPECT_TRUE(check_criteria(criteria, *hull_).ok());
}

TEST_F(CriteriaProfile, SaysNoToMorePeopleThanTheWatchHasRoomFor) {
  Watch watch;
  Criteria criteria;
  for (std::uint8_t place = 0; place < kMaxPoints; ++place) {
    ASSERT_TRUE(watch.channels.push_back({.quantity = Quantity::kVerticalAcceleration, .place = place}));
  }
  for (std::uint8_t place = 0; place <= kMaxPeopleChannels / 2; ++place) {
    EXPECT_TRUE(list_people_channels(criteria, watch).ok());
    ASSERT_TRUE(criteria.push_back({.quantity = Quantity::kMotionInterruptions,
                                    .place = place,
                                    .statistic = Statistic::kPerMinute,
                                    .limit = 1.0}));
    ASSERT_TRUE(watch.channels.resize(kMaxPoints));
  }
  EXPECT_EQ(list_people_channels(criteria, watch).error(), Error::kTooMany);
}

TEST_F(CriteriaProfile, RefusesLimitsThatAreNotPositiveNumbersAndPlacesThatDoNotExist) {
  EXPECT_FALSE(check({.limit = 0.0}).ok());
  EXPECT_FALSE(check({.limit = -1.0}).ok());
  EXPECT_EQ(check({.limit = std::nan("")}).error(), Error::kNotFinite);
  EXPECT_FALSE(check({.limit = 0.1, .caution_fraction = 1.2}).ok());
  EXPECT_FALSE(check({.limit = 0.1, .caution_fraction = std::nan("")}).ok());
  EXPECT_FALSE(
      check({.quantity = Quantity::kDeckWetness, .statistic = Statistic::kProbability, .limit = 1.0}).ok());
  EXPECT_FALSE(check({.quantity = Quantity::kVerticalAcceleration, .place = 2, .limit = 1.0}).ok());
  EXPECT_TRUE(check({.quantity = Quantity::kVerticalAcceleration, .place = 1, .limit = 1.0}).ok());
}

}  // namespace
}  // namespace quickstrip
