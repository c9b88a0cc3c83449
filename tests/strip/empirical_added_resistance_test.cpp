// The semi-empirical added resistance: figures of another evaluation of the same formulas (a check of
// reading, not of physics), closed forms, limits and the range.
#include "core/strip/empirical_added_resistance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/sea/dispersion.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

/// Of the size of the S-175, trimmed by 1 % of her length.
EmpiricalShip ship() {
  return {.lpp = 175.0,
          .breadth = 25.4,
          .draught = 9.5,
          .trim = 1.75,
          .cb = 0.57,
          .pitch_gyradius = 0.24,
          .entrance = std::atan(0.495 * 25.4 / 80.0),
          .run = std::atan(0.495 * 25.4 / 60.0),
          .density = 1025.0,
          .gravity = kStandardGravity};
}

struct Point {
  double speed;
  double mu_deg;
  double omega;
  double motion;
  double reflection;
};

// Our own evaluation of the published formulas in another language, written from them and not from the code.
constexpr Point kPoints[] = {
    {0, 180, 0.6, 12336.8, 3656.2},     {0, 120, 1, 12280.9, 38297.4},     {5, 180, 0.5, 46819.7, 5473.9},
    {5, 160, 1.2, 2190.4, 45072.2},     {5, 60, 0.7, 58416.8, -2855.9},    {10, 180, 0.45, 88474.0, 5238.9},
    {10, 180, 0.56, 435730.9, 14782.3}, {10, 150, 0.7, 180790.6, 37299.0}, {10, 90, 0.9, 79168.6, 76543.3},
    {10, 30, 0.6, 151455.5, -3819.0},   {10, 0, 0.8, 19314.1, 4729.5},     {10, 0, 1.6, 98.6, 27091.0},
};

TEST(EmpiricalResistance, IsWhatAnotherEvaluationOfTheFormulasGives) {
  for (const Point& p : kPoints) {
    const EmpiricalResistance r(ship(), EncounterAngle{radians(p.mu_deg)}, p.speed);
    // Printed to 0.1 N/m2.
    EXPECT_NEAR(r.by_motion(empirical_wave(ship(), p.omega)), p.motion, 0.06 + 1e-9 * std::fabs(p.motion))
        << p.mu_deg;
    EXPECT_NEAR(r.by_reflection(empirical_wave(ship(), p.omega)), p.reflection, 0.06)
        << p.mu_deg << " " << p.omega;
  }
}

// Head waves much shorter than the draught, no speed: both faces of the entrance reflect them.
TEST(EmpiricalResistance, OfShortWavesAheadIsWhatTheEntranceReflects) {
  const EmpiricalShip s = ship();
  const double sine = std::sin(s.entrance);
  const double expected = 2.25 / 2.0 * s.density * s.gravity * s.breadth * sine * sine * 0.87 / s.cb;
  const EmpiricalResistance r(s, EncounterAngle{kPi}, 0.0);
  EXPECT_NEAR(r.by_reflection(empirical_wave(s, 3.0)), expected, 1e-5 * expected);  // e^{-2 k T} = 2e-8
  EXPECT_LT(r.by_motion(empirical_wave(s, 3.0)), 1e-2 * expected);
}

TEST(EmpiricalResistance, VanishesInLongWaves) {
  for (const double mu_deg : {0.0, 60.0, 90.0, 180.0}) {
    const EmpiricalResistance r(ship(), EncounterAngle{radians(mu_deg)}, 8.0);
    EXPECT_NEAR(r.at(empirical_wave(ship(), 0.15)), 0.0, 10.0) << mu_deg;  // of 300,000 at the peak
  }
}

TEST(EmpiricalResistance, IsTheSameFromBothSidesAndContinuousAtTheBeam) {
  for (const double speed : {0.0, 5.0, 11.0}) {
    const auto at = [&](double mu_deg) {
      return EmpiricalResistance(ship(), EncounterAngle{radians(mu_deg)}, speed)
          .at(empirical_wave(ship(), 0.7));
    };
    EXPECT_EQ(at(130.0), at(-130.0));
    EXPECT_EQ(at(40.0), at(-40.0));
    EXPECT_NEAR(at(90.0 - 1e-6), at(90.0 + 1e-6), 1e-4 * std::fabs(at(90.0)) + 0.1);
  }
}

