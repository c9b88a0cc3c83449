#include "core/advice/ranking.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <random>

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;

class Ranking : public testing::Test {
 protected:
  /// Speeds 0 ... 12 kn by 2, headings by 10 degrees; every cell as given.
  void fill(Verdict verdict, float margin) {
    grid_->num_speeds = 7;
    grid_->num_headings = 36;
    for (std::size_t v = 0; v < 7; ++v) {
      grid_->speeds[v] = 2.0 * kKnot * static_cast<double>(v);
      for (std::size_t h = 0; h < 36; ++h) {
        grid_->cells[v][h] = Cell{.verdict = verdict, .margin = margin};
      }
    }
  }
  void set(std::size_t knots, std::size_t degrees_true, Verdict verdict, float margin = 1.1F,
           std::uint16_t hazards = 0) {
    Cell& cell = grid_->cells[knots / 2][degrees_true / 10];
    cell.verdict = verdict;
    cell.margin = margin;
    cell.hazards = hazards;
  }
  const Advice& advise(double knots, double degrees_true, bool following = false,
                       Verdict present = Verdict::kExceeded, float margin = 0.8F) {
    present_cell_.verdict = present;
    present_cell_.margin = margin;
    rank_changes(*grid_, {{radians(degrees_true)}, knots * kKnot, following}, present_cell_, advice_);
    return advice_;
  }
  void expect_change(std::size_t i, double knots, double turn_degrees) {
    ASSERT_LT(i, advice_.changes.size());
    EXPECT_NEAR(advice_.changes[i].speed_change / kKnot, knots, 1e-9);
    EXPECT_NEAR(degrees(advice_.changes[i].heading_change), turn_degrees, 1e-9);
  }

  std::unique_ptr<Grid> grid_ = std::make_unique<Grid>();
  Cell present_cell_;
  Advice advice_;
};

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

/// All candidates by definition, compared by definition. Independent of the code under test but for
/// change_effort, which the tests above pin.
struct Brute {
  const Grid& grid;
  Heading heading;
  double speed;
  bool following;
  std::optional<double> smallest;
  void consider(double to_heading, double to_speed, bool good) {
    const double turn = std::remainder(to_heading - heading.radians, kTwoPi);
    if (!good || (std::abs(turn) < 1e-6 && std::abs(to_speed - speed) < 1e-6)) {
      return;
    }
    const double effort = change_effort(turn, to_speed - speed, following);
    smallest = smallest ? std::min(*smallest, effort) : effort;
  }
  static bool good(const Cell& cell) { return cell.verdict == Verdict::kGood && cell.hazards == 0; }
};

