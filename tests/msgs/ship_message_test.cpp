#include "msgs/convert/ship_message.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "msgs/convert/digest.hpp"
#include "msgs/files/hull_file.hpp"

namespace quickstrip {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

own_ship_t under_way() {
  own_ship_t m{};
  m.utime = 1'567'600'000'000'000;
  m.valid = own_ship_t::VALID_HEADING;
  m.valid |= own_ship_t::VALID_SPEED_THROUGH_WATER;
  m.valid |= own_ship_t::VALID_SPEED_OVER_GROUND;
  m.heading_deg = 270.0;
  m.speed_through_water_kn = 18.0;
  m.speed_over_ground_kn = 20.0;
  return m;
}

Conversion convert(const own_ship_t& m) {
  OwnShipReading reading;
  return to_own_ship(m, reading);
}

TEST(OwnShipMessage, SpeedThroughWaterIsPreferred) {
  OwnShipReading reading;
  ASSERT_TRUE(to_own_ship(under_way(), reading).ok());
  EXPECT_DOUBLE_EQ(reading.ship.speed, 9.26);  // 18 x 1852 / 3600
  EXPECT_EQ(speed_kind(reading.ship), SpeedKind::kThroughWater);
  EXPECT_DOUBLE_EQ(reading.ship.heading.radians, 4.71238898038469);
  EXPECT_FALSE(reading.ship.water_depth.has_value());
}

TEST(OwnShipMessage, SpeedOverGroundIsAFlaggedFallback) {
  own_ship_t m = under_way();
  m.valid = own_ship_t::VALID_HEADING;
  m.valid |= own_ship_t::VALID_SPEED_OVER_GROUND;
  OwnShipReading reading;
  ASSERT_TRUE(to_own_ship(m, reading).ok());
  EXPECT_NEAR(reading.ship.speed, 10.288889, 1e-6);  // 20 kn, six digits typed
  EXPECT_EQ(speed_kind(reading.ship), SpeedKind::kOverGround);
}

TEST(OwnShipMessage, RateOfTurnIsDegreesAMinute) {
  own_ship_t m = under_way();
  m.valid |= own_ship_t::VALID_RATE_OF_TURN;
  m.rate_of_turn_deg_min = 180.0;
  OwnShipReading reading;
  ASSERT_TRUE(to_own_ship(m, reading).ok());
  EXPECT_DOUBLE_EQ(reading.rate_of_turn.value_or(0.0), kPi / 60.0);
}

TEST(OwnShipMessage, NotANumberIsRefusedInEveryFieldMarkedValidOrNot) {
  const std::pair<const char*, double own_ship_t::*> fields[] = {
      {"heading_deg", &own_ship_t::heading_deg},
      {"speed_through_water_kn", &own_ship_t::speed_through_water_kn},
      {"speed_over_ground_kn", &own_ship_t::speed_over_ground_kn},
      {"course_over_ground_deg", &own_ship_t::course_over_ground_deg},
      {"rate_of_turn_deg_min", &own_ship_t::rate_of_turn_deg_min},
      {"lat_deg", &own_ship_t::lat_deg},
      {"lon_deg", &own_ship_t::lon_deg},
      {"depth_m", &own_ship_t::depth_m},
      {"wind_speed_kn", &own_ship_t::wind_speed_kn},
      {"wind_from_deg", &own_ship_t::wind_from_deg}};
  for (const auto& [name, member] : fields) {
    own_ship_t m = under_way();
    m.*member = kNan;
    EXPECT_EQ(convert(m).refusal, Refusal::kNotFinite) << name;
    EXPECT_STREQ(convert(m).field, name);
  }
}

TEST(OwnShipMessage, WhatIsMissingOrOutsideItsRangeIsRefused) {
  using Change = std::function<void(own_ship_t&)>;
  const std::pair<Refusal, Change> cases[] = {
      {Refusal::kTime, [](own_ship_t& m) { m.utime = 0; }},
      {Refusal::kFieldMissing, [](own_ship_t& m) { m.valid &= ~own_ship_t::VALID_HEADING; }},
      {Refusal::kFieldMissing, [](own_ship_t& m) { m.valid = own_ship_t::VALID_HEADING; }},
      {Refusal::kDirection, [](own_ship_t& m) { m.heading_deg = 360.0; }},
      {Refusal::kDirection, [](own_ship_t& m) { m.heading_deg = -1.0; }},
      {Refusal::kOutOfRange, [](own_ship_t& m) { m.speed_through_water_kn = 61.0; }},
      {Refusal::kOutOfRange, [](own_ship_t& m) { m.speed_over_ground_kn = -1.0; }},
      {Refusal::kOutOfRange,
       [](own_ship_t& m) {
         m.valid |= own_ship_t::VALID_POSITION;
         m.lat_deg = 91.0;
       }},
      {Refusal::kUnknownKind, [](own_ship_t& m) { m.stabiliser = 4; }}};
  for (const auto& [refusal, change] : cases) {
    own_ship_t m = under_way();
    change(m);
    EXPECT_EQ(convert(m).refusal, refusal) << message(refusal);
  }
  own_ship_t m = under_way();
  m.lat_deg = 91.0;  // not marked valid: not judged
  EXPECT_TRUE(convert(m).ok());
}

class LoadingMessage : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const std::string file = std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/s175.hull.toml";
    ASSERT_TRUE(read_hull_file(file, hull_).ok());
    hull_.loading.gm = 1.0;
    hull_.loading.measured_roll_period = 18.0;
  }
  static loading_t given(std::int32_t valid) {
    loading_t m{};
    m.utime = 1'567'600'000'000'000;
    m.valid = valid;
    return m;
  }
  static Hull hull_;
};
Hull LoadingMessage::hull_;

