// Displacement, centres and stability against closed forms, and the Wigley hulls against their formula.
#include "core/hull/hydrostatics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

Result<Hydrostatics> float_hull(const Hull& hull) {
  const auto sections = std::make_unique<ImmersedSections>();
  const Status status = immerse(hull, hull.loading, *sections);
  return status ? hydrostatics(hull, hull.loading, *sections) : Result<Hydrostatics>(status.error());
}

TEST(Hydrostatics, BoxHasItsClosedForms) {
  const double l = 40.0;
  const double b = 12.0;
  const double t = 4.0;
  const std::size_t stations = 41;
  const auto h = float_hull(test::box_barge(l, b, t, 6.0, stations));
  ASSERT_TRUE(h.ok());
  const double rounding = 1e-11;  // relative, of sums over 41 stations
  EXPECT_NEAR(h->volume, l * b * t, l * b * t * rounding);
  EXPECT_NEAR(h->displacement, 1025.0 * l * b * t, 1025.0 * l * b * t * rounding);
  EXPECT_NEAR(h->lcb, l / 2.0, l * rounding);
  EXPECT_NEAR(h->lcf, l / 2.0, l * rounding);
  EXPECT_NEAR(h->kb, t / 2.0, t * rounding);
  EXPECT_NEAR(h->bm, b * b / (12.0 * t), b * rounding);
  EXPECT_NEAR(h->gm, t / 2.0 + b * b / (12.0 * t) - t, b * rounding);
  EXPECT_NEAR(h->waterplane_area, l * b, l * b * rounding);
  EXPECT_NEAR(h->cb, 1.0, rounding);
  EXPECT_NEAR(h->cm, 1.0, rounding);
  EXPECT_NEAR(h->cwp, 1.0, rounding);
  // The trapezoidal rule over n panels makes L^3/12 (1 + 2/n^2) of the integral of x^2.
  const double n = static_cast<double>(stations - 1);
  const double bml = l * l / (12.0 * t) * (1.0 + 2.0 / (n * n));
  EXPECT_NEAR(h->gml, t / 2.0 + bml - t, bml * rounding);
}

TEST(Hydrostatics, TrimmedBoxKeepsItsVolumeAndMovesItsCentres) {
  const double l = 40.0;
  const double t = 4.0;
  Hull hull = test::box_barge(l, 12.0, t, 9.0, 64);
  const double slope = 0.02;  // by the stern
  hull.loading.draught_aft = t + slope * l / 2.0;
  hull.loading.draught_fwd = t - slope * l / 2.0;
  const auto h = float_hull(hull);
  ASSERT_TRUE(h.ok());
  const double n = 63.0;
  const double inertia = l * l / 12.0 * (1.0 + 2.0 / (n * n));  // trapezoidal integral of x^2, over l
  EXPECT_NEAR(h->volume, l * 12.0 * t, 1e-8);
  EXPECT_NEAR(h->lcb, l / 2.0 - slope * inertia / t, 1e-10);
  EXPECT_NEAR(h->kb, t / 2.0 + slope * slope * inertia / (2.0 * t), 1e-10);
  EXPECT_NEAR(h->lcf, l / 2.0, 1e-10);
  EXPECT_NEAR(h->draught_at_lcb, t + slope * (l / 2.0 - h->lcb), 1e-10);
}

struct WigleyFigures {
  int which;
  double volume;  // m3, report 0909 (four decimals)
};

TEST(Hydrostatics, WigleyHullsDisplaceWhatTheirReportSays) {
  for (const WigleyFigures& wigley : {WigleyFigures{1, 0.0946}, {2, 0.1892}, {3, 0.0780}, {4, 0.1560}}) {
    const auto h = float_hull(test::wigley_hull(wigley.which));
    ASSERT_TRUE(h.ok()) << wigley.which;
    // Four printed decimals (0.05 %), and the trapezoidal rule on 41 stations and 41 points (0.09 %).
    EXPECT_NEAR(h->volume, wigley.volume, 0.0015 * wigley.volume) << wigley.which;
    EXPECT_NEAR(h->lcb, 1.5, 1e-12);
    EXPECT_NEAR(h->cm, wigley.which <= 2 ? 0.909 : 0.667, 0.001);
  }
}

TEST(Hydrostatics, WigleyIIIHasTheWaterplaneStiffnessOfItsExperiments) {
  const Hull hull = test::wigley_hull(3, 64);
  const auto h = float_hull(hull);
  ASSERT_TRUE(h.ok());
  const double rho_g = 1000.0 * kStandardGravity;
  // 6119 N/m and 2874 N m/rad (waterplane part alone); trapezoidal rule on 64 stations: 0.03 and 0.12 %.
  EXPECT_NEAR(rho_g * h->waterplane_area, 6119.0, 0.0005 * 6119.0);
  EXPECT_NEAR(rho_g * h->volume * (h->gml - h->kb + h->kg), 2874.0, 0.0015 * 2874.0);
}

