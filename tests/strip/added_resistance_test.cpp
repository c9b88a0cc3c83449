// Added resistance in regular waves: limits, symmetries and closed forms that hold whatever the ship. Figures
// of others: added_resistance_figures_test.cpp.
#include "core/strip/added_resistance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "core/sea/dispersion.hpp"
#include "core/strip/equations_of_motion.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

constexpr EncounterAngle kHead{kPi};
constexpr double kKnot = 1852.0 / 3600.0;

std::unique_ptr<LoadedHull> loaded(const Hull& hull, StripVariant variant = StripVariant::kOrdinary) {
  StripMethod method;
  method.variant = variant;
  method.surge = SurgeTerms::kInertiaOnly;
  auto out = std::make_unique<LoadedHull>();
  const Status status = load(hull, hull.loading, method, *out);
  EXPECT_TRUE(status.ok()) << message(status.error());
  return out;
}

double resistance(const LoadedHull& hull, double omega, EncounterAngle mu, double speed) {
  return added_resistance(hull, omega, mu, speed, motion_transfer(hull, omega, mu, speed));
}

/// R / (rho g B^2 / L), the usual form.
double coefficient(const LoadedHull& hull, double r) {
  return r / (hull.density * hull.gravity * hull.breadth * hull.breadth / hull.lpp);
}

ResistanceWave wave_on(const LoadedHull& hull, double omega, EncounterAngle mu) {
  SectionWaves sections;
  section_waves(hull, omega, mu, sections);
  ResistanceWave out;
  resistance_wave(hull, omega, mu, sections, out);
  return out;
}

MotionTransfer at_rest(const LoadedHull& hull, double omega, EncounterAngle mu, double speed) {
  MotionTransfer out;
  out.encounter_frequency = encounter_frequency(omega, wave_number(omega, hull.gravity), speed, mu);
  return out;
}

TEST(AddedResistance, VanishesInLongWaves) {
  const auto hull = loaded(test::s175());
  const double omega = wave_frequency(kTwoPi / (30.0 * hull->lpp), hull->gravity);
  for (const double speed_kn : {0.0, 10.0, 20.0}) {
    for (const double mu_deg : {0.0, 60.0, 90.0, 120.0, 180.0}) {
      // Of a peak of 10: both formulas are of order (L / lambda)^3 and more.
      const double r = resistance(*hull, omega, EncounterAngle{radians(mu_deg)}, speed_kn * kKnot);
      EXPECT_LT(std::fabs(coefficient(*hull, r)), 0.02) << speed_kn << " kn, mu " << mu_deg;
    }
  }
}

TEST(AddedResistance, IsPositiveInHeadSeasWhereTheShipPitches) {
  const auto hull = loaded(test::s175());
  for (const double speed_kn : {0.0, 5.0, 10.0, 20.0}) {
    for (double lengths = 0.8; lengths < 2.0; lengths += 0.1) {
      const double omega = wave_frequency(kTwoPi / (lengths * hull->lpp), hull->gravity);
      EXPECT_GT(resistance(*hull, omega, kHead, speed_kn * kKnot), 0.0) << speed_kn << " kn " << lengths;
    }
  }
}

TEST(AddedResistance, IsTheSameFromBothSides) {
  const auto hull = loaded(test::s175());
  for (const double mu_deg : {30.0, 90.0, 135.0}) {
    const double starboard = resistance(*hull, 0.7, EncounterAngle{radians(mu_deg)}, 8.0);
    const double port = resistance(*hull, 0.7, EncounterAngle{radians(-mu_deg)}, 8.0);
    EXPECT_NEAR(port, starboard, 1e-9 * std::fabs(starboard));
  }
}

// N/m2: a force over a length squared, so one power of the length.
TEST(AddedResistance, FollowsFroudesLaw) {
  const Hull ship = test::s175();
  const auto hull = loaded(ship);
  const auto twin = loaded(test::scaled(ship, 1.7));
  const double root = std::sqrt(1.7);
  for (const double mu_deg : {20.0, 90.0, 150.0, 180.0}) {
    const EncounterAngle mu{radians(mu_deg)};
    const double r = resistance(*hull, 0.6, mu, 9.0);
    // The section table is read at the same xi, but for rounding of ln(omega) among the nodes.
    EXPECT_NEAR(resistance(*twin, 0.6 / root, mu, 9.0 * root), 1.7 * r, 1e-8 * std::fabs(r));
  }
}

// By its factor cos mu. Pressure at the waterline does not vanish there: the jump that Journee's change of
// method leaves. Printed by speed, of peaks of 5 ... 13 in head seas.
TEST(AddedResistance, ChangesMethodAtTheBeamWithAJump) {
  for (const StripVariant variant : {StripVariant::kOrdinary, StripVariant::kModified}) {
    const auto hull = loaded(test::s175(), variant);
    for (const double speed_kn : {0.0, 10.0, 20.0}) {
      const double speed = speed_kn * kKnot;
      double jump = 0.0;
      double at = 0.0;
      for (double omega = 0.3; omega < 1.6; omega += 0.02) {
        const double ahead = resistance(*hull, omega, EncounterAngle{radians(90.0 + 1e-6)}, speed);
        const double behind = resistance(*hull, omega, EncounterAngle{radians(90.0 - 1e-6)}, speed);
        EXPECT_LT(std::fabs(coefficient(*hull, ahead)), 1e-5);
        EXPECT_NEAR(resistance(*hull, omega, EncounterAngle{0.5 * kPi}, speed), 0.5 * (ahead + behind),
                    1e-5 * std::fabs(behind) + 1.0);
        if (std::fabs(behind - ahead) > std::fabs(jump)) {
          jump = behind - ahead;
          at = omega;
        }
      }
      std::printf("S-175 %s, %2.0f kn: largest jump at mu = 90: %+.2f rho g B^2/L at omega %.2f\n",
                  variant == StripVariant::kModified ? "modified" : "ordinary", speed_kn,
                  coefficient(*hull, jump), at);
      EXPECT_LT(std::fabs(coefficient(*hull, jump)), 4.0);
    }
  }
}