// Speed through the group velocity in following waves: the reading of a2 that has no jump.
TEST(EmpiricalResistance, IsContinuousWhereTheShipOvertakesTheEnergyOfFollowingWaves) {
  const double omega = 0.8;
  const double group = 0.5 * kStandardGravity / omega;
  const auto at = [&](double speed) {
    return EmpiricalResistance(ship(), EncounterAngle{0.0}, speed).at(empirical_wave(ship(), omega));
  };
  EXPECT_NEAR(at(group - 1e-7), at(group + 1e-7), 1e-5 * std::fabs(at(group)));
}

TEST(EmpiricalResistance, FollowsFroudesLaw) {
  const EmpiricalShip s = ship();
  EmpiricalShip twin = s;
  twin.lpp *= 1.5;
  twin.breadth *= 1.5;
  twin.draught *= 1.5;
  twin.trim *= 1.5;
  const double root = std::sqrt(1.5);
  for (const double mu_deg : {0.0, 50.0, 100.0, 180.0}) {
    const EncounterAngle mu{radians(mu_deg)};
    const double r = EmpiricalResistance(s, mu, 7.0).at(empirical_wave(s, 0.6));
    EXPECT_NEAR(EmpiricalResistance(twin, mu, 7.0 * root).at(empirical_wave(twin, 0.6 / root)), 1.5 * r,
                1e-9 * std::fabs(r));
  }
}

TEST(EmpiricalResistance, HasNoAnswerOutsideItsRange) {
  const EmpiricalShip s = ship();
  EXPECT_TRUE(is_in_range(s, 0.0));
  EXPECT_TRUE(is_in_range(s, 0.299 * std::sqrt(s.gravity * s.lpp)));
  EXPECT_FALSE(is_in_range(s, 0.301 * std::sqrt(s.gravity * s.lpp)));
  EXPECT_FALSE(is_in_range(s, std::nan("")));
  const auto without = [&](auto&& change) {
    EmpiricalShip other = s;
    change(other);
    return is_in_range(other, 5.0);
  };
  EXPECT_FALSE(without([](EmpiricalShip& o) { o.lpp = 74.0; }));
  EXPECT_FALSE(without([](EmpiricalShip& o) { o.lpp = 351.0; }));
  EXPECT_FALSE(without([](EmpiricalShip& o) { o.breadth = 175.0 / 3.9; }));
  EXPECT_FALSE(without([](EmpiricalShip& o) { o.draught = 25.4 / 2.1; }));
  EXPECT_FALSE(without([](EmpiricalShip& o) { o.cb = 0.91; }));
  EXPECT_FALSE(without([](EmpiricalShip& o) { o.cb = std::nan(""); }));
  EXPECT_FALSE(without([](EmpiricalShip& o) { o.trim = 4.0; }));
}

TEST(EmpiricalShip, TakesTheEndsOfTheWaterlineFromTheSections) {
  const auto loaded = std::make_unique<LoadedHull>();
  const Hull s175 = test::s175();
  ASSERT_TRUE(load(s175, s175.loading, {}, *loaded).ok());
  const EmpiricalShip s = empirical_ship(*loaded);
  EXPECT_NEAR(s.draught, 9.5, 1e-9);
  EXPECT_NEAR(s.trim, 0.0, 1e-9);
  EXPECT_NEAR(s.pitch_gyradius, 0.24, 0.005);
  // 99 % of the half-breadth of 12.70 m between the offsets of 61.25 m (12.64) and 52.5 m (12.36): 59.2 m
  // from the aft perpendicular; 12.68 and 12.42 m at 96.25 and 105 m: 99.9 m.
  EXPECT_NEAR(s.run, std::atan(0.495 * 25.4 / 59.2), 2e-3);
  EXPECT_NEAR(s.entrance, std::atan(0.495 * 25.4 / (175.0 - 99.9)), 2e-3);

  Hull box = test::box_barge(100.0, 20.0, 5.0, 9.0);
  box.loading.draught_fwd = 4.5;
  box.loading.draught_aft = 5.5;
  ASSERT_TRUE(load(box, box.loading, {}, *loaded).ok());
  const EmpiricalShip b = empirical_ship(*loaded);
  EXPECT_NEAR(b.draught, 5.5, 1e-9);
  EXPECT_NEAR(b.trim, 1.0, 1e-9);
  EXPECT_NEAR(b.entrance, 0.5 * kPi, 1e-12);  // as blunt as can be
  EXPECT_NEAR(b.run, 0.5 * kPi, 1e-12);
}

}  // namespace
}  // namespace quickstrip
