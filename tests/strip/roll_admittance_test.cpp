#include "core/strip/roll_admittance.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "core/base/angles.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

std::unique_ptr<LoadedHull> s175_with(double ratio) {
  auto ship = std::make_unique<LoadedHull>();
  const Hull hull = test::s175();
  EXPECT_TRUE(load(hull, hull.loading, {}, *ship).ok());
  set_roll_damping_ratio(*ship, ratio);
  return ship;
}

// Damping sits in one element of the lateral matrix: another damping is a rank-one update, exact.
TEST(RollAdmittance, TurnsMotionsAtOneDampingIntoThoseAtAnother) {
  const auto ship = s175_with(0.02);
  const auto damped = s175_with(0.15);
  const double added = 2.0 * 0.13 * ship->restoring.c44 / ship->roll_natural_frequency;
  for (const double omega : {0.3, 0.36, 0.5, 0.9}) {
    for (const double mu_deg : {30.0, 60.0, 90.0, 140.0}) {
      for (const double speed : {0.0, 8.0}) {
        const EncounterAngle mu{radians(mu_deg)};
        const MotionTransfer at = motion_transfer(*ship, omega, mu, speed);
        if (at.low_encounter) {
          continue;  // there the equations see another frequency than the one reported
        }
        const MotionTransfer wanted = motion_transfer(*damped, omega, mu, speed);
        const RollAdmittance answer = roll_admittance(*ship, at.encounter_frequency, speed);
        const Complex roll = at.motion[3] * answer.impedance /
                             (answer.impedance + Complex(0.0, at.encounter_frequency * added));
        const Complex change = roll - at.motion[3];
        const double rounding = 1e-11 * std::abs(wanted.motion[3]) * ship->lpp;
        EXPECT_NEAR(std::abs(roll - wanted.motion[3]), 0.0, rounding);
        EXPECT_NEAR(std::abs(at.motion[1] + answer.sway_per_roll * change - wanted.motion[1]), 0.0, rounding);
        EXPECT_NEAR(std::abs(at.motion[5] + answer.yaw_per_roll * change - wanted.motion[5]), 0.0, rounding);
      }
    }
  }
}

TEST(RollAdmittance, IsConjugateAtNegativeFrequency) {
  const auto ship = s175_with(0.05);
  const RollAdmittance ahead = roll_admittance(*ship, 0.4, 6.0);
  const RollAdmittance astern = roll_admittance(*ship, -0.4, 6.0);
  EXPECT_EQ(astern.impedance, std::conj(ahead.impedance));
  EXPECT_EQ(astern.sway_per_roll, std::conj(ahead.sway_per_roll));
  EXPECT_EQ(astern.yaw_per_roll, std::conj(ahead.yaw_per_roll));
}

// A slow roll moment heels the ship statically: c44.
TEST(RollAdmittance, IsTheStiffnessAtVanishingFrequency) {
  const auto ship = s175_with(0.05);
  const RollAdmittance answer = roll_admittance(*ship, 1e-3 * ship->roll_natural_frequency, 0.0);
  EXPECT_NEAR(answer.impedance.real() / ship->restoring.c44, 1.0, 1e-5);
}

}  // namespace
}  // namespace quickstrip
