#include "core/strip/surge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "core/strip/equations_of_motion.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

// [Lamb1932] art. 114, table of inertia coefficients k1 of prolate spheroids; three decimals printed, good
// to 1.3 units of the last (a/b = 2: exactly 0.2100, printed 0.209).
TEST(SurgeAddedMass, AgreesWithLambsTableOfProlateSpheroids) {
  EXPECT_NEAR(spheroid_surge_added_mass_factor(1.0, 0.999999), 0.5, 1e-5);
  EXPECT_NEAR(spheroid_surge_added_mass_factor(1.50, 1.0), 0.305, 1.5e-3);
  EXPECT_NEAR(spheroid_surge_added_mass_factor(2.00, 1.0), 0.209, 1.5e-3);
  EXPECT_NEAR(spheroid_surge_added_mass_factor(3.99, 1.0), 0.082, 1.5e-3);
  EXPECT_NEAR(spheroid_surge_added_mass_factor(6.01, 1.0), 0.045, 1.5e-3);
  EXPECT_NEAR(spheroid_surge_added_mass_factor(9.97, 1.0), 0.021, 1.5e-3);
}

TEST(SurgeAddedMass, TheSeriesNearTheSphereJoinsTheClosedForm) {
  const double below = spheroid_surge_added_mass_factor(1.0, 0.999951);
  const double above = spheroid_surge_added_mass_factor(1.0, 0.999949);
  EXPECT_NEAR(below, above, 2e-6);  // the function itself changes by 6e-7 in between
}

constexpr double kKnot = 1852.0 / 3600.0;

std::unique_ptr<LoadedHull> s175_loaded() {
  const auto hull = std::make_unique<Hull>(test::s175());
  auto out = std::make_unique<LoadedHull>();
  EXPECT_TRUE(load(*hull, hull->loading, {}, *out).ok());
  return out;
}

// Formula sheet §4.4: 524 kN at 16.1 kn, the size that makes this reading of the damaged text plausible.
TEST(SurgeDamping, TheS175NeedsSome520KilonewtonsAt16Knots) {
  const auto hull = s175_loaded();
  const double r = still_water_resistance(hull->lpp, hull->hydrostatics.volume, hull->density, 16.1 * kKnot);
  EXPECT_NEAR(r, 524e3, 3e3);
}

TEST(SurgeDamping, IsTheSlopeOfTheResistanceCurve) {
  const double v = 8.0;
  const double h = 1e-3;
  const auto r = [](double speed) { return still_water_resistance(175.0, 24000.0, 1025.0, speed); };
  // A parabola: the central difference is exact but for rounding, 1e-16 R / h.
  EXPECT_NEAR(v * surge_damping_per_speed(175.0, 24000.0, 1025.0), (r(v + h) - r(v - h)) / (2.0 * h), 1e-4);
}

// What the method is told to leave out stays out: figures of others have no surge terms at all.
TEST(SurgeDamping, IsNotPartOfInertiaOnly) {
  const auto hull = std::make_unique<Hull>(test::s175());
  const auto loaded = std::make_unique<LoadedHull>();
  StripMethod method;
  method.surge = SurgeTerms::kInertiaOnly;
  ASSERT_TRUE(load(*hull, hull->loading, method, *loaded).ok());
  EXPECT_EQ(loaded->surge_damping_per_speed, 0.0);
}

// Sway, roll and yaw are another set: the same bits. Heave and pitch feel surge through a15 = -int a11' bG
// alone, a11 being 3 % of the mass: what damping does to surge reaches them a hundred times smaller.
TEST(SurgeDamping, IsConfinedToSurge) {
  const auto damped = s175_loaded();
  const auto undamped = s175_loaded();
  undamped->surge_damping_per_speed = 0.0;
  const EncounterAngle mu{radians(30.0)};
  const double omega = 0.45;  // lambda 1.7 L
  const double speed = 20.0 * kKnot;
  const MotionTransfer with = motion_transfer(*damped, omega, mu, speed);
  const MotionTransfer without = motion_transfer(*undamped, omega, mu, speed);
  const auto change = [&](std::size_t i) {
    return std::abs(with.motion[i] - without.motion[i]) / std::abs(without.motion[i]);
  };
  std::printf("surge damping, S-175, 20 kn, mu 30: surge %.1e, heave %.1e, pitch %.1e\n", change(0),
              change(2), change(4));
  EXPECT_GT(change(0), 1e-2);
  EXPECT_LT(change(2), 1e-2 * change(0));
  EXPECT_LT(change(4), 1e-2 * change(0));
  for (const std::size_t lateral : {1u, 3u, 5u}) {
    EXPECT_EQ(with.motion[lateral], without.motion[lateral]);
  }
}

}  // namespace
}  // namespace quickstrip
