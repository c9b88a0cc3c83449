// Cutting stations at the waterline: closed forms of simple polygons, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>

#include "core/hull/hydrostatics.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

constexpr double kRounding = 1e-12;  // a handful of operations on numbers of order 1 ... 100
const double kNan = std::numeric_limits<double>::quiet_NaN();

// Five equal stations over 0 ... 40 m with these offsets, floating at 4 m.
Hull prism(std::initializer_list<Offset> offsets) {
  Hull hull = test::box_barge(40.0, 10.0, 4.0, 6.0, 5);
  for (Station& station : hull.stations) {
    station.offsets.clear();
    for (const Offset& offset : offsets) {
      EXPECT_TRUE(station.offsets.push_back(offset));
    }
  }
  return hull;
}

Error error_of(const Hull& hull) {
  const auto sections = std::make_unique<ImmersedSections>();
  return immerse(hull, hull.loading, *sections).error();
}

std::unique_ptr<ImmersedSections> cut(const Hull& hull) {
  auto sections = std::make_unique<ImmersedSections>();
  EXPECT_EQ(immerse(hull, hull.loading, *sections).error(), Error::kNone);
  return sections;
}

TEST(Immersion, RectangleHasAreaBreadthTimesDraughtAndItsCentroidAtHalfDraught) {
  const auto sections = cut(test::box_barge(40.0, 10.0, 4.0, 6.0, 5));
  ASSERT_EQ(sections->size(), 5U);
  const ImmersedSection& s = (*sections)[2];
  EXPECT_NEAR(s.area, 40.0, kRounding * 40.0);
  EXPECT_NEAR(s.centroid_z, -2.0, kRounding);
  EXPECT_NEAR(s.breadth, 10.0, kRounding);
  EXPECT_NEAR(s.draught, 4.0, kRounding);
  EXPECT_NEAR(s.waterline_z, 4.0, kRounding);
}

TEST(Immersion, TriangleHasHalfTheAreaAndItsCentroidAThirdDown) {
  const auto sections = cut(prism({{0.0, 0.0}, {6.0, 6.0}}));
  const ImmersedSection& s = (*sections)[0];
  EXPECT_NEAR(s.breadth, 8.0, kRounding);
  EXPECT_NEAR(s.area, 16.0, kRounding * 16.0);
  EXPECT_NEAR(s.centroid_z, -4.0 / 3.0, kRounding);
}

TEST(Immersion, ContourRunsFromKeelToAnInterpolatedPointOnTheWaterline) {
  const auto sections = cut(prism({{0.0, 0.0}, {3.0, 1.0}, {5.0, 3.0}, {6.0, 7.0}}));
  const auto& contour = (*sections)[0].contour;
  ASSERT_EQ(contour.size(), 4U);
  EXPECT_EQ(contour.front().y, 0.0);
  EXPECT_NEAR(contour.front().z, -4.0, kRounding);
  EXPECT_NEAR(contour.back().y, 5.25, kRounding);  // a quarter of the way from z 3 to z 7
  EXPECT_EQ(contour.back().z, 0.0);
  for (std::size_t i = 1; i < contour.size(); ++i) {
    EXPECT_GT(contour[i].z, contour[i - 1].z);
    EXPECT_GE(contour[i].y, 0.0);
  }
}

TEST(Immersion, OffsetOnTheWaterlineIsNotDoubled) {
  const auto sections = cut(prism({{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}, {5.0, 6.0}}));
  EXPECT_EQ((*sections)[0].contour.size(), 3U);
}

TEST(Immersion, FirstOffsetWithBreadthIsTheEdgeOfAFlatBottom) {
  const auto with_keel_point = cut(prism({{0.0, 0.0}, {2.0, 0.0}, {5.0, 6.0}}));
  const auto without = cut(prism({{2.0, 0.0}, {5.0, 6.0}}));
  EXPECT_EQ((*with_keel_point)[0].area, (*without)[0].area);
  EXPECT_EQ((*with_keel_point)[0].centroid_z, (*without)[0].centroid_z);
  EXPECT_NEAR((*without)[0].area, 24.0, kRounding * 24.0);  // trapezium: (4 + 8)/2 x 4
}

TEST(Immersion, BulbThatClosesBelowTheWaterlineIsWhollySubmerged) {
  // A rhombus from z 1 to z 3, half-breadth 1: area 2, centroid 2 m below the waterline.
  const auto sections = cut(prism({{0.0, 1.0}, {1.0, 2.0}, {0.0, 3.0}}));
  const ImmersedSection& s = (*sections)[0];
  EXPECT_EQ(s.breadth, 0.0);
  EXPECT_NEAR(s.area, 2.0, kRounding);
  EXPECT_NEAR(s.draught, 3.0, kRounding);
  EXPECT_NEAR(s.centroid_z, -2.0, kRounding);
  EXPECT_EQ(s.contour.back().y, 0.0);
  EXPECT_NEAR(s.contour.back().z, -1.0, kRounding);
}

TEST(Immersion, OffsetsWithoutBreadthAboveABulbChangeNothing) {
  const auto closed = cut(prism({{0.0, 1.0}, {1.0, 2.0}, {0.0, 3.0}}));
  const auto with_sheet =
      cut(prism({{0.0, 0.0}, {0.0, 1.0}, {1.0, 2.0}, {0.0, 3.0}, {0.0, 5.0}, {0.5, 9.0}}));
  EXPECT_EQ((*with_sheet)[0].contour.size(), 3U);
  EXPECT_EQ((*with_sheet)[0].area, (*closed)[0].area);
  EXPECT_EQ((*with_sheet)[0].draught, (*closed)[0].draught);
  EXPECT_EQ((*with_sheet)[0].breadth, 0.0);
}

