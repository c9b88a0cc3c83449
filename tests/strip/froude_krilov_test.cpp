#include "core/strip/froude_krilov.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quickstrip {
namespace {

// A rectangle of breadth B and draught T on fine quadrature: every integral has a closed form.
ContourQuadrature<200> rectangle(double half_breadth, double draught) {
  ContourQuadrature<200> q;
  q.count = 200;
  for (std::size_t i = 0; i < q.count; ++i) {
    q.z[i] = -draught * (static_cast<double>(i) + 0.5) / static_cast<double>(q.count);
    q.y[i] = half_breadth;
    q.weight[i] = draught / static_cast<double>(q.count);
  }
  return q;
}

constexpr double kRho = 1025.0;
constexpr double kG = 9.81;

// Pressure rho g e^{-kT} on the bottom of a rectangle, cos(k y sin mu) integrated over its breadth.
TEST(FroudeKrilov, HeaveOnARectangleIsTheBottomPressure) {
  const double k = 0.08, b = 9.0, t = 7.0;
  const auto section = rectangle(b, t);
  for (const double mu : {0.0, 0.6, 0.5 * kPi, 2.5}) {
    const FroudeKrilov fk = froude_krilov(section.view(), b, kRho, kG, k, EncounterAngle{mu});
    const double kb = k * std::sin(mu);
    const double exact =
        2.0 * kRho * kG * std::exp(-k * t) * (std::fabs(kb) > 1e-9 ? std::sin(kb * b) / kb : b);
    EXPECT_NEAR(fk.heave / exact, 1.0, 1e-4);  // midpoint rule of 200 steps
  }
}

// Side force: 2 rho g sin(k b) (1 - e^{-kT})/k in beam waves.
TEST(FroudeKrilov, SwayOnARectangleIsThePressureDifferenceOfItsSides) {
  const double k = 0.08, b = 9.0, t = 7.0;
  const auto section = rectangle(b, t);
  const FroudeKrilov fk = froude_krilov(section.view(), b, kRho, kG, k, EncounterAngle{0.5 * kPi});
  EXPECT_NEAR(fk.sway, 2.0 * kRho * kG * std::sin(k * b) * (1.0 - std::exp(-k * t)) / k, 1e-4 * fk.sway);
}

// About O: sides -2 rho g sin(kb) int z e^{kz} dz, bottom rho g e^{-kT} 2 {sin(kb)/k^2 - b cos(kb)/k}: sum of
// moments.
TEST(FroudeKrilov, RollOnARectangleIsTheMomentOfItsSidesAndBottom) {
  const double k = 0.08, b = 9.0, t = 7.0;
  const auto section = rectangle(b, t);
  const FroudeKrilov fk = froude_krilov(section.view(), b, kRho, kG, k, EncounterAngle{0.5 * kPi});
  const double sides = (1.0 - std::exp(-k * t) * (1.0 + k * t)) / (k * k);  // -int_{-T}^0 z e^{kz} dz
  const double kernel = std::sin(k * b) / (k * k) - b * std::cos(k * b) / k;
  const double exact = 2.0 * kRho * kG * (kernel * std::exp(-k * t) - std::sin(k * b) * sides);
  EXPECT_NEAR(fk.roll, exact, 1e-3 * std::fabs(exact));  // midpoint rule, difference of large terms
}

TEST(FroudeKrilov, LongWavesGiveTheHydrostaticForceAndTheSectionsInertia) {
  const double k = 1e-6, b = 9.0, t = 7.0;
  const auto section = rectangle(b, t);
  const FroudeKrilov fk = froude_krilov(section.view(), b, kRho, kG, k, EncounterAngle{0.5 * kPi});
  EXPECT_NEAR(fk.heave, 2.0 * kRho * kG * b, 1e-4 * fk.heave);
  EXPECT_NEAR(fk.sway, kRho * kG * k * 2.0 * b * t, 1e-4 * fk.sway);
  EXPECT_NEAR(fk.heave_factor, 1.0, 1e-4);
  EXPECT_NEAR(fk.horizontal_factor, 1.0, 1e-4);
}

TEST(FroudeKrilov, ASubmergedSectionMovesWithTheWaterAtItsDepth) {
  ContourQuadrature<1> bulb;
  bulb.count = 1;
  bulb.z[0] = -6.0;
  bulb.y[0] = 1.0;
  bulb.weight[0] = 2.0;
  const FroudeKrilov fk = froude_krilov(bulb.view(), 0.0, kRho, kG, 0.1, EncounterAngle{kPi});
  EXPECT_NEAR(fk.heave_factor, std::exp(-0.6), 1e-12);
  EXPECT_LT(fk.heave, 0.0);  // no waterplane: only the pressure gradient, downwards under a crest
}

}  // namespace
}  // namespace quickstrip
