// A grid made by hand, a ship on it, and her advice.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "core/advice/ranking.hpp"

namespace quickstrip {

inline constexpr double kKnot = 1852.0 / 3600.0;

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

}  // namespace quickstrip