// The sum of the slopes of a waterline that closes is nothing: a wave that a ship at rest does not feel
// pushes from ahead and from astern alike.
TEST(IntegratedPressure, IsNothingOnAShipAtRestWhoseWaterlineCloses) {
  const auto hull = loaded(test::wigley_hull(3));
  const ResistanceWave wave = wave_on(*hull, 12.0, EncounterAngle{radians(40.0)});
  const double r = integrated_pressure_resistance(*hull, wave, at_rest(*hull, 12.0, wave.mu, 1.0));
  EXPECT_NEAR(coefficient(*hull, r), 0.0, 1e-12);
}

// Heave h and pitch theta in phase: the vertical force m omega_e^2 h leans back with a bow that dips.
TEST(IntegratedPressure, TurnsTheVerticalForceWithPitch) {
  const auto hull = loaded(test::wigley_hull(3));
  const ResistanceWave wave = wave_on(*hull, 2.0, EncounterAngle{0.0});
  MotionTransfer rest = at_rest(*hull, 2.0, wave.mu, 0.5);
  MotionTransfer moved = rest;
  moved.motion[2] = 0.3;
  MotionTransfer quadrature = moved;
  moved.motion[4] = 0.01;
  quadrature.motion[4] = Complex(0.0, 0.01);
  const double we = rest.encounter_frequency;
  const double turned = 0.5 * hull->body.mass * we * we * 0.3 * 0.01;
  // The pressure term of the two differs as well, but not where no pressure acts: without water.
  const auto dry = std::make_unique<LoadedHull>(*hull);
  dry->half_breadth.fill(0.0);
  EXPECT_NEAR(integrated_pressure_resistance(*dry, wave, moved), turned, 1e-12 * turned);
  EXPECT_NEAR(integrated_pressure_resistance(*dry, wave, quadrature), 0.0, 1e-12 * turned);
}

// A box held at rest in head waves: |V_z| = omega e^{-kT}, a and b the same all along her.
TEST(RadiatedEnergy, OfABoxHeldAtRestIsTheClosedForm) {
  const Hull ship = test::box_barge(100.0, 20.0, 6.0, 12.0, 61);
  const double omega = 0.9;
  const double speed = 5.0;
  const auto ordinary = loaded(ship);
  const double k = wave_number(omega, ordinary->gravity);
  const MotionTransfer rest = at_rest(*ordinary, omega, kHead, speed);
  const double we = rest.encounter_frequency;
  SectionValues a33;
  SectionValues b33;
  section_heave(*ordinary, we, a33, b33);
  const double velocity = omega * std::exp(-k * 6.0);
  const double expected = k / (2.0 * we) * b33[30] * 100.0 * velocity * velocity;
  const ResistanceWave wave = wave_on(*ordinary, omega, kHead);
  for (const RadiatedPower power : {RadiatedPower::kPublished, RadiatedPower::kStripWork}) {
    // e^{-kT} by two-point Gauss panels on a box of three offsets.
    EXPECT_NEAR(radiated_energy_resistance(*ordinary, wave, rest, speed, power), expected, 2e-3 * expected);
  }
  // The modified force: b omega / omega_e, as its wave loads have it; panels of 0.14 rad of wave.
  const auto modified = loaded(ship, StripVariant::kModified);
  EXPECT_NEAR(radiated_energy_resistance(*modified, wave, rest, speed, RadiatedPower::kStripWork),
              expected * omega / we, 5e-3 * expected);
}

// Two ways to the same sum: Re(v* (a v)_x) and, by parts, half of a_x |v|^2. With pitch zero v does not
// depend on speed, so the damping's share is the resistance for V = 0.
TEST(RadiatedEnergy, OrdinaryStripWorkIsHalfOfTheSlopeOfAddedMass) {
  const auto hull = loaded(test::wigley_hull(3));
  const double omega = 4.6;
  const ResistanceWave wave = wave_on(*hull, omega, kHead);
  MotionTransfer heaving = at_rest(*hull, omega, kHead, 1.1);
  heaving.motion[2] = Complex(0.4, -0.7);
  const auto r = [&](double speed, RadiatedPower power) {
    return radiated_energy_resistance(*hull, wave, heaving, speed, power);
  };
  const double damped = r(0.0, RadiatedPower::kPublished);
  const double published = r(1.1, RadiatedPower::kPublished);
  ASSERT_GT(std::fabs(published - damped), 0.05 * damped);
  EXPECT_NEAR(r(1.1, RadiatedPower::kStripWork), 0.5 * (damped + published),
              0.02 * std::fabs(published - damped));  // panels of 0.16 rad of wave
}

}  // namespace
}  // namespace quickstrip
