// What the engine makes of a speed in waves, against closed forms and its definition.
#include "core/advice/speed_loss.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "core/advice/candidates.hpp"
#include "core/base/check.hpp"

namespace quickstrip {
namespace {

class SpeedLoss : public testing::Test {
 protected:
  /// R = 1,000 V^2 at the given speeds and beyond; cells 0 ... 10 m/s by 1 m/s.
  SpeedLoss() {
    grid_->num_speeds = 11;
    grid_->num_headings = 36;
    for (std::size_t v = 0; v < 11; ++v) {
      grid_->speeds[v] = static_cast<double>(v);
      for (std::size_t h = 0; h < 36; ++h) {
        grid_->cells[v][h] = Cell{.verdict = Verdict::kGood, .governing = 0, .margin = 2.0F};
      }
    }
    for (double v = 0.5; v <= 8.0; v += 0.5) {
      QS_CHECK(table_.push_back({v, 1000.0 * v * v}));
    }
  }
  void add_everywhere(float strip, float empirical) {
    for (std::size_t v = 0; v < 11; ++v) {
      for (std::size_t h = 0; h < 36; ++h) {
        grid_->cells[v][h].added_resistance = strip;
        grid_->cells[v][h].added_resistance_empirical = empirical;
      }
    }
  }
  ResistanceTable table_;
  std::unique_ptr<Grid> grid_ = std::make_unique<Grid>();
};

TEST_F(SpeedLoss, CalmWaterResistanceMeetsItsTableAndGoesOnAsTheSquare) {
  EXPECT_EQ(calm_water_resistance(table_, 4.0), 16'000.0);
  EXPECT_EQ(calm_water_resistance(table_, 4.25), 0.5 * (16'000.0 + 20'250.0));
  EXPECT_DOUBLE_EQ(calm_water_resistance(table_, 16.0), 256'000.0);
  EXPECT_DOUBLE_EQ(calm_water_resistance(table_, 0.25), 62.5);
  EXPECT_EQ(calm_water_resistance(table_, 0.0), 0.0);
}

TEST_F(SpeedLoss, IsTheRootOfTheCubicOfConstantPower) {
  // (1000 V^2 + R) V = 1000 V0^3: with R = 7,000 N and V0 = 2 (V0^3 = 8), V = 1 is the root.
  add_everywhere(7000.0F, kNoResistance);
  EXPECT_NEAR(speed_kept(table_, *grid_, 3, 2.0), 1.0, 1e-6);
  // V0 = 6, R = 19,000: V = 5 gives 125,000 + 95,000 = 220,000 against 216,000: a little less than 5.
  add_everywhere(19'000.0F, 2000.0F);
  const double kept = speed_kept(table_, *grid_, 3, 6.0);
  EXPECT_NEAR((calm_water_resistance(table_, kept) + 19'000.0) * kept, 216'000.0, 1.0);
  EXPECT_LT(kept, 5.0);
}

TEST_F(SpeedLoss, TheLargerMethodCountsAndASeaThatPushesGivesNothing) {
  Cell cell{};
  EXPECT_EQ(added_resistance(cell), 0.0);
  cell.added_resistance = -5000.0F;
  EXPECT_EQ(added_resistance(cell), 0.0);
  cell.added_resistance_empirical = 3000.0F;
  EXPECT_EQ(added_resistance(cell), 3000.0);
  cell.added_resistance = 4000.0F;
  EXPECT_EQ(added_resistance(cell), 4000.0);
  add_everywhere(-5000.0F, kNoResistance);
  EXPECT_EQ(speed_kept(table_, *grid_, 3, 6.0), 6.0);
}

TEST_F(SpeedLoss, KeepsThePowerOnRandomColumns) {
  std::mt19937 random(14);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int round = 0; round < 200; ++round) {
    double added = 0.0;
    for (std::size_t v = 0; v < 11; ++v) {  // grows with speed: one root
      added += 3000.0 * unit(random);
      grid_->cells[v][0].added_resistance = static_cast<float>(added);
    }
    fill_speed_loss(table_, *grid_);
    for (std::size_t v = 1; v < 11; ++v) {
      const auto loss = static_cast<double>(grid_->cells[v][0].speed_loss);
      const double kept = grid_->speeds[v] - loss;
      ASSERT_GE(loss, 0.0);
      ASSERT_GE(kept, 0.0);
      const auto below = static_cast<std::size_t>(std::floor(kept));
      const double part = kept - std::floor(kept);
      const double there = (1.0 - part) * added_resistance(grid_->cells[below][0]) +
                           part * added_resistance(grid_->cells[std::min<std::size_t>(below + 1, 10)][0]);
      const double power = calm_water_resistance(table_, grid_->speeds[v]) * grid_->speeds[v];
      ASSERT_NEAR((calm_water_resistance(table_, kept) + there) * kept, power, 1e-4 * power);
    }
  }
}

TEST_F(SpeedLoss, WithoutATableNothingIsSaidAndWithOneASpeedBeyondItIsNotRecommended) {
  add_everywhere(10'000.0F, kNoResistance);
  fill_speed_loss({}, *grid_);
  EXPECT_EQ(grid_->cells[5][5].speed_loss, kNotComputed);
  fill_speed_loss(table_, *grid_);
  // Full power 8^3 = 512 kW / eta: 7 m/s takes 343 + 70, 8 m/s 512 + 80.
  EXPECT_EQ(grid_->cells[7][5].quality & kQualitySpeedNotKept, 0u);
  EXPECT_NE(grid_->cells[8][5].quality & kQualitySpeedNotKept, 0u);
  EXPECT_TRUE(may_be_recommended(grid_->cells[7][5], 0));
  EXPECT_FALSE(may_be_recommended(grid_->cells[8][5], 0));
}

}  // namespace
}  // namespace quickstrip
