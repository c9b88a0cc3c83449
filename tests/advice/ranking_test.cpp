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
    fill(Verdict::kExceeded, 0.8F);
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

}  // namespace
}  // namespace quickstrip
