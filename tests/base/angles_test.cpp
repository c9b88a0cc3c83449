#include "core/base/angles.hpp"

#include <gtest/gtest.h>

namespace quickstrip {
namespace {

double mu_deg(double heading_deg, double from_deg) {
  return degrees(encounter_angle(Heading{radians(heading_deg)}, WaveFrom{radians(from_deg)}).radians);
}

// All four quadrants: the flipped formula passes head and following but not these.
TEST(EncounterAngle, HeadFollowingStarboardAndPortAreWhereTheContractPutsThem) {
  EXPECT_NEAR(mu_deg(30, 30), 180, 1e-12);
  EXPECT_NEAR(mu_deg(30, 210), 0, 1e-12);
  EXPECT_NEAR(mu_deg(0, 90), 90, 1e-12);     // north-going ship, waves from the east: from starboard
  EXPECT_NEAR(mu_deg(0, 270), -90, 1e-12);   // from the west: from port
  EXPECT_NEAR(mu_deg(350, 35), 135, 1e-12);  // starboard bow, across north
}

TEST(Angles, WrapsIntoTheirHalfOpenIntervals) {
  EXPECT_NEAR(wrap_pi(kPi), kPi, 0);
  EXPECT_NEAR(wrap_pi(-kPi), kPi, 0);
  EXPECT_NEAR(wrap_pi(3 * kPi), kPi, 1e-15);
  EXPECT_EQ(wrap_two_pi(-1e-20), 0.0);
  EXPECT_NEAR(wrap_two_pi(radians(725)), radians(5), 1e-13);
}

}  // namespace
}  // namespace quickstrip
