#include "tests/msgs/outgoing_samples.hpp"

#include <gtest/gtest.h>

#include <string>

#include "msgs/convert/units.hpp"
#include "msgs/files/hull_file.hpp"

namespace quickstrip::test {

Hull& s175() {
  static Hull hull;
  static const bool is_read =
      read_hull_file(std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/s175.hull.toml", hull).ok();
  EXPECT_TRUE(is_read);
  return hull;
}

Criteria some_criteria() {
  Criteria criteria;
  EXPECT_TRUE(criteria.push_back({Name("roll"), Quantity::kRoll, 0, Statistic::kRms, radians(6.0), 0.75}));
  EXPECT_TRUE(criteria.push_back(
      {Name("slamming at bow"), Quantity::kSlamming, 0, Statistic::kProbability, 0.022, 0.5}));
  EXPECT_TRUE(criteria.push_back({Name("vertical acceleration at bridge"), Quantity::kVerticalAcceleration, 0,
                                  Statistic::kRms, 0.15 * kStandardGravity, 0.75}));
  EXPECT_TRUE(criteria.push_back({Name("lateral acceleration"), Quantity::kLateralAcceleration, kNowhere,
                                  Statistic::kRms, 0.12 * kStandardGravity, 0.75}));
  return criteria;
}

Cell slamming_cell() {
  Cell cell;
  cell.verdict = Verdict::kExceeded;
  cell.governing = 1;
  cell.governing_system = 0;
  cell.margin = 0.8F;
  cell.values[0] = static_cast<float>(radians(3.0));
  cell.values[1] = 0.041F;
  cell.values[2] = 1.0F;
  cell.values[3] = kNotComputed;
  cell.rms_roll = cell.values[0];
  cell.slam_probability = 0.041F;
  cell.slams_per_hour = 38.2F;
  return cell;
}

Grid& small_grid() {
  static Grid grid;
  grid.num_speeds = 2;
  grid.num_headings = 72;
  grid.speeds = {from_knots(12.0), from_knots(18.0)};
  for (auto& row : grid.cells) {
    row.fill(slamming_cell());
  }
  Cell& better = grid.cells[0][50];
  better.verdict = Verdict::kGood;
  better.values[1] = 0.011F;
  better.slams_per_hour = 9.4F;
  better.slam_probability = 0.011F;
  return grid;
}

Advice slamming_advice() {
  Advice advice;
  advice.no_advice = NoAdvice::kNone;
  advice.heading = {radians(250.0)};
  advice.speed = from_knots(18.0);
  advice.present = slamming_cell();
  advice.change_needed = true;
  Change slower;
  slower.heading = radians(250.0);
  slower.speed = from_knots(12.0);
  slower.speed_change = from_knots(-6.0);
  slower.verdict = Verdict::kGood;
  slower.governing = 1;
  slower.margin = 1.3F;
  Change turn;
  turn.heading = radians(230.0);
  turn.speed = from_knots(18.0);
  turn.heading_change = radians(-20.0);
  turn.verdict = Verdict::kCaution;
  turn.margin = 1.1F;
  EXPECT_TRUE(advice.changes.push_back(slower));
  EXPECT_TRUE(advice.changes.push_back(turn));
  return advice;
}

AdviceContext some_context() {
  AdviceContext context;
  context.utime = 1'567'600'000'000'000;
  context.seq = 12;
  context.hull_name = "S-175 container ship";
  context.speed_kind = SpeedKind::kThroughWater;
  context.inputs[advice_t::INPUT_SEA_STATE] = {InputUse::kLive, 3, 77, 1'567'599'000'000'000};
  return context;
}

}  // namespace quickstrip::test