TEST(Hydrostatics, TrapezoidalRuleOnTheWigleyHullConvergesWithTheSquareOfTheSpacing) {
  // By parts of the formula: V = B d (L/2) (2/3) (4/3 + 0.2 (2/3 - 2/5)); 101 points down the section.
  const double exact = 0.3 * 0.1875 * 1.5 * (2.0 / 3.0) * (4.0 / 3.0 + 0.2 * (2.0 / 3.0 - 2.0 / 5.0));
  const auto coarse = float_hull(test::wigley_hull(3, 21, 101));
  const auto fine = float_hull(test::wigley_hull(3, 41, 101));
  ASSERT_TRUE(coarse.ok() && fine.ok());
  const double vertical = exact * 0.25e-4;  // what 101 points leave: h^2/4 of (1 - z^2)
  const double ratio = (exact - vertical - coarse->volume) / (exact - vertical - fine->volume);
  EXPECT_NEAR(ratio, 4.0, 0.03);  // the next power of the spacing
  EXPECT_LT(std::abs(coarse->volume - exact), 0.0031 * exact);
}

TEST(Hydrostatics, FroudeScalingHolds) {
  const double scale = 36.5;
  const Hull model = test::wigley_hull(1);
  const auto m = float_hull(model);
  const auto s = float_hull(test::scaled(model, scale));
  ASSERT_TRUE(m.ok() && s.ok());
  const double rounding = 1e-12;
  EXPECT_NEAR(s->displacement / m->displacement / std::pow(scale, 3), 1.0, rounding);
  EXPECT_NEAR(s->waterplane_area / m->waterplane_area / std::pow(scale, 2), 1.0, rounding);
  EXPECT_NEAR(s->gm / m->gm / scale, 1.0, 1e-11);  // a difference of larger numbers
  EXPECT_NEAR(s->gml / m->gml / scale, 1.0, rounding);
  EXPECT_NEAR(s->cb / m->cb, 1.0, rounding);
}

TEST(Hydrostatics, FreeSurfaceLowersGmAndAGivenGmReplacesBoth) {
  Hull hull = test::box_barge(40.0, 12.0, 4.0, 6.0);
  const auto solid = float_hull(hull);
  hull.loading.free_surface_correction = 0.25;
  const auto fluid = float_hull(hull);
  hull.loading.gm = 0.8;
  const auto given = float_hull(hull);
  ASSERT_TRUE(solid.ok() && fluid.ok() && given.ok());
  EXPECT_NEAR(fluid->gm, solid->gm - 0.25, 1e-12);
  EXPECT_NEAR(fluid->kg_fluid, fluid->kg + 0.25, 1e-12);
  EXPECT_EQ(fluid->gml, solid->gml);  // position of G: solid
  EXPECT_NEAR(given->gm, 0.8, 1e-12);
  EXPECT_NEAR(given->kg_fluid, given->kb + given->bm - 0.8, 1e-12);
  EXPECT_EQ(given->kg, 4.0);
}

TEST(Hydrostatics, HullThatCapsizesIsRefused) {
  Hull hull = test::box_barge(40.0, 12.0, 4.0, 6.0);
  hull.loading.kg = 5.0 - 1e-9;  // KM = 2 + 3
  EXPECT_TRUE(float_hull(hull).ok());
  hull.loading.kg = 5.0 + 1e-9;
  EXPECT_EQ(float_hull(hull).error(), Error::kUnstable);
  hull.loading.kg = 4.0;
  hull.loading.gm = 0.0;
  EXPECT_EQ(float_hull(hull).error(), Error::kUnstable);
}

TEST(Hydrostatics, NanAndImpossibleLoadingAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Hull good = test::box_barge(40.0, 12.0, 4.0, 6.0);
  Hull hull = good;
  hull.loading.kg = nan;
  EXPECT_EQ(float_hull(hull).error(), Error::kNotFinite);
  hull = good;
  hull.loading.gm = nan;
  EXPECT_EQ(float_hull(hull).error(), Error::kNotFinite);
  hull = good;
  hull.loading.water_density = nan;
  EXPECT_EQ(float_hull(hull).error(), Error::kNotFinite);
  hull.loading.water_density = 0.0;
  EXPECT_EQ(float_hull(hull).error(), Error::kOutOfRange);
}

TEST(Hydrostatics, HullWithoutWaterplaneIsRefused) {
  Hull hull = test::box_barge(40.0, 12.0, 4.0, 6.0);
  for (Station& station : hull.stations) {
    station.offsets.clear();
    for (const Offset& offset : {Offset{0.0, 0.0}, Offset{1.0, 1.0}, Offset{0.0, 2.0}}) {
      ASSERT_TRUE(station.offsets.push_back(offset));
    }
  }
  EXPECT_EQ(float_hull(hull).error(), Error::kNoImmersedVolume);
}

}  // namespace
}  // namespace quickstrip