TEST_F(LoadingMessage, ANewDraughtKeepsTheRestButGmAndRollPeriod) {
  loading_t m = given(loading_t::VALID_DRAUGHTS);
  m.draught_aft_m = 8.5;
  m.draught_fwd_m = 8.0;
  Loading loading;
  ASSERT_TRUE(to_loading(m, hull_, loading).ok());
  EXPECT_EQ(loading.draught_aft, 8.5);
  EXPECT_EQ(loading.draught_fwd, 8.0);
  EXPECT_EQ(loading.kg, 9.55);
  EXPECT_TRUE(loading.free_surface_correction.has_value());
  EXPECT_FALSE(loading.gm.has_value());
  EXPECT_FALSE(loading.measured_roll_period.has_value());
  EXPECT_EQ(loading.roll_gyradius, 8.331);
}

TEST_F(LoadingMessage, ANewKgTakesAwayTheFreeSurfaceCorrection) {
  loading_t m = given(loading_t::VALID_KG);
  m.kg_m = 9.0;
  Loading loading;
  ASSERT_TRUE(to_loading(m, hull_, loading).ok());
  EXPECT_EQ(loading.kg, 9.0);
  EXPECT_FALSE(loading.free_surface_correction.has_value());
}

TEST_F(LoadingMessage, AMeasuredRollPeriodAloneKeepsEverything) {
  loading_t m = given(loading_t::VALID_ROLL_PERIOD);
  m.measured_roll_period_s = 20.0;
  Loading loading;
  ASSERT_TRUE(to_loading(m, hull_, loading).ok());
  EXPECT_EQ(loading.measured_roll_period.value_or(0.0), 20.0);
  EXPECT_EQ(loading.gm.value_or(0.0), 1.0);
}

TEST_F(LoadingMessage, RoundTripKeepsEveryFigure) {
  Loading sent = hull_.loading;
  sent.draught_aft = 9.1;
  sent.measured_roll_period = 17.0;
  loading_t m{};
  m.utime = 1;
  to_message(sent, m);
  Loading received;
  ASSERT_TRUE(to_loading(m, hull_, received).ok());
  EXPECT_EQ(hull_digest(hull_, received), hull_digest(hull_, sent));
  EXPECT_NE(hull_digest(hull_, received), hull_digest(hull_, hull_.loading));
}

TEST_F(LoadingMessage, NotANumberIsRefusedInEveryField) {
  const std::pair<const char*, double loading_t::*> fields[] = {
      {"draught_aft_m", &loading_t::draught_aft_m},
      {"draught_fwd_m", &loading_t::draught_fwd_m},
      {"kg_m", &loading_t::kg_m},
      {"free_surface_correction_m", &loading_t::free_surface_correction_m},
      {"gm_m", &loading_t::gm_m},
      {"roll_gyradius_m", &loading_t::roll_gyradius_m},
      {"pitch_gyradius_m", &loading_t::pitch_gyradius_m},
      {"yaw_gyradius_m", &loading_t::yaw_gyradius_m},
      {"measured_roll_period_s", &loading_t::measured_roll_period_s},
      {"water_density_kg_m3", &loading_t::water_density_kg_m3},
      {"displacement_t", &loading_t::displacement_t},
      {"lcg_m", &loading_t::lcg_m}};
  for (const auto& [name, member] : fields) {
    loading_t m = given(loading_t::VALID_KG);
    m.kg_m = 9.0;
    m.*member = kNan;
    Loading loading;
    const Conversion result = to_loading(m, hull_, loading);
    EXPECT_EQ(result.refusal, Refusal::kNotFinite) << name;
    EXPECT_STREQ(result.field, name);
  }
}

TEST_F(LoadingMessage, WhatIsMissingOrOutsideItsRangeIsRefused) {
  const auto refusal = [](std::int32_t valid, double loading_t::*member, double value) {
    loading_t m = given(valid);
    m.draught_aft_m = m.draught_fwd_m = 9.0;
    if (member != nullptr) {
      m.*member = value;
    }
    Loading loading;
    return to_loading(m, hull_, loading).refusal;
  };
  using M = loading_t;
  EXPECT_EQ(refusal(0, nullptr, 0.0), Refusal::kFieldMissing);
  EXPECT_EQ(refusal(M::VALID_DRAUGHTS, nullptr, 0.0), Refusal::kNone);
  EXPECT_EQ(refusal(M::VALID_DRAUGHTS, &M::draught_aft_m, -1.0), Refusal::kOutOfRange);
  EXPECT_EQ(refusal(M::VALID_DRAUGHTS, &M::draught_fwd_m, 11.5),
            Refusal::kInconsistent);  // offsets end at 11
  EXPECT_EQ(refusal(M::VALID_GM, &M::gm_m, -0.2), Refusal::kOutOfRange);
  EXPECT_EQ(refusal(M::VALID_FREE_SURFACE, &M::free_surface_correction_m, -0.1), Refusal::kOutOfRange);
  EXPECT_EQ(refusal(M::VALID_ROLL_GYRADIUS, &M::roll_gyradius_m, 42.0), Refusal::kOutOfRange);
  EXPECT_EQ(refusal(M::VALID_WATER_DENSITY, &M::water_density_kg_m3, 1.025), Refusal::kOutOfRange);
}

}  // namespace
}  // namespace quickstrip
