// The ranking against its definition by brute force, and what holds on any grid.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <random>

#include "core/advice/ranking.hpp"
#include "tests/ranking/ranking_fixture.hpp"

namespace quickstrip {
namespace {

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
