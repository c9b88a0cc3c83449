// Wigley hulls against the tank: Journee, report 0909 (1992), figures as quoted in public test files. The
// independent check of first light: the misses are printed and are strip theory's own (A55 and B55 at speed;
// resonance).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "core/strip/equations_of_motion.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

constexpr double kLength = 3.0;
constexpr double kTankGravity = 9.81;

std::unique_ptr<LoadedHull> wigley(int which) {
  Hull hull = test::wigley_hull(which);
  hull.loading.gravity = kTankGravity;
  auto out = std::make_unique<LoadedHull>();
  const Status status = load(hull, hull.loading, {}, *out);
  EXPECT_TRUE(status.ok()) << message(status.error());
  return out;
}

double speed_at(double fn) {
  return fn * std::sqrt(kTankGravity * kLength);
}

TEST(WigleyIII, HeaveAddedMassAndDampingAtFn03AreThoseMeasured) {
  const auto hull = wigley(3);
  // we sqrt(L/g), A33/(rho nabla), B33/(rho nabla) sqrt(L/g)
  constexpr double kMeasured[][3] = {{2.22, 0.707, 1.963},
                                     {2.78, 0.537, 1.994},
                                     {3.34, 0.465, 1.854},
                                     {3.88, 0.425, 1.706},
                                     {4.45, 0.421, 1.518}};
  const double root = std::sqrt(kLength / kTankGravity);
  for (const auto& m : kMeasured) {
    const double we = m[0] / root;
    const auto h = hydrodynamic_coefficients(*hull, we, speed_at(0.3));
    const double a = h.a[2][2] / hull->body.mass;
    const double b = h.b[2][2] / hull->body.mass * root;
    std::printf(
        "Wigley III Fn 0.3 we' %.2f: A33 %.3f measured %.3f (%+.0f %%), B33 %.3f measured %.3f (%+.0f %%)\n",
        m[0], a, m[1], 100 * (a / m[1] - 1), b, m[2], 100 * (b / m[2] - 1));
    // Strip theory has A33 14-17 % low and B33 3-14 % high here; three-dimensional flow and forward speed,
    // which it leaves out, are of the order of Fn and B/L.
    EXPECT_NEAR(a, m[1], 0.20 * m[1]);
    EXPECT_NEAR(b, m[2], 0.20 * m[2]);
  }
}

TEST(WigleyIII, HeadWaveLoadsAtFn03AreThoseMeasured) {
  const auto hull = wigley(3);
  // lambda/L, X3/(C33 zeta), X5/(k C55 zeta)
  constexpr double kMeasured[][3] = {
      {1.25, 0.345, 0.444}, {1.5, 0.454, 0.546}, {1.75, 0.515, 0.600}, {2.0, 0.577, 0.658}};
  for (const auto& m : kMeasured) {
    const double k = kTwoPi / (m[0] * kLength);
    const double omega = std::sqrt(kTankGravity * k);
    const double speed = speed_at(0.3);
    const double we = omega + k * speed;
    WaveField field;
    SectionWaves sections;
    section_waves(*hull, omega, EncounterAngle{kPi}, sections);
    wave_field(*hull, omega, EncounterAngle{kPi}, sections, nullptr, field);
    SectionHydrodynamics section;
    section_hydrodynamics(*hull, we, section);
    const auto load = wave_loads(*hull, field, section, we, speed);
    const double x3 = std::abs(load[2]) / hull->restoring.c33;
    const double x5 = std::abs(load[4]) / (k * hull->restoring.c55);
    std::printf("Wigley III Fn 0.3 lambda/L %.2f: X3 %.3f measured %.3f, X5 %.3f measured %.3f\n", m[0], x3,
                m[1], x5, m[2]);
    EXPECT_NEAR(x3, m[1], 0.10 * m[1]);  // found: -3 ... +6 %
    EXPECT_NEAR(x5, m[2], 0.15 * m[2]);  // found: +7 ... +12 %
  }
}

struct HeavePoint {
  int hull;
  double fn;
  double lambda_over_length;
  double heave;
};

TEST(Wigley, HeaveInHeadWavesAgainstTheTank) {
  constexpr HeavePoint kMeasured[] = {{3, 0.2, 1.25, 0.71}, {3, 0.2, 1.5, 0.81},   {3, 0.2, 2.0, 0.90},
                                      {3, 0.3, 1.25, 1.28}, {3, 0.3, 1.384, 1.11}, {3, 0.3, 1.5, 1.01},
                                      {3, 0.3, 2.0, 0.99},  {1, 0.3, 1.25, 2.52},  {3, 0.0, 1.0, 0.29},
                                      {3, 0.0, 1.5, 0.57},  {3, 0.0, 2.0, 0.74},   {4, 0.0, 1.0, 0.30},
                                      {4, 0.0, 1.5, 0.65},  {4, 0.0, 2.0, 0.79}};
  for (const HeavePoint& m : kMeasured) {
    const auto hull = wigley(m.hull);
    const double k = kTwoPi / (m.lambda_over_length * kLength);
    const double omega = std::sqrt(kTankGravity * k);
    const auto t = motion_transfer(*hull, omega, EncounterAngle{kPi}, speed_at(m.fn));
    const double heave = std::abs(t.motion[2]);
    std::printf("Wigley %d Fn %.1f lambda/L %.3f: heave %.3f measured %.2f (%+.0f %%)\n", m.hull, m.fn,
                m.lambda_over_length, heave, m.heave, 100 * (heave / m.heave - 1));
    EXPECT_NEAR(heave, m.heave,
                0.12 * m.heave);  // found: -9 ... +10 %, the scatter of tank and theory together
  }
}

}  // namespace
}  // namespace quickstrip
