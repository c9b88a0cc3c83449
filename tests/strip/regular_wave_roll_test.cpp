// Roll in regular waves with the damping that it calls for itself.
#include "core/strip/regular_wave_roll.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "core/base/angles.hpp"
#include "core/base/constants.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

std::unique_ptr<LoadedHull> s175_with(RollDampingMethod damping) {
  Hull hull = test::s175();
  hull.roll_damping.method = damping;
  auto out = std::make_unique<LoadedHull>();
  const Status status = load(hull, hull.loading, StripMethod{}, *out);
  EXPECT_TRUE(status.ok()) << message(status.error());
  return out;
}

constexpr EncounterAngle kBeam{0.5 * kPi};

TEST(RegularWaveRoll, ResidualVanishesInWavesOfAllKindsAndHeights) {
  const auto ship = s175_with(RollDampingMethod::kIkeda);
  double worst = 0.0;
  for (const double speed : {0.0, 5.0, 10.0}) {
    for (const double mu : {10.0, 45.0, 90.0, 120.0, 170.0}) {
      for (const double omega : {0.25, 0.35, 0.45, 0.6, 1.0, 1.5}) {
        for (const double height : {0.01, 0.5, 2.0, 8.0}) {
          const RegularWaveRoll roll =
              regular_wave_roll(*ship, omega, EncounterAngle{radians(mu)}, speed, height);
          ASSERT_TRUE(is_finite(roll.transfer));
          worst = std::max(worst, roll.residual);
        }
      }
    }
  }
  std::printf("largest residual of 360 waves: %.2g\n", worst);
  EXPECT_LT(worst, 1e-9);  // 48 bisections, and the rank-one update against the solved equations
}

TEST(RegularWaveRoll, DampingIsThatOfTheRollFoundAndTheMotionsAreSolvedWithIt) {
  const auto ship = s175_with(RollDampingMethod::kIkeda);
  const double omega = ship->roll_natural_frequency;
  const RegularWaveRoll roll = regular_wave_roll(*ship, omega, kBeam, 0.0, 1.0);
  EXPECT_NEAR(roll.damping, added_roll_damping(ship->roll_damping, 0.0, roll.amplitude, omega),
              1e-9 * roll.damping);
  // The same ship with that damping as a constant.
  ship->roll_damping = constant_roll_damping(roll.damping, omega);
  const MotionTransfer constant = motion_transfer(*ship, omega, kBeam, 0.0);
  EXPECT_NEAR(std::abs(constant.motion[3]), std::abs(roll.transfer.motion[3]), 1e-9);
  EXPECT_NEAR(std::abs(constant.motion[1]), std::abs(roll.transfer.motion[1]), 1e-9);
  EXPECT_NEAR(std::abs(constant.motion[3]) * 1.0, roll.amplitude, 1e-9);
}

TEST(RegularWaveRoll, HigherWavesRollHerMoreButLessThanInProportion) {
  const auto ship = s175_with(RollDampingMethod::kIkeda);
  const double omega = ship->roll_natural_frequency;
  double amplitude = 0.0;
  double per_metre = 1e9;
  for (const double height : {0.05, 0.2, 0.5, 1.0, 2.0, 4.0}) {
    const RegularWaveRoll roll = regular_wave_roll(*ship, omega, kBeam, 0.0, height);
    EXPECT_GT(roll.amplitude, amplitude);
    EXPECT_LT(std::abs(roll.transfer.motion[3]), per_metre);
    amplitude = roll.amplitude;
    per_metre = std::abs(roll.transfer.motion[3]);
  }
}

TEST(RegularWaveRoll, ATinyWaveRollsHerAsTheLinearTransferFunctionSays) {
  const auto ship = s175_with(RollDampingMethod::kIkeda);
  const double omega = ship->roll_natural_frequency;
  const RegularWaveRoll roll = regular_wave_roll(*ship, omega, kBeam, 5.0, 1e-5);
  ship->roll_damping = constant_roll_damping(small_roll_damping(ship->roll_damping, 5.0), omega);
  const MotionTransfer linear = motion_transfer(*ship, omega, kBeam, 5.0);
  // Nonlinear damping goes with the amplitude, here 1e-6 rad.
  EXPECT_NEAR(std::abs(roll.transfer.motion[3] / linear.motion[3]), 1.0, 1e-4);
}

TEST(RegularWaveRoll, QuadraticDampingAloneRollsWithTheRootOfTheWaveAtResonance) {
  // Without any linear damping to speak of, b = E omega a and |F| = omega b a: a ~ sqrt(wave).
  const auto ship = s175_with(RollDampingMethod::kIkeda);
  ship->roll_damping.keel_normal_0 = 0.0;
  ship->roll_damping.keel_pressure = {};
  ship->roll_damping.friction *= 1e-6;
  ship->roll_damping.eddy *= 1000.0;  // so much that wave damping is small beside it
  const double omega = ship->roll_natural_frequency;
  const double a1 = regular_wave_roll(*ship, omega, kBeam, 0.0, 1.0).amplitude;
  const double a4 = regular_wave_roll(*ship, omega, kBeam, 0.0, 4.0).amplitude;
  EXPECT_NEAR(a4 / a1, 2.0, 0.02);  // the wave damping that is left, 1 %
}

TEST(RegularWaveRoll, ARatioOfCriticalKnowsNoAmplitude) {
  const auto ship = s175_with(RollDampingMethod::kRatio);
  const MotionTransfer linear = motion_transfer(*ship, 0.4, kBeam, 5.0);
  const RegularWaveRoll roll = regular_wave_roll(*ship, 0.4, kBeam, 5.0, 3.0);
  EXPECT_EQ(roll.transfer.motion, linear.motion);
  EXPECT_EQ(roll.residual, 0.0);
  EXPECT_DOUBLE_EQ(roll.amplitude, 3.0 * std::abs(linear.motion[3]));
}

TEST(RegularWaveRoll, HeadWavesThatDoNotRollHerLeaveTheDampingOfRest) {
  const auto ship = s175_with(RollDampingMethod::kIkeda);
  const RegularWaveRoll roll = regular_wave_roll(*ship, 0.5, EncounterAngle{kPi}, 5.0, 2.0);
  EXPECT_LT(roll.amplitude, 1e-12);
  EXPECT_LT(roll.residual, kRegularRollResidualLimit);
  EXPECT_TRUE(is_finite(roll.transfer));
}

TEST(RegularWaveRoll, BeyondTheAmplitudesOfTheMethodItSaysSo) {
  const auto ship = s175_with(RollDampingMethod::kIkeda);
  const double omega = ship->roll_natural_frequency;
  EXPECT_EQ(regular_wave_roll(*ship, omega, kBeam, 0.0, 0.2).outside_range, 0);
  const RegularWaveRoll great = regular_wave_roll(*ship, omega, kBeam, 0.0, 8.0);
  EXPECT_GT(great.amplitude, kGreatestRegularRoll);
  EXPECT_EQ(great.outside_range, kOutsideAmplitude);
}

}  // namespace
}  // namespace quickstrip
