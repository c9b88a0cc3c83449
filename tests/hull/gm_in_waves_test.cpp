// Stability on a wave against closed forms: a box, a prism of triangular section, mirror images, and the
// still-water limit.
#include "core/hull/gm_in_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

double change_of(const Hull& hull, double height, double crest) {
  double change = 0.0;
  bool is_covered = true;
  EXPECT_TRUE(gm_change_on_wave(hull, hull.loading, height, crest, change, is_covered));
  EXPECT_TRUE(is_covered);
  return change;
}

constexpr double kL = 40.0;
constexpr double kB = 12.0;
constexpr double kT = 4.0;
constexpr std::size_t kStations = 64;

// Walls stay walls: the waterplane keeps its inertia, only the centre of buoyancy rises, by the mean square
// of the wave about the balanced waterline over 2 T.
TEST(GmInWaves, AWallSidedHullKeepsItsWaterplane) {
  const Hull box = test::box_barge(kL, kB, kT, 5.0, kStations);
  const double a = 0.8;
  EXPECT_NEAR(change_of(box, 2.0 * a, 0.5 * kL), 0.5 * a * a / (2.0 * kT), 1e-8);  // the cosine needs no trim
  // The sine trims her: of its mean square a^2/2 the straight line takes 3 a^2 / pi^2.
  const double trimmed = (0.5 - 3.0 / (kPi * kPi)) * a * a / (2.0 * kT);
  // The trapezoidal rule errs by (2 pi / 63)^2 / 12 of the 3/pi^2, which is 1.6 times what is left.
  EXPECT_NEAR(change_of(box, 2.0 * a, 0.25 * kL), trimmed, 5e-3 * trimmed);
}

Hull prism(double slope) {
  Hull hull = test::box_barge(kL, kB, kT, 5.0, kStations);
  for (Station& station : hull.stations) {
    station.offsets.clear();
    EXPECT_TRUE(station.offsets.push_back({0.0, 0.0}));
    EXPECT_TRUE(station.offsets.push_back({slope * 3.0 * kT, 3.0 * kT}));
  }
  return hull;
}

// Section y = s z: volume goes with d^2 and so settles D = sqrt(T^2 - a^2/2) under the wave, stability with
// d^3: 2/3 (s^3 + s) times the mean of (D + a cos)^3.
TEST(GmInWaves, AFlaredHullGainsWhatItsClosedFormSays) {
  for (const double slope : {0.5, 1.5}) {
    const double a = 1.1;
    const double d = std::sqrt(kT * kT - 0.5 * a * a);
    const double mean_cube = d * d * d + 1.5 * d * a * a;
    const double expected = 2.0 / 3.0 * (slope * slope + 1.0) * (mean_cube - kT * kT * kT) / (kT * kT);
    // Even stations integrate trigonometric polynomials exactly: rounding, and the balance to 1e-9.
    EXPECT_NEAR(change_of(prism(slope), 2.0 * a, 0.5 * kL), expected, 1e-6);
  }
}

TEST(GmInWaves, NoWaveChangesNothing) {
  EXPECT_EQ(change_of(prism(1.0), 0.0, 13.0), 0.0);
  const GmChange none = gm_change(gm_in_waves(prism(1.0), prism(1.0).loading), 0.0);
  EXPECT_EQ(none.least, 0.0F);
  EXPECT_EQ(none.greatest, 0.0F);
}

TEST(GmInWaves, BowAndSternAreMirrorImagesOfASymmetricHull) {
  const Hull hull = prism(0.8);
  for (const double aside : {3.0, 9.0, 17.0}) {
    EXPECT_NEAR(change_of(hull, 1.5, 0.5 * kL + aside), change_of(hull, 1.5, 0.5 * kL - aside), 1e-7);
  }
}

// Lengths by a factor: so do all changes (Froude).
TEST(GmInWaves, GrowsWithTheShip) {
  constexpr double kScale = 7.0;
  const Hull large = test::scaled(prism(0.8), kScale);
  EXPECT_NEAR(change_of(large, kScale * 1.5, kScale * 12.0), kScale * change_of(prism(0.8), 1.5, 12.0), 1e-6);
}

// A container ship: fine ends with flare over full walls amidships. A trough amidships and crests at the ends
// give her stability, a crest amidships takes it. In high waves the centre of buoyancy, which rises with the
// square of the height under hydrostatic pressure, gives some back.
TEST(GmInWaves, TheS175LosesStabilityOnACrestAmidships) {
  const Hull hull = test::s175();
  const GmInWaves table = gm_in_waves(hull, hull.loading);
  ASSERT_TRUE(table.is_known);
  EXPECT_EQ(table.covered_height, 0.0);  // her offsets end 1.5 m above the waterline
  for (std::size_t n = 1; n <= 5; ++n) {
    const GmChange& at = table.by_height[n];
    EXPECT_LT(at.least, n <= 3 ? table.by_height[n - 1].least : 0.0F);
    EXPECT_GT(at.greatest, table.by_height[n - 1].greatest);
    EXPECT_LT(at.least, at.mean);
    EXPECT_LT(at.mean, at.greatest);
    double amidships = 0.0;
    bool is_covered = true;
    ASSERT_TRUE(gm_change_on_wave(hull, hull.loading, 1.75 * static_cast<double>(n), 0.5 * hull.lpp,
                                  amidships, is_covered));
    EXPECT_LT(amidships, 0.0);
  }
}

TEST(GmInWaves, BetweenHeightsItIsAStraightLineAndBeyondTheLastOneHeld) {
  const GmInWaves table = gm_in_waves(prism(1.0), prism(1.0).loading);
  const GmChange middle = gm_change(table, 1.5 * GmInWaves::kStep * kL);
  EXPECT_FLOAT_EQ(middle.greatest, 0.5F * (table.by_height[1].greatest + table.by_height[2].greatest));
  EXPECT_EQ(gm_change(table, 9.0 * kL).least, table.by_height.back().least);
  EXPECT_EQ(gm_change(table, std::nan("")).least, table.by_height.back().least);
}

TEST(GmInWaves, AMinimalFormHasNone) {
  Hull hull = prism(1.0);
  hull.stations[3].offsets.clear();
  EXPECT_FALSE(gm_in_waves(hull, hull.loading).is_known);
}

}  // namespace
}  // namespace quickstrip
