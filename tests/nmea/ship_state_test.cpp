#include "firmware/nmea/ship_state.hpp"

#include <gtest/gtest.h>

#include "msgs/convert/ship_message.hpp"
#include "tests/nmea/support.hpp"

namespace quickstrip::nmea {
namespace {

using test::kNow;
using test::kSecond;
constexpr Rank kFirst = 0;
constexpr Rank kSecondBest = 64;

TEST(NmeaShipState, AHeadingOfThreeSecondsAgoAndASpeedOfNowAreAMessageOfThreeSecondsAgo) {
  ShipState state(5.0);
  state.take({Quantity::kHeading, 90.0}, kFirst, kNow - 3 * kSecond);
  state.take({Quantity::kSpeedThroughWater, 12.0}, kFirst, kNow);
  const auto message = state.own_ship(kNow);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->utime, kNow - 3 * kSecond);
  EXPECT_EQ(message->valid, 3);  // heading and speed through the water
  OwnShipReading reading;
  EXPECT_TRUE(to_own_ship(*message, reading).ok());
  EXPECT_FALSE(reading.ship.speed_over_ground);
}

TEST(NmeaShipState, WithoutAFreshHeadingAndAFreshSpeedThereIsNoMessage) {
  ShipState state(5.0);
  EXPECT_FALSE(state.own_ship(kNow));
  state.take({Quantity::kHeading, 90.0}, kFirst, kNow);
  state.take({Quantity::kCourse, 95.0}, kFirst, kNow);
  EXPECT_FALSE(state.own_ship(kNow));
  state.take({Quantity::kSpeedThroughWater, 12.0}, kFirst, kNow);
  EXPECT_TRUE(state.own_ship(kNow));
  EXPECT_FALSE(state.own_ship(kNow + 5 * kSecond + 1));
}

TEST(NmeaShipState, WhenTheLogFallsSilentTheSpeedOverGroundStandsInAndTheAdvisorIsTold) {
  ShipState state(5.0);
  state.take({Quantity::kSpeedThroughWater, 12.0}, kFirst, kNow);
  for (int i = 0; i <= 8; ++i) {
    state.take({Quantity::kHeading, 90.0}, kFirst, kNow + i * kSecond);
    state.take({Quantity::kSpeedOverGround, 14.0}, kFirst, kNow + i * kSecond);
  }
  const auto message = state.own_ship(kNow + 8 * kSecond);
  ASSERT_TRUE(message);
  OwnShipReading reading;
  ASSERT_TRUE(to_own_ship(*message, reading).ok());
  EXPECT_TRUE(reading.ship.speed_over_ground);
  EXPECT_EQ(message->utime, kNow + 8 * kSecond);
}

TEST(NmeaShipState, TheSourceNamedFirstIsBelievedWhileItIsFreshAndDisagreementIsCounted) {
  ShipState state(5.0);
  EXPECT_TRUE(state.take({Quantity::kHeading, 200.0}, kSecondBest, kNow));
  EXPECT_TRUE(state.take({Quantity::kHeading, 90.0}, kFirst, kNow));
  EXPECT_FALSE(state.take({Quantity::kHeading, 200.0}, kSecondBest, kNow + kSecond));
  EXPECT_EQ(state.fresh(Quantity::kHeading, kNow + kSecond)->value, 90.0);
  EXPECT_EQ(state.num_disagreements(), 1);
  EXPECT_FALSE(state.take({Quantity::kHeading, 91.0}, kSecondBest, kNow + 2 * kSecond));
  EXPECT_EQ(state.num_disagreements(), 1);  // one degree is no disagreement
  EXPECT_TRUE(state.take({Quantity::kHeading, 91.5}, kSecondBest, kNow + 6 * kSecond));  // the first is gone
  EXPECT_EQ(state.fresh(Quantity::kHeading, kNow + 6 * kSecond)->value, 91.5);
}

TEST(NmeaShipState, HeadingsOnBothSidesOfNorthAgree) {
  ShipState state(5.0);
  state.take({Quantity::kHeading, 359.5}, kFirst, kNow);
  state.take({Quantity::kHeading, 0.5}, kSecondBest, kNow);
  EXPECT_EQ(state.num_disagreements(), 0);
}

TEST(NmeaShipState, ManySendersPushOutTheLeastBelievedOnly) {
  ShipState state(5.0);
  for (Rank rank = 0; rank < 40; ++rank) {
    state.take({Quantity::kHeading, 90.0 + rank * 0.01}, rank, kNow);
  }
  EXPECT_EQ(state.fresh(Quantity::kHeading, kNow)->value, 90.0);
}

TEST(NmeaShipState, EveryQuantityComesThroughToTheMessage) {
  ShipState state(5.0);
  const double values[] = {10.0, 11.0, 12.0, 13.0, -14.0, 15.0, 16.0, 17.0};
  for (std::size_t i = 0; i < 8; ++i) {
    state.take({static_cast<Quantity>(i), values[i]}, kFirst, kNow);
  }
  const auto m = state.own_ship(kNow);
  ASSERT_TRUE(m);
  EXPECT_EQ(m->valid, 127);
  EXPECT_EQ(m->heading_deg, 10.0);
  EXPECT_EQ(m->speed_through_water_kn, 11.0);
  EXPECT_EQ(m->speed_over_ground_kn, 12.0);
  EXPECT_EQ(m->course_over_ground_deg, 13.0);
  EXPECT_EQ(m->rate_of_turn_deg_min, -14.0);
  EXPECT_EQ(m->lat_deg, 15.0);
  EXPECT_EQ(m->lon_deg, 16.0);
  EXPECT_EQ(m->depth_m, 17.0);
}

}  // namespace
}  // namespace quickstrip::nmea
