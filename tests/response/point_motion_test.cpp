#include "core/response/point_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "core/base/constants.hpp"
#include "core/response/relative_motion.hpp"

namespace quickstrip {
namespace {

using namespace std::complex_literals;

constexpr double kG = kStandardGravity;
constexpr double kRounding = 1e-14;  // a handful of products of order one

MotionTransfer only(std::size_t mode, std::complex<double> amplitude, double omega_e = 0.5) {
  MotionTransfer transfer;
  transfer.motion[mode] = amplitude;
  transfer.encounter_frequency = omega_e;
  return transfer;
}

/// A raft much smaller than the wave: it goes with the water of the surface and lies along its slope.
MotionTransfer raft(double k, double mu) {
  MotionTransfer transfer;
  transfer.encounter_frequency = std::sqrt(kG * k);
  transfer.motion[0] = -1i * std::cos(mu);
  transfer.motion[1] = -1i * std::sin(mu);
  transfer.motion[2] = 1.0;
  transfer.motion[3] = -1i * k * std::sin(mu);
  transfer.motion[4] = 1i * k * std::cos(mu);
  return transfer;
}

TEST(PointMotion, PitchBowDownLowersTheBowAndMovesTheMastForward) {
  const PointMotion bow = point_displacement(only(4, 0.1), {50.0, 0.0, 0.0});
  EXPECT_NEAR(bow.z.real(), -5.0, kRounding);
  const PointMotion mast = point_displacement(only(4, 0.1), {0.0, 0.0, 30.0});
  EXPECT_NEAR(mast.x.real(), 3.0, kRounding);
}

TEST(PointMotion, RollStarboardDownRaisesPortAndMovesTheMastToStarboard) {
  const PointMotion point = point_displacement(only(3, 0.1), {0.0, 10.0, 30.0});
  EXPECT_NEAR(point.z.real(), 1.0, kRounding);
  EXPECT_NEAR(point.y.real(), -3.0, kRounding);
}

TEST(PointMotion, YawBowToPortMovesTheBowToPort) {
  const PointMotion point = point_displacement(only(5, 0.1), {50.0, 10.0, 0.0});
  EXPECT_NEAR(point.y.real(), 5.0, kRounding);
  EXPECT_NEAR(point.x.real(), -1.0, kRounding);
}

TEST(PointAcceleration, ARaftInLongBeamWavesFeelsNoSideForceAtG) {
  const double k = 0.001;
  const MotionTransfer transfer = raft(k, 0.5 * kPi);
  const PointMotion a = point_acceleration(transfer, {}, kG);
  EXPECT_NEAR(std::abs(a.y), 0.0, kRounding);
  // With the other sign of the gravity term the same raft would feel twice the slope.
  const std::complex<double> roll_gravity = kG * transfer.motion[3];
  EXPECT_NEAR(std::abs(a.y - 2.0 * roll_gravity), 2.0 * kG * k, kRounding);
}

TEST(PointAcceleration, ARaftInLongHeadWavesFeelsNoSurgeForceAtG) {
  const PointMotion a = point_acceleration(raft(0.001, kPi), {}, kG);
  EXPECT_NEAR(std::abs(a.x), 0.0, kRounding);
}

TEST(PointAcceleration, AtTheMastheadMotionAndGravityAddForRollAndForPitch) {
  const double omega_e = 0.5;
  const double height = 30.0;
  const double both = 0.1 * (omega_e * omega_e * height + kG);
  const PointMotion rolling = point_acceleration(only(3, 0.1, omega_e), {0.0, 0.0, height}, kG);
  EXPECT_NEAR(rolling.y.real(), both, 1e-13);
  const PointMotion pitching = point_acceleration(only(4, 0.1, omega_e), {0.0, 0.0, height}, kG);
  EXPECT_NEAR(pitching.x.real(), -both, 1e-13);
}

TEST(PointAcceleration, DoesNotDependOnTheSignOfTheEncounterFrequency) {
  MotionTransfer transfer = raft(0.02, 0.7);
  const PointMotion ahead = point_acceleration(transfer, {30.0, 4.0, 12.0}, kG);
  transfer.encounter_frequency = -transfer.encounter_frequency;
  const PointMotion astern = point_acceleration(transfer, {30.0, 4.0, 12.0}, kG);
  EXPECT_EQ(ahead.x, astern.x);
  EXPECT_EQ(ahead.y, astern.y);
  EXPECT_EQ(ahead.z, astern.z);
}

TEST(RelativeMotion, VanishesForARaftAtEveryPointNearG) {
  const double k = 1e-4;
  for (const double mu : {0.0, 0.6, 0.5 * kPi, 2.2, kPi, -0.6, -2.2}) {
    const Position point{20.0, 7.0, 3.0};
    const std::complex<double> s = relative_motion(raft(k, mu), point, k, {mu});
    // zeta - Z = -(k r)^2 / 2 + ...: the curvature of the wave between G and the point
    EXPECT_LT(std::abs(s), 0.51 * std::pow(k * std::hypot(20.0, 7.0), 2)) << "mu = " << mu;
  }
}

TEST(RelativeMotion, OfAShipThatDoesNotMoveIsTheWaveThatArrivesLaterDownstream) {
  const double k = 0.03;
  // Head waves travel aft: they reach the bow first, so the bow's phase leads by k x.
  const std::complex<double> bow = relative_motion({}, {50.0, 0.0, 0.0}, k, {kPi});
  EXPECT_NEAR(std::arg(bow), 1.5, kRounding);
  // Waves from starboard (mu = +90 degrees) reach port last.
  const std::complex<double> port = relative_motion({}, {0.0, 10.0, 0.0}, k, {0.5 * kPi});
  EXPECT_NEAR(std::arg(port), -0.3, kRounding);
}

TEST(Mirror, APointToPortInWavesFromStarboardFeelsWhatItsMirrorPointFeelsInWavesFromPort) {
  const double k = 0.02;
  const double mu = 1.1;
  const MotionTransfer starboard = raft(k, mu);
  const MotionTransfer port = raft(k, -mu);
  const Position point{30.0, 9.0, 4.0};
  const Position mirror{30.0, -9.0, 4.0};
  EXPECT_EQ(point_acceleration(starboard, point, kG).x, point_acceleration(port, mirror, kG).x);
  EXPECT_EQ(point_acceleration(starboard, point, kG).y, -point_acceleration(port, mirror, kG).y);
  EXPECT_EQ(point_acceleration(starboard, point, kG).z, point_acceleration(port, mirror, kG).z);
  EXPECT_EQ(relative_motion(starboard, point, k, {mu}), relative_motion(port, mirror, k, {-mu}));
}

}  // namespace
}  // namespace quickstrip
