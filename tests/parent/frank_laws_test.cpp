// What binds every solution of Frank's method: irregular frequencies, Haskind's identities, limits, scale.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "sim/parent/frank.hpp"
#include "tests/parent/beam_loads.hpp"
#include "tests/parent/frank_sections.hpp"

namespace quickstrip {
namespace {

// K of the water inside a rectangle with phi = 0 on it: mode n of B, T; odd n are even in y.
double irregular(int n, double breadth, double draught) {
  const double k = n * kPi / breadth;
  return k / std::tanh(k * draught);
}

TEST(IrregularFrequencies, OfARectangleAreThereWhenLeftIn) {
  const FrankSection left(test::rectangle(1.0, 1.0), {.removes_irregular_frequencies = false});
  const FrankSection removed(test::rectangle(1.0, 1.0));
  const double first = irregular(1, 2.0, 1.0);
  const double second = irregular(2, 2.0, 1.0);
  // 4 % off and three times the amplitude of the radiated wave in heave, a22 twice what it is; flagged.
  EXPECT_GT(std::fabs(left.flow(first).h3), 2.0 * std::fabs(removed.flow(first).h3));
  EXPECT_GT(left.flow(second).a22, 1.5 * removed.flow(second).a22);
  EXPECT_FALSE(left.flow(first).is_converged);
  EXPECT_FALSE(left.flow(second).is_converged);
  EXPECT_TRUE(removed.flow(first).is_converged);
  EXPECT_TRUE(removed.flow(second).is_converged);
  // Elsewhere both say the same.
  EXPECT_NEAR(left.flow(0.8 * first).a22, removed.flow(0.8 * first).a22, 1e-3);
}

// a22, a33 by the water displaced, h2 and h3 by the breadth.
std::array<double, 4> values(const FrankSection& section, double k, double draught) {
  const SectionFlow flow = section.flow(k);
  return {flow.a22 / (2.0 * draught), flow.a33 / (2.0 * draught), flow.h2 / 2.0, flow.h3 / 2.0};
}

// Largest departure within 2 % of an irregular frequency from the cubic through four points outside.
std::array<double, 4> bumps(const FrankSection& section, double k, double draught) {
  const std::array<double, 4> at = {-0.10, -0.04, 0.04, 0.10};
  std::array<std::array<double, 4>, 4> known{};
  for (std::size_t i = 0; i < at.size(); ++i) {
    known[i] = values(section, k * (1.0 + at[i]), draught);
  }
  std::array<double, 4> worst{};
  for (int step = -5; step <= 5; ++step) {
    const double x = 0.004 * step;
    const std::array<double, 4> found = values(section, k * (1.0 + x), draught);
    for (std::size_t v = 0; v < worst.size(); ++v) {
      double expected = 0.0;
      for (std::size_t i = 0; i < at.size(); ++i) {
        double basis = known[i][v];
        for (std::size_t j = 0; j < at.size(); ++j) {
          basis *= j == i ? 1.0 : (x - at[j]) / (at[i] - at[j]);
        }
        expected += basis;
      }
      worst[v] = std::max(worst[v], std::fabs(found[v] - expected));
    }
  }
  return worst;
}

TEST(IrregularFrequencies, AreRemovedFromRectanglesOfEveryShape) {
  for (const double draught : {0.3, 1.0, 3.0}) {
    const FrankSection section(test::rectangle(1.0, draught));
    const FrankSection left(test::rectangle(1.0, draught), {.removes_irregular_frequencies = false});
    for (int n = 1; n <= 6; ++n) {
      const double k = irregular(n, 2.0, draught);
      // The cubic alone departs by 1e-4 to 1e-3.
      for (const double bump : bumps(section, k, draught)) {
        EXPECT_LT(bump, 0.003) << draught << ' ' << n;
      }
      const std::array<double, 4> there = bumps(left, k, draught);
      EXPECT_GT(*std::max_element(there.begin(), there.end()), 0.02) << draught << ' ' << n;
    }
  }
}

std::vector<SectionContour> sections() {
  return {
      test::rectangle(1.0, 1.0),
      test::rectangle(2.0, 0.5),
      test::semicircle(1.0, 400),
      test::lewis_contour(-0.466, -0.0316, 400),
      {{{0.0, -2.0}, {0.3, -1.8}, {0.5, -1.4}, {0.3, -1.0}, {0.2, -0.8}, {0.9, 0.0}}},  // re-entrant, flared
      {{{0.0, -1.0}, {0.6, -1.3}, {1.2, -1.1}, {1.2, 0.0}}},                            // tunnel
      test::submerged_ellipse(1.0, 1.0, 1.4, 400),
      test::submerged_ellipse(0.6, 1.2, 1.8, 400)};
}

TEST(FrankLaws, LoadsOfABeamWaveObeyHaskind) {
  for (const SectionContour& contour : sections()) {
    const FrankSection section(contour);
    for (const double k : {0.05, 0.3, 0.9, 2.0}) {
      const SectionFlow flow = section.flow(k);
      EXPECT_TRUE(flow.is_converged) << contour.points.size() << ' ' << k;
      const test::BeamLoads load = test::beam_loads(flow);
      // |X_j| = sqrt(rho g^2 b_jj / omega) = |h_j| here. Potentials on the panels are not extrapolated, the
      // amplitudes are: 0.1 % of the square root of the area.
      const double size = std::sqrt(area(contour));
      EXPECT_NEAR(std::abs(load.heave), std::fabs(flow.h3), 1e-3 * size);
      EXPECT_NEAR(std::abs(load.sway), std::fabs(flow.h2), 1e-3 * size);
      EXPECT_NEAR(std::abs(load.roll), std::fabs(flow.h4), 1e-3 * size * size);
      EXPECT_NEAR(std::abs(load.roll - load.sway * (flow.h4 / flow.h2)), 0.0, 1e-3 * size * size);
    }
  }
}

TEST(FrankLaws, PotentialsOnThePanelsGiveAddedMassBack) {
  for (const SectionContour& contour : sections()) {
    const SectionFlow flow = FrankSection(contour).flow(0.6);
    std::complex<double> heave;
    std::complex<double> sway;
    std::complex<double> forth;
    std::complex<double> back;
    for (const FlowPoint& p : flow.points) {
      heave += 2.0 * p.phi[kSectionHeave] * p.nz_ds;
      sway += 2.0 * p.phi[kSectionSway] * p.ny_ds;
      forth += 2.0 * p.phi[kSectionRoll] * p.ny_ds;
      back += 2.0 * p.phi[kSectionSway] * (p.y * p.nz_ds - p.z * p.ny_ds);
    }
    // Before extrapolation: 0.2 % of the sum of both parts.
    const double size = area(contour);
    EXPECT_NEAR(heave.real(), -flow.a33, 2e-3 * size);
    EXPECT_NEAR(heave.imag(), flow.h3 * flow.h3, 2e-3 * size);
    EXPECT_NEAR(sway.real(), -flow.a22, 2e-3 * size);
    EXPECT_NEAR(sway.imag(), flow.h2 * flow.h2, 2e-3 * size);
    EXPECT_NEAR(std::abs(forth - back), 0.0, 2e-3 * std::pow(size, 1.5));
  }
}

TEST(FrankLaws, LongAndShortWavesTendToTheClosedFormsOfALewisForm) {
  // section-coefficients' closed forms for M = 1 ([Tasai1961], as the table generator's tests have them):
  // a22(0), a44(0), a33(inf), a22(inf).
  const double a1 = 0.12;
  const double a3 = -0.05;
  const FrankSection section(test::lewis_contour(a1, a3, 800), {.num_panels = 112});
  const SectionFlow slow = section.flow(1e-5);
  EXPECT_NEAR(slow.a22, 0.5 * kPi * (std::pow(1.0 - a1, 2) + 3.0 * a3 * a3), 1e-3);
  EXPECT_NEAR(
      slow.a44,
      16.0 / kPi * (std::pow(a1 * (1.0 + a3), 2) + 8.0 / 9.0 * a1 * a3 * (1.0 + a3) + 16.0 / 9.0 * a3 * a3),
      1e-3);
  // b33 -> rho omega B^2
  EXPECT_NEAR(slow.h3, 2.0 * (1.0 + a1 + a3), 1e-3);
  const SectionFlow fast = section.flow(300.0);
  const double a33 = 0.5 * kPi * (std::pow(1.0 + a1, 2) + 3.0 * a3 * a3);
  const double draught = 1.0 - a1 + a3;
  EXPECT_NEAR(fast.a33, a33, 0.005 * a33);  // 1/xi off
  EXPECT_NEAR(fast.a22, 2.0 / kPi * (draught * draught + 16.0 / 3.0 * a3 * a3), 0.02);
}

TEST(FrankLaws, ScaleAsFroudeSays) {
  const SectionFlow model = FrankSection(test::rectangle(1.0, 0.7)).flow(0.9);
  const SectionFlow ship = FrankSection(test::rectangle(20.0, 14.0)).flow(0.9 / 20.0);
  EXPECT_NEAR(ship.a22, 400.0 * model.a22, 1e-8 * ship.a22);
  EXPECT_NEAR(ship.a24, 8e3 * model.a24, 1e-8 * ship.a24);
  EXPECT_NEAR(ship.a44, 16e4 * model.a44, 1e-8 * ship.a44);
  EXPECT_NEAR(ship.a33, 400.0 * model.a33, 1e-8 * ship.a33);
  EXPECT_NEAR(ship.h3, 20.0 * model.h3, 1e-8 * ship.h3);
  EXPECT_NEAR(ship.h4, 400.0 * model.h4, 1e-8 * ship.h4);
}

TEST(FrankLaws, FilmOfWaterOverABulbIsSolvedWithMorePanels) {
  // A circle 2 mm below the surface per metre of radius, at its resonance: heave and sway are one (an
  // identity that 56 panels miss by 5 %).
  const SectionContour circle = test::submerged_ellipse(1.0, 1.0, 1.002, 800);
  const SectionFlow flow = FrankSection(circle).flow(0.3);
  EXPECT_GT(flow.points.size(), 100U);
  EXPECT_TRUE(flow.is_converged);
  EXPECT_NEAR(flow.a33, flow.a22, 0.005 * std::fabs(flow.a22));
  EXPECT_NEAR(flow.h3, flow.h2, 0.005 * flow.h2);
}

TEST(FrankLaws, ThinPlateIsThatOfTheClosedForm) {
  // A vertical plate of draught T in slow motion (a wall at z = 0): pi T^2 / 2, half that of a plate of
  // breadth 2 T in unbounded water ([Lamb1932]); in roll T^4 / pi (the Lewis form a1 = -1, a3 = 0). Half
  // thickness 0.003 T.
  const FrankSection plate({{{0.0, -1.0}, {0.003, -1.0}, {0.003, 0.0}}});
  const SectionFlow flow = plate.flow(1e-4);
  EXPECT_NEAR(flow.a22, 0.5 * kPi, 0.015 * flow.a22);
  EXPECT_NEAR(flow.a44, 1.0 / kPi, 0.02 * flow.a44);
}

}  // namespace
}  // namespace quickstrip
