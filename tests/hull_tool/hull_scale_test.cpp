// The same ship in another size.
#include "sim/hull_tool/hull_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/strip/equations_of_motion.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::hull_tool {
namespace {

std::unique_ptr<LoadedHull> loaded(const Hull& hull) {
  auto out = std::make_unique<LoadedHull>();
  StripMethod method;
  method.surge = SurgeTerms::kInertiaOnly;  // viscous surge damping has the length in metres in it
  EXPECT_TRUE(load(hull, hull.loading, method, *out).ok());
  return out;
}

TEST(FroudeScale, MotionsPerWaveSlopeAreTheSameAtTheSameFroudeNumber) {
  const auto ship = loaded(test::s175());
  for (const double scale : {0.5, 1.5, 2.5}) {
    Hull hull = test::s175();
    scale_by_froude(hull, scale);
    EXPECT_DOUBLE_EQ(hull.grid.speed_to, std::sqrt(scale) * 24.0 * 1852.0 / 3600.0);
    const auto other = loaded(hull);
    EXPECT_NEAR(other->hydrostatics.volume, ship->hydrostatics.volume * std::pow(scale, 3),
                1e-12 * other->hydrostatics.volume);
    for (const double mu : {0.0, 0.6, 1.5, 2.4, kPi}) {
      for (const double omega : {0.25, 0.4, 0.7, 1.2}) {
        const auto a = motion_transfer(*ship, omega, {mu}, 8.0);
        const auto b = motion_transfer(*other, omega / std::sqrt(scale), {mu}, 8.0 * std::sqrt(scale));
        for (std::size_t i = 0; i < 6; ++i) {
          const double lengths = i < 3 ? 1.0 : scale;
          // Rounding of sums over sections and of the section table's look-up.
          EXPECT_LT(std::abs(b.motion[i] * lengths - a.motion[i]), 1e-9 * (std::abs(a.motion[i]) + 1e-3))
              << scale << " " << mu << " " << omega << " " << i;
        }
      }
    }
  }
}

TEST(FroudeScale, TimesAndSpeedsGoWithTheRootAndWaterStays) {
  Hull hull = test::s175();
  hull.loading.measured_roll_period = 18.0;
  hull.loading.gm = 1.0;
  hull.loading.free_surface_correction = 0.1;
  hull.slamming[0].threshold_velocity = 4.0;
  scale_by_froude(hull, 0.25);
  EXPECT_DOUBLE_EQ(*hull.loading.measured_roll_period, 9.0);
  EXPECT_DOUBLE_EQ(*hull.loading.gm, 0.25);
  EXPECT_DOUBLE_EQ(*hull.loading.free_surface_correction, 0.025);
  EXPECT_DOUBLE_EQ(*hull.slamming[0].threshold_velocity, 2.0);
  EXPECT_DOUBLE_EQ(hull.slamming[0].x, 157.5 / 4.0);
  EXPECT_DOUBLE_EQ(hull.freeboard[0].height, 4.0);
  EXPECT_DOUBLE_EQ(hull.propeller->tip_z, 6.5 / 4.0);
  EXPECT_DOUBLE_EQ(hull.roll_damping.bilge_keel->breadth, 0.35 / 4.0);
  EXPECT_DOUBLE_EQ(hull.points[0].z, 35.0 / 4.0);
  EXPECT_EQ(hull.loading.water_density, kSeaWaterDensity);
  EXPECT_EQ(hull.loading.viscosity, kSeaWaterKinematicViscosity);
}

}  // namespace
}  // namespace quickstrip::hull_tool