TEST(Immersion, BulbNarrowAtTheWaterlineKeepsItsSmallBreadth) {
  const auto sections = cut(prism({{0.0, 0.0}, {1.0, 2.0}, {0.1, 4.0}, {0.5, 6.0}}));
  const ImmersedSection& s = (*sections)[0];
  EXPECT_NEAR(s.breadth, 0.2, kRounding);
  EXPECT_NEAR(s.area, 2.0 * (1.0 + 1.1), 1e-11);
  EXPECT_GT(s.area, s.breadth * s.draught);  // sigma above 1
}

TEST(Immersion, StationAboveTheWaterIsLeftOutAndEndsTheHullThere) {
  Hull hull = test::box_barge(40.0, 10.0, 4.0, 9.0, 5);
  hull.stations[0].offsets.clear();
  ASSERT_TRUE(hull.stations[0].offsets.push_back({0.0, 4.5}));
  ASSERT_TRUE(hull.stations[0].offsets.push_back({5.0, 9.0}));
  const auto sections = cut(hull);
  ASSERT_EQ(sections->size(), 4U);
  EXPECT_EQ(sections->front().x, 10.0);
  EXPECT_EQ(sections->front().weight, 10.0);  // the area falls to nothing over the aftermost 10 m
  EXPECT_EQ(sections->back().weight, 5.0);
}

TEST(Immersion, StationThatOnlyTouchesTheWaterIsLeftOut) {
  Hull hull = test::box_barge(40.0, 10.0, 4.0, 9.0, 5);
  hull.stations[0].offsets[0].z = 4.0 - 1e-6;
  hull.stations[0].offsets[1].z = 4.0 - 1e-6;
  EXPECT_EQ(cut(hull)->size(), 4U);
}

TEST(Immersion, TrimCutsEachStationAtItsOwnDraughtAlsoOutsideThePerpendiculars) {
  Hull hull = test::box_barge(40.0, 10.0, 4.0, 9.0, 5);
  hull.stations[0].x = -8.0;
  hull.loading.draught_aft = 5.0;
  hull.loading.draught_fwd = 3.0;
  const auto sections = cut(hull);
  EXPECT_NEAR(sections->front().draught, 5.4, kRounding);
  EXPECT_NEAR((*sections)[1].draught, 4.5, kRounding);
  EXPECT_NEAR(sections->back().draught, 3.0, kRounding);
}

TEST(Immersion, OvertoppedDeckIsRefused) {
  Hull hull = test::box_barge(40.0, 10.0, 4.0, 6.0, 5);
  hull.loading.draught_fwd = 6.01;
  EXPECT_EQ(error_of(hull), Error::kDraughtAboveDeck);
  hull.loading.draught_fwd = 6.0;  // awash is not overtopped
  EXPECT_EQ(error_of(hull), Error::kNone);
}

TEST(Immersion, OffsetsFromDeckToKeelAreRefused) {
  EXPECT_EQ(error_of(prism({{5.0, 6.0}, {5.0, 0.0}, {0.0, 0.0}})), Error::kContourNotOrdered);
}

TEST(Immersion, StationsFromBowToSternOrTwiceAtOnePlaceAreRefused) {
  Hull hull = test::box_barge(40.0, 10.0, 4.0, 6.0, 5);
  hull.stations[3].x = hull.stations[2].x;
  EXPECT_EQ(error_of(hull), Error::kStationsNotOrdered);
  hull.stations[3].x = hull.stations[1].x;
  EXPECT_EQ(error_of(hull), Error::kStationsNotOrdered);
}

TEST(Immersion, FewerThanThreeStationsInTheWaterAreRefused) {
  Hull hull = test::box_barge(40.0, 10.0, 4.0, 6.0, 2);
  EXPECT_EQ(error_of(hull), Error::kTooFewStations);
  hull = test::box_barge(40.0, 10.0, 4.0, 6.0, 5);
  hull.loading.draught_aft = hull.loading.draught_fwd = -1.0;
  EXPECT_EQ(error_of(hull), Error::kTooFewStations);
}

TEST(Immersion, NegativeHalfBreadthAndSinglePointAreRefused) {
  EXPECT_EQ(error_of(prism({{0.0, 0.0}, {-5.0, 0.0}, {-5.0, 6.0}})), Error::kOutOfRange);
  EXPECT_EQ(error_of(prism({{5.0, 0.0}})), Error::kOutOfRange);
}

TEST(Immersion, NanAnywhereIsRefusedAndLeavesNoSections) {
  const Hull good = test::box_barge(40.0, 10.0, 4.0, 6.0, 5);
  for (const int where : {0, 1, 2, 3, 4, 5}) {
    Hull hull = good;
    double* const places[] = {
        &hull.lpp,           &hull.loading.draught_aft,      &hull.loading.draught_fwd,
        &hull.stations[4].x, &hull.stations[4].offsets[2].y, &hull.stations[4].offsets[2].z};
    *places[where] = kNan;
    const auto sections = std::make_unique<ImmersedSections>();
    EXPECT_EQ(immerse(hull, hull.loading, *sections).error(), Error::kNotFinite) << where;
    EXPECT_TRUE(sections->empty()) << where;
  }
}

}  // namespace
}  // namespace quickstrip
