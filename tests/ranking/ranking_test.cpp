#include "core/advice/ranking.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/ranking/ranking_fixture.hpp"

namespace quickstrip {
namespace {

TEST_F(Ranking, NothingIsRecommendedWhenThePresentStateIsGood) {
  fill(Verdict::kGood, 2.0F);
  advise(8.0, 40.0, false, Verdict::kGood);
  EXPECT_EQ(advice_.no_advice, NoAdvice::kNone);
  EXPECT_FALSE(advice_.change_needed);
  EXPECT_FALSE(advice_.none_is_good);
  EXPECT_FALSE(advice_.no_change_helps);
  EXPECT_TRUE(advice_.changes.empty());
}

TEST_F(Ranking, OffersTheSmallestPureChangeOfSpeedAndTheSmallestPureChangeOfCourse) {
  // "Reduce to 4 kn, or come 30 degrees to port."
  fill(Verdict::kExceeded, 0.8F);
  set(4, 40, Verdict::kGood);
  set(2, 40, Verdict::kGood);
  set(8, 10, Verdict::kGood);
  set(8, 350, Verdict::kGood);
  advise(8.0, 40.0);
  ASSERT_EQ(advice_.changes.size(), 2u);
  expect_change(0, 0.0, -30.0);  // effort 1.5
  expect_change(1, -4.0, 0.0);   // effort 2
  EXPECT_NEAR(advice_.changes[0].effort, 1.5, 1e-12);
  EXPECT_NEAR(advice_.changes[1].effort, 2.0, 1e-12);
  EXPECT_TRUE(advice_.change_needed);
  EXPECT_FALSE(advice_.none_is_good);
}

TEST_F(Ranking, AddsTheCombinedChangeOnlyWhenItIsSmallerThanEveryPureOne) {
  fill(Verdict::kExceeded, 0.8F);
  set(2, 40, Verdict::kGood);  // effort 3
  set(6, 60, Verdict::kGood);  // 2 kn and 20 degrees: effort sqrt(2)
  advise(8.0, 40.0);
  ASSERT_EQ(advice_.changes.size(), 2u);
  expect_change(0, -2.0, 20.0);
  set(8, 50, Verdict::kGood);  // a pure turn of effort 0.5
  advise(8.0, 40.0);
  ASSERT_EQ(advice_.changes.size(), 2u);
  expect_change(0, 0.0, 10.0);
  expect_change(1, -6.0, 0.0);
}

TEST_F(Ranking, PrefersSlowingToSpeedingUpAndStarboardToPortInTies) {
  fill(Verdict::kExceeded, 0.8F);
  set(6, 40, Verdict::kGood);
  set(10, 40, Verdict::kGood);
  set(8, 20, Verdict::kGood);
  set(8, 60, Verdict::kGood);
  advise(8.0, 40.0);  // all of effort 1
  ASSERT_EQ(advice_.changes.size(), 4u);
  expect_change(0, -2.0, 0.0);
  expect_change(1, 0.0, 20.0);
  expect_change(2, 0.0, -20.0);
  expect_change(3, 2.0, 0.0);
}

TEST_F(Ranking, SpeedingUpInFollowingSeasCountsDouble) {
  fill(Verdict::kExceeded, 0.8F);
  set(10, 40, Verdict::kGood);
  set(8, 70, Verdict::kGood);  // effort 1.5
  advise(8.0, 40.0, false);
  expect_change(0, 2.0, 0.0);
  advise(8.0, 40.0, true);
  expect_change(0, 0.0, 30.0);
}

TEST_F(Ranking, NeverRecommendsBelowSteerageNorTheUnknown) {
  fill(Verdict::kExceeded, 0.8F);
  set(6, 40, Verdict::kGood, 2.0F, kHazardNoSteerage);
  set(4, 40, Verdict::kUnknown, 3.0F);
  set(2, 40, Verdict::kCaution, 1.2F, kHazardFollowingUnwatched);
  set(8, 200, Verdict::kGood);
  advise(8.0, 40.0);
  ASSERT_EQ(advice_.changes.size(), 1u);
  expect_change(0, 0.0, 160.0);
}

TEST_F(Ranking, WithoutAGoodCellOffersCautionAndSaysSo) {
  fill(Verdict::kExceeded, 0.8F);
  set(4, 40, Verdict::kCaution, 1.1F);
  advise(8.0, 40.0);
  ASSERT_EQ(advice_.changes.size(), 1u);
  EXPECT_EQ(advice_.changes[0].verdict, Verdict::kCaution);
  EXPECT_TRUE(advice_.none_is_good);
  EXPECT_FALSE(advice_.no_change_helps);
  // For a ship that is at caution already that is no improvement.
  advise(8.0, 40.0, false, Verdict::kCaution, 1.05F);
  EXPECT_TRUE(advice_.none_is_good);
  EXPECT_TRUE(advice_.no_change_helps);
}

TEST_F(Ranking, WhenEverythingExceedsOffersTheLeastBadAndSaysSo) {
  fill(Verdict::kExceeded, 0.7F);
  set(4, 120, Verdict::kExceeded, 0.95F);
  advise(8.0, 40.0, false, Verdict::kExceeded, 0.7F);
  ASSERT_EQ(advice_.changes.size(), 1u);
  expect_change(0, -4.0, 80.0);
  EXPECT_TRUE(advice_.none_is_good);
  EXPECT_EQ(advice_.changes[0].margin, 0.95F);
  set(4, 120, Verdict::kExceeded, 0.7F);
  advise(8.0, 40.0, false, Verdict::kExceeded, 0.7F);
  EXPECT_TRUE(advice_.no_change_helps);
}

TEST_F(Ranking, TurnsTheShortWayThroughNorth) {
  fill(Verdict::kExceeded, 0.8F);
  set(8, 350, Verdict::kGood);
  advise(8.0, 10.0);
  expect_change(0, 0.0, -20.0);
  EXPECT_NEAR(degrees(advice_.changes[0].heading), 350.0, 1e-9);
}

TEST_F(Ranking, APureChangeBetweenTwoColumnsMustHoldInBoth) {
  fill(Verdict::kExceeded, 0.8F);
  set(6, 40, Verdict::kGood);
  advise(8.0, 43.0);
  EXPECT_EQ(advice_.changes[0].heading_change < 0.0,
            true);  // only the cell itself: slow down and turn 3 degrees
  EXPECT_LT(advice_.changes[0].speed_change, 0.0);
  set(6, 50, Verdict::kGood);
  advise(8.0, 43.0);
  expect_change(0, -2.0, 0.0);
}

TEST_F(Ranking, NamesALargerChangeThatBuysMuchMoreMargin) {
  fill(Verdict::kExceeded, 0.8F);
  set(8, 60, Verdict::kGood, 1.4F);  // effort 1
  set(8, 70, Verdict::kGood, 1.7F);  // effort 1.5, margin 1.21 times the first one's
  advise(8.0, 40.0);
  ASSERT_EQ(advice_.changes.size(), 1u);
  EXPECT_EQ(advice_.changes[0].kind, ChangeKind::kSmallest);
  set(8, 80, Verdict::kGood, 1.8F);  // effort 2, 1.286 times
  set(8, 90, Verdict::kGood, 3.0F);  // effort 2.5: more than twice the first one's
  advise(8.0, 40.0);
  ASSERT_EQ(advice_.changes.size(), 2u);
  expect_change(0, 0.0, 20.0);
  expect_change(1, 0.0, 40.0);
  EXPECT_EQ(advice_.changes[1].kind, ChangeKind::kLarger);
}

TEST_F(Ranking, ALargerChangeIsNotNamedForAMarginInsideAnotherZone) {
  fill(Verdict::kExceeded, 0.8F);
  set(8, 60, Verdict::kCaution, 1.1F);
  set(8, 70, Verdict::kCaution, 3.0F, kHazardParametricRoll);
  advise(8.0, 40.0);
  for (const Change& change : advice_.changes) {
    EXPECT_NE(change.kind, ChangeKind::kLarger);
  }
}

TEST_F(Ranking, HeavesToWhenNothingIsGood) {
  fill(Verdict::kExceeded, 0.7F);
  set(0, 100, Verdict::kGood, 2.0F, kHazardNoSteerage);
  for (std::size_t h = 0; h < 36; ++h) {
    grid_->cells[0][h].hazards = kHazardNoSteerage;
  }
  set(2, 100, Verdict::kExceeded, 0.9F);
  set(2, 110, Verdict::kExceeded, 0.95F);
  set(8, 200, Verdict::kExceeded, 0.93F);
  present_cell_ = Cell{.verdict = Verdict::kExceeded, .governing = 0, .margin = 0.7F};
  Present present{{radians(40.0)}, 8.0 * kKnot, false};
  rank_changes(*grid_, present, present_cell_, advice_);
  for (const Change& change : advice_.changes) {
    EXPECT_NE(change.kind, ChangeKind::kHeaveTo) << "no sea is known";
  }
  present.has_sea_ahead = true;
  present.sea_from = {radians(98.0)};
  rank_changes(*grid_, present, present_cell_, advice_);
  std::size_t found = 0;
  for (const Change& change : advice_.changes) {
    if (change.kind == ChangeKind::kHeaveTo) {
      ++found;
      EXPECT_NEAR(degrees(change.heading), 110.0, 1e-9);
      EXPECT_NEAR(change.speed / kKnot, 2.0, 1e-9);
    }
  }
  EXPECT_EQ(found, 1u);
  EXPECT_TRUE(advice_.none_is_good);
}

TEST_F(Ranking, TurnsTheLongerWayWhenTheShorterOneIsClearlyWorse) {
  fill(Verdict::kExceeded, 0.8F);
  set(8, 200, Verdict::kGood, 2.0F);
  advise(8.0, 40.0);
  expect_change(0, 0.0, 160.0);
  // 30 degrees at a quarter of the height that the ship takes: a minute of three more than at the limit.
  for (std::size_t h = 80; h < 130; h += 10) {
    set(8, h, Verdict::kExceeded, 0.2F);
  }
  advise(8.0, 40.0);
  ASSERT_FALSE(advice_.changes.empty());
  expect_change(0, 0.0, -200.0);
  EXPECT_NEAR(degrees(advice_.changes[0].heading), 200.0, 1e-9);
  EXPECT_EQ(advice_.changes[0].turn.worst_margin, 0.8F);
}

TEST_F(Ranking, ATurnThroughWorseCountsAsMoreEffort) {
  fill(Verdict::kExceeded, 0.8F);
  set(8, 10, Verdict::kGood, 1.5F);  // 30 degrees to port
  set(8, 80, Verdict::kGood, 1.5F);  // 40 degrees to starboard
  advise(8.0, 40.0);
  expect_change(0, 0.0, -30.0);
  set(8, 20, Verdict::kExceeded, 0.25F);
  set(8, 30, Verdict::kExceeded, 0.25F);
  advise(8.0, 40.0);
  expect_change(0, 0.0, 40.0);
  // 20 degrees, 40 s, at a badness of 4 where the ship has 1.25 now.
  const Change& port = advice_.changes[1];
  EXPECT_NEAR(port.effort, 1.5 + 40.0 * (4.0 - 1.25) / kEffortExposure, 1e-6);
  EXPECT_NEAR(static_cast<double>(port.turn.time_exceeded), 50.0, 1e-3);  // 25 degrees before the good cell
}

TEST_F(Ranking, NeverEntersASevereZoneThatTheShipIsNotIn) {
  fill(Verdict::kExceeded, 0.7F);
  set(6, 40, Verdict::kExceeded, 2.0F, kHazardSurfRiding | kHazardSurfRidingWaves);
  set(8, 60, Verdict::kExceeded, 0.9F);
  advise(8.0, 40.0, false, Verdict::kExceeded, 0.7F);
  ASSERT_FALSE(advice_.changes.empty());
  expect_change(0, 0.0, 20.0);
  for (const Change& change : advice_.changes) {
    EXPECT_EQ(change.hazards & kSevereZoneBits, 0);
  }
}

TEST_F(Ranking, TheRecommendationStandsUntilItIsMuchWorse) {
  fill(Verdict::kExceeded, 0.8F);
  set(8, 70, Verdict::kGood);  // effort 1.5
  advise(8.0, 40.0);
  const Standing standing = standing_of(advice_.changes[0]);
  set(8, 20, Verdict::kGood);  // effort 1: better, not much
  rank_changes(*grid_, {{radians(40.0)}, 8.0 * kKnot, false}, present_cell_, advice_, standing);
  ASSERT_EQ(advice_.changes.size(), 2u);
  expect_change(0, 0.0, 30.0);
  expect_change(1, 0.0, -20.0);
  EXPECT_EQ(advice_.changes[0].kind, ChangeKind::kSmallest);
  set(8, 50, Verdict::kGood);  // effort 0.5: 1.5 is more than one and a half of it and a half
  rank_changes(*grid_, {{radians(40.0)}, 8.0 * kKnot, false}, present_cell_, advice_, standing);
  expect_change(0, 0.0, 10.0);
  set(8, 50, Verdict::kExceeded);
  set(8, 70, Verdict::kExceeded);  // it does not do any more
  rank_changes(*grid_, {{radians(40.0)}, 8.0 * kKnot, false}, present_cell_, advice_, standing);
  expect_change(0, 0.0, -20.0);
}

}  // namespace
}  // namespace quickstrip
