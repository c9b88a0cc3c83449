// Long waves: the ship goes with the water. No strip theory can be right that misses this.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>

#include "core/strip/equations_of_motion.hpp"
#include "msgs/files/hull_file.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

std::unique_ptr<LoadedHull> loaded(const Hull& hull, const StripMethod& method) {
  auto out = std::make_unique<LoadedHull>();
  const Status status = load(hull, hull.loading, method, *out);
  EXPECT_TRUE(status.ok()) << message(status.error());
  return out;
}

std::unique_ptr<Hull> s175() {
  auto hull = std::make_unique<Hull>();
  EXPECT_TRUE(read_hull_file(QUICKSTRIP_SOURCE_DIR "/sim/hulls/s175.hull.toml", *hull).ok());
  return hull;
}

void expect_long_wave_limits(const Hull& hull, const char* name, double highest_fn = 0.3) {
  for (const StripVariant variant : {StripVariant::kOrdinary, StripVariant::kModified}) {
    for (const DiffractionLoads loads : {DiffractionLoads::kHaskind, DiffractionLoads::kClassic}) {
      StripMethod method;
      method.variant = variant;
      method.loads = loads;
      const auto ship = loaded(hull, method);
      const double froude = std::sqrt(ship->gravity / ship->lpp);
      for (const double omega : {0.1 * froude, 0.2 * froude}) {
        const double k = omega * omega / ship->gravity;
        for (const double fn : {0.0, 0.5 * highest_fn, highest_fn}) {
          const double speed = fn * std::sqrt(ship->gravity * ship->lpp);
          for (int mu_deg = -165; mu_deg <= 180; mu_deg += 15) {
            const EncounterAngle mu{radians(mu_deg)};
            const MotionTransfer t = motion_transfer(*ship, omega, mu, speed);
            // 2 % at wave lengths of 157 and 630 ship lengths. Roll and pitch are oscillators: what they add
            // to the slope at these frequencies, (omega_e/omega_n)^2, is dynamics and not an error.
            const double pitch_stiffness = ship->restoring.c55 / (2.0 * ship->body.iyy);
            const double tuning = t.encounter_frequency * t.encounter_frequency;
            const double roll_dynamics =
                tuning / (ship->roll_natural_frequency * ship->roll_natural_frequency);
            const double pitch_dynamics = tuning / pitch_stiffness;
            EXPECT_NEAR(std::abs(t.motion[2] - 1.0), 0.0, 0.02)
                << name << " heave " << mu_deg << " Fn " << fn;
            // theta bow down + : -dzeta/dx = -(-i k cos mu) = i k cos mu; phi = dzeta/dy = -i k sin mu.
            const Complex pitch = Complex(0.0, k * std::cos(mu.radians));
            const Complex roll = Complex(0.0, -k * std::sin(mu.radians));
            EXPECT_NEAR(std::abs(t.motion[4] - pitch) / k, 0.0, 0.02 + pitch_dynamics)
                << name << " pitch " << mu_deg << " Fn " << fn << " omega " << omega;
            EXPECT_NEAR(std::abs(t.motion[3] - roll) / k, 0.0, 0.02 + 1.1 * roll_dynamics)
                << name << " roll " << mu_deg << " Fn " << fn << " omega " << omega;
          }
        }
      }
    }
  }
}

TEST(LongWaves, TheS175FollowsTheSurfaceAtEverySpeedAndDirection) {
  expect_long_wave_limits(*s175(), "S-175");
}

TEST(LongWaves, AWigleyHullFollowsTheSurfaceAtEverySpeedAndDirection) {
  expect_long_wave_limits(test::wigley_hull(3), "Wigley III");
}

// At Fn 0.3 a barge's V^2 a33 term, the Munk moment of a blunt body, is 2.6 % of its pitch stiffness: no
// limit's fault.
TEST(LongWaves, ABargeFollowsTheSurfaceAtEverySpeedAndDirection) {
  expect_long_wave_limits(test::box_barge(100.0, 20.0, 6.0, 10.0), "barge", 0.2);
}

// In a long beam wave the raft and all on her feel gravity normal to the surface: nothing sideways. The
// opposite sign of the gravity term would give 2 g k.
TEST(LongWaves, AnAccelerometerAtGFeelsNoSideForceInBeamWaves) {
  const auto ship = loaded(*s175(), {});
  const double omega = 0.1 * std::sqrt(ship->gravity / ship->lpp);
  const double k = omega * omega / ship->gravity;
  const MotionTransfer t = motion_transfer(*ship, omega, EncounterAngle{radians(90.0)}, 0.0);
  const Complex felt = -omega * omega * t.motion[1] + ship->gravity * t.motion[3];
  EXPECT_LT(std::abs(felt), 0.03 * ship->gravity * k);  // 3 %: half the sum of sway's and roll's own 2 %
}

// Sway and surge of a water particle: zeta_2 = -i sin mu, zeta_1 = -i cos mu (formulas §6).
TEST(LongWaves, SurgeAndSwayAreThoseOfTheWater) {
  const auto ship = loaded(*s175(), {});
  const double omega = 0.1 * std::sqrt(ship->gravity / ship->lpp);
  for (int mu_deg = -165; mu_deg <= 180; mu_deg += 15) {
    const EncounterAngle mu{radians(mu_deg)};
    const MotionTransfer t = motion_transfer(*ship, omega, mu, 0.0);
    EXPECT_NEAR(std::abs(t.motion[0] - Complex(0.0, -std::cos(mu.radians))), 0.0, 0.02) << mu_deg;
    EXPECT_NEAR(std::abs(t.motion[1] - Complex(0.0, -std::sin(mu.radians))), 0.0, 0.02) << mu_deg;
  }
}

}  // namespace
}  // namespace quickstrip
