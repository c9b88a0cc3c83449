#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "core/strip/equations_of_motion.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

// Port waves are starboard waves in a mirror: sway, roll and yaw change sign, bit for bit; nothing else
// changes.
TEST(Mirror, PortAndStarboardWavesGiveMirroredMotionsExactly) {
  const Hull hull = test::wigley_hull(1, 21);
  const auto ship = std::make_unique<LoadedHull>();
  ASSERT_TRUE(load(hull, hull.loading, {}, *ship).ok());
  constexpr std::array<double, 6> kSign = {1.0, -1.0, 1.0, -1.0, 1.0, -1.0};
  for (int mu_deg = 5; mu_deg < 180; mu_deg += 10) {
    for (const double omega : {1.5, 3.0, 5.0, 8.0}) {
      for (const double speed : {0.0, 1.1}) {
        const MotionTransfer starboard =
            motion_transfer(*ship, omega, EncounterAngle{radians(mu_deg)}, speed);
        const MotionTransfer port = motion_transfer(*ship, omega, EncounterAngle{-radians(mu_deg)}, speed);
        for (std::size_t i = 0; i < 6; ++i) {
          EXPECT_EQ(port.motion[i], kSign[i] * starboard.motion[i])
              << mu_deg << " " << omega << " motion " << i + 1;
        }
      }
    }
  }
}

}  // namespace
}  // namespace quickstrip