TEST_F(Ranking, RecommendsTheBruteForceMinimumOnRandomGrids) {
  std::mt19937 random(20240607);
  std::size_t found = 0;
  for (int round = 0; round < 1000; ++round) {
    fill(Verdict::kExceeded, 1.0F);  // nowhere worse than at the limit: no turn adds to any effort
    const double density = std::uniform_real_distribution<double>(0.0, 0.2)(random);
    for (std::size_t v = 0; v < 7; ++v) {
      for (std::size_t h = 0; h < 36; ++h) {
        Cell& cell = grid_->cells[v][h];
        cell.verdict = std::bernoulli_distribution(density)(random)
                           ? Verdict::kGood
                           : static_cast<Verdict>(std::uniform_int_distribution<int>(0, 3)(random) % 4);
        cell.hazards = std::bernoulli_distribution(0.1)(random) ? kHazardNoSteerage : 0;
        if (cell.verdict == Verdict::kGood && !std::bernoulli_distribution(density)(random)) {
          cell.verdict = Verdict::kExceeded;
        }
      }
    }
    // Half of the ships on the grid, half of them between.
    const bool on_grid = round % 2 == 0;
    const auto column = std::uniform_int_distribution<std::size_t>(0, 35)(random);
    const auto row = std::uniform_int_distribution<std::size_t>(0, 5)(random);
    const double between = on_grid ? 0.0 : std::uniform_real_distribution<double>(0.05, 0.95)(random);
    const double heading = radians(10.0 * (static_cast<double>(column) + between));
    const double speed = 2.0 * kKnot * (static_cast<double>(row) + between);
    const bool following = std::bernoulli_distribution(0.5)(random);
    Brute brute{*grid_, {heading}, speed, following, std::nullopt};
    const std::size_t next_column = on_grid ? column : (column + 1) % 36;
    const std::size_t next_row = on_grid ? row : row + 1;
    for (std::size_t v = 0; v < 7; ++v) {
      brute.consider(heading, grid_->speeds[v],
                     Brute::good(grid_->cells[v][column]) && Brute::good(grid_->cells[v][next_column]));
      for (std::size_t h = 0; h < 36; ++h) {
        const double to = radians(10.0 * static_cast<double>(h));
        brute.consider(to, speed,
                       Brute::good(grid_->cells[row][h]) && Brute::good(grid_->cells[next_row][h]));
        brute.consider(to, grid_->speeds[v], Brute::good(grid_->cells[v][h]));
      }
    }
    advise(speed / kKnot, degrees(heading), following, Verdict::kExceeded, 5.0F);
    if (!brute.smallest) {
      EXPECT_TRUE(advice_.none_is_good) << "round " << round;
      continue;
    }
    ++found;
    ASSERT_FALSE(advice_.changes.empty()) << "round " << round;
    EXPECT_EQ(advice_.changes[0].verdict, Verdict::kGood);
    EXPECT_NEAR(advice_.changes[0].effort, *brute.smallest, 1e-9) << "round " << round;
    for (std::size_t i = 1; i < advice_.changes.size(); ++i) {
      EXPECT_LE(advice_.changes[i - 1].effort, advice_.changes[i].effort + 1e-9);
    }
  }
  EXPECT_GT(found, 500u);
  EXPECT_LT(found, 1000u);
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

/// A cell of a random grid: all verdicts, margins, zones.
Cell random_cell(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Cell cell{.governing = 0, .margin = static_cast<float>(0.3 + 2.0 * unit(random)), .rms_roll = 0.05F};
  cell.verdict =
      cell.margin < 1.0F ? Verdict::kExceeded : (cell.margin < 1.33F ? Verdict::kCaution : Verdict::kGood);
  if (unit(random) < 0.2) {
    cell.verdict = Verdict::kUnknown;
  } else if (unit(random) < 0.2) {
    constexpr std::uint16_t kZones[] = {kHazardSuccessiveWaves,
                                        kHazardParametricRoll | kHazardParametricRollGrows};
    cell.hazards = kZones[random() % 2];
    cell.verdict = (cell.hazards & kSevereZoneBits) != 0 ? Verdict::kExceeded
                                                         : std::max(cell.verdict, Verdict::kCaution);
  }
  return cell;
}

TEST_F(Ranking, KeepsItsPromisesOnRandomGrids) {
  std::mt19937 random(20250215);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::size_t larger = 0;
  for (int round = 0; round < 400; ++round) {
    fill(Verdict::kExceeded, 0.8F);
    const double good_share = unit(random);
    for (std::size_t v = 0; v < 7; ++v) {
      for (std::size_t h = 0; h < 36; ++h) {
        Cell cell = random_cell(random);
        if (cell.verdict == Verdict::kGood && unit(random) > good_share) {
          cell.verdict = Verdict::kExceeded;
          cell.margin = 0.4F;
        }
        grid_->cells[v][h] = cell;
        if (v == 0) {
          grid_->cells[v][h].hazards |= kHazardNoSteerage;
        }
      }
    }
    const auto row = 1 + random() % 6;
    const auto column = random() % 36;
    for (std::size_t off = 3; off < 9; ++off) {  // a wall on one side
      for (std::size_t v = 0; v < 7; ++v) {
        grid_->cells[v][(column + off) % 36] =
            Cell{.verdict = Verdict::kExceeded, .governing = 0, .margin = 0.1F};
      }
    }
    Present present{{radians(10.0 * static_cast<double>(column))}, grid_->speeds[row], unit(random) < 0.5};
    present.has_sea_ahead = true;
    present.sea_from = {kTwoPi * unit(random)};
    present_cell_ = grid_->cells[row][column];
    rank_changes(*grid_, present, present_cell_, advice_);
    for (std::size_t i = 0; i < advice_.changes.size(); ++i) {
      const Change& change = advice_.changes[i];
      EXPECT_NE(change.verdict, Verdict::kUnknown);
      EXPECT_GT(change.speed, 0.0);
      EXPECT_EQ(change.hazards & kSevereZoneBits & ~static_cast<unsigned>(present_cell_.hazards), 0u);
      EXPECT_TRUE(change.verdict < present_cell_.verdict || change.verdict == Verdict::kGood ||
                  change.margin > present_cell_.margin || present_cell_.hazards != 0)
          << "round " << round;
      EXPECT_NEAR(std::remainder(change.heading - present.heading.radians - change.heading_change, kTwoPi),
                  0.0, 1e-9);
      EXPECT_LT(std::abs(change.heading_change), kTwoPi);
      EXPECT_TRUE(change.turn.is_known);
      const Way way{change.heading_change, change.speed_change};
      const Way other{change.heading_change - std::copysign(kTwoPi, change.heading_change),
                      change.speed_change};
      const auto effort = [&](const Way& taken) {
        return change_effort(taken.heading_change, taken.speed_change, present.following_seas) +
               turn_exposure(*grid_, {present.heading, present.speed, present.handling, 0.0}, taken,
                             badness(present_cell_)) /
                   kEffortExposure;
      };
      EXPECT_NEAR(change.effort, effort(way), 1e-9);
      if (std::abs(change.heading_change) > kPi + 1e-9) {
        EXPECT_LT(effort(way), kLongWayGain * effort(other) + 1e-9);
      }
      if (change.kind == ChangeKind::kLarger) {
        ++larger;
        EXPECT_GE(change.margin, 1.2499F * advice_.changes[0].margin);
        EXPECT_LE(change.effort, kMuchMoreEffort * advice_.changes[0].effort + 1e-9);
      }
      EXPECT_EQ(change.kind == ChangeKind::kSmallest, i == 0 && change.kind != ChangeKind::kHeaveTo);
      if (change.kind != ChangeKind::kHeaveTo) {
        EXPECT_GE(change.effort, advice_.changes[0].effort - 1e-9);
      }
    }
  }
  EXPECT_GT(larger, 20u);
}

TEST_F(Ranking, TheMirroredSeaGivesTheMirroredAdvice) {
  std::mt19937 random(99);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto mirrored = std::make_unique<Grid>();
  Advice other;
  for (int round = 0; round < 200; ++round) {
    fill(Verdict::kExceeded, 0.8F);
    *mirrored = *grid_;
    for (std::size_t v = 0; v < 7; ++v) {
      for (std::size_t h = 0; h < 36; ++h) {
        grid_->cells[v][h] = random_cell(random);
        mirrored->cells[v][(36 - h) % 36] = grid_->cells[v][h];
      }
    }
    // Off the grid in heading: no two turns of the same size, so that no tie is decided by COLREG's side.
    const double heading = radians(10.0 * std::floor(36.0 * unit(random)) + 3.7);
    const double speed = 12.0 * kKnot * unit(random);
    present_cell_ = Cell{.verdict = Verdict::kExceeded, .governing = 0, .margin = 0.5F};
    Present present{{heading}, speed, false};
    rank_changes(*grid_, present, present_cell_, advice_);
    present.heading = {wrap_two_pi(-heading)};
    rank_changes(*mirrored, present, present_cell_, other);
    ASSERT_EQ(advice_.changes.size(), other.changes.size());
    for (std::size_t i = 0; i < other.changes.size(); ++i) {
      EXPECT_NEAR(advice_.changes[i].heading_change, -other.changes[i].heading_change, 1e-9) << round;
      EXPECT_NEAR(advice_.changes[i].speed, other.changes[i].speed, 1e-9);
      EXPECT_EQ(advice_.changes[i].kind, other.changes[i].kind);
      EXPECT_NEAR(advice_.changes[i].turn.max_roll, other.changes[i].turn.max_roll, 1e-6F);
    }
  }
}

}  // namespace
}  // namespace quickstrip
