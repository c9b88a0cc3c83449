// The way from the direction of the sea to the side of the turn, with the S-175 and real strip theory: an
// asymmetric sea in all four quadrants.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/advice/nordforsk.hpp"
#include "core/advisor.hpp"
#include "msgs/files/hull_file.hpp"

namespace quickstrip {
namespace {

constexpr double kKnot = 1852.0 / 3600.0;

class Directions : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    hull_ = std::make_unique<Hull>();
    ASSERT_TRUE(read_hull_file(QUICKSTRIP_SOURCE_DIR "/sim/hulls/s175.hull.toml", *hull_).ok());
    hull_->grid.speed_step = 4.0 * kKnot;
    advisor_ = std::make_unique<Advisor>();
    ASSERT_TRUE(advisor_->configure(*hull_, *nordforsk_merchant(*hull_), {}).ok());
  }
  static void TearDownTestSuite() {
    advisor_.reset();
    hull_.reset();
  }
  /// A ship that steers `heading_deg` in a sea `off_deg` to starboard of her bow.
  const StepOutput& step(double heading_deg, double off_deg, double hs = 6.0, double tp = 12.0) {
    sea_.systems.clear();
    EXPECT_TRUE(sea_.systems.push_back({.hs = hs,
                                        .period = tp,
                                        .from = {radians(std::fmod(heading_deg + off_deg + 720.0, 360.0))},
                                        .spreading = radians(20.0)}));
    ship_ = {.heading = {radians(heading_deg)}, .speed = 16.0 * kKnot};
    return advisor_->step({.sea_state = &sea_, .own_ship = &ship_});
  }
  static const Change* first_turn(const Advice& advice) {
    for (const Change& change : advice.changes) {
      if (std::abs(change.heading_change) > radians(2.0)) {
        return &change;
      }
    }
    return nullptr;
  }
  /// Verdict there without grid or ranking, for what a turn to a side is worth.
  static double margin_at(double heading, double speed) {
    auto response = std::make_unique<CellResponse>();
    EXPECT_TRUE(advisor_->respond_at({heading}, speed, *response).ok());
    return static_cast<double>(response->cell.margin);
  }

  static std::unique_ptr<Hull> hull_;
  static std::unique_ptr<Advisor> advisor_;
  SeaState sea_;
  OwnShip ship_{};
};

std::unique_ptr<Hull> Directions::hull_;
std::unique_ptr<Advisor> Directions::advisor_;

TEST_F(Directions, TheTurnIsToTheSameSideOfTheSeaInAllFourQuadrants) {
  for (const double off : {20.0, 50.0, 75.0, 110.0, 160.0}) {
    const Change* const north = first_turn(step(0.0, off).advice);
    ASSERT_NE(north, nullptr) << off;
    const double turn = north->heading_change;
    const double speed = north->speed;
    const double margin = margin_at(north->heading, speed);
    // The promise holds by a computation of its own, and the mirrored course does not keep it: the sea is
    // not symmetric about the ship.
    EXPECT_NEAR(margin, static_cast<double>(north->margin), 1e-4 * margin);
    const double other_side = margin_at(wrap_two_pi(-turn), speed);
    EXPECT_GT(std::abs(margin - other_side), 0.01) << off;
    for (const double heading : {90.0, 180.0, 270.0}) {
      const Change* const turned = first_turn(step(heading, off).advice);
      ASSERT_NE(turned, nullptr);
      EXPECT_NEAR(degrees(turned->heading_change), degrees(turn), 1e-6) << heading << " off " << off;
      EXPECT_NEAR(turned->speed, speed, 1e-9);
      EXPECT_NEAR(degrees(wrap_pi(turned->heading - radians(heading))), degrees(wrap_pi(turn)), 1e-6);
    }
    const Change* const mirrored = first_turn(step(0.0, -off).advice);
    ASSERT_NE(mirrored, nullptr);
    EXPECT_NEAR(degrees(mirrored->heading_change), -degrees(turn), 1e-6) << off;
    EXPECT_NEAR(mirrored->speed, speed, 1e-9);
  }
}

TEST_F(Directions, ATurnThroughTheBeamSeaSaysSo) {
  // From the sea on the quarter to a course with it on the bow, whichever side: the worst of the way lies
  // where the ship rolls most, and the largest roll on the way is more than where it ends.
  const StepOutput& output = step(0.0, 150.0, 5.0, 12.0);
  const TurnStart start{
      .heading = {0.0}, .speed = 16.0 * kKnot, .handling = hull_->handling, .roll_period = 18.0};
  const Turn there = sum_up_turn(output.grid, start, {radians(120.0), 0.0});
  double largest = 0.0;
  for (std::size_t h = 0; h <= 24; ++h) {
    largest = std::max(largest, static_cast<double>(output.grid.cells[4][h].rms_roll));
  }
  EXPECT_GT(static_cast<double>(there.max_roll), largest);
  EXPECT_LT(static_cast<double>(there.max_roll), 3.5 * largest);
  EXPECT_NEAR(static_cast<double>(there.time), 240.0, 1e-2);
}

TEST_F(Directions, HeavingToIsBowToTheSeaAtSteerageSpeed) {
  for (const double off : {40.0, -40.0, 100.0, -150.0}) {
    const Advice& advice = step(70.0, off, 14.0, 13.0).advice;
    ASSERT_EQ(advice.present.verdict, Verdict::kExceeded);
    for (const Change& change : advice.changes) {
      if (change.kind == ChangeKind::kHeaveTo) {
        EXPECT_LE(std::abs(degrees(wrap_pi(change.heading - radians(70.0 + off)))), 30.0 + 1e-6) << off;
        EXPECT_NEAR(change.speed / kKnot, 4.0, 1e-6);  // the first of the grid at 3 kn or above
      }
    }
  }
}

}  // namespace
}  // namespace quickstrip
