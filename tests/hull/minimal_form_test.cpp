// Stations given by breadth, draught and area [Journee1992] §4: one draught, and what is known of them.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/hull/hydrostatics.hpp"
#include "core/hull/minimal_section.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

// A box of five stations, of minimal form except those from `offsets_from` on.
Hull minimal_box(std::size_t offsets_from = 5) {
  Hull hull = test::box_barge(40.0, 10.0, 4.0, 6.0, 5);
  for (std::size_t i = 0; i < offsets_from; ++i) {
    hull.stations[i].offsets.clear();
    hull.stations[i].breadth = 10.0;
    hull.stations[i].draught = 4.0;
    hull.stations[i].area = 40.0;
  }
  return hull;
}

Error error_of(const Hull& hull, const Loading& loading) {
  const auto sections = std::make_unique<ImmersedSections>();
  return immerse(hull, loading, *sections).error();
}

TEST(MinimalForm, BoxGivesTheSameHydrostaticsAsItsOffsets) {
  const auto by_offsets = std::make_unique<ImmersedSections>();
  const auto by_form = std::make_unique<ImmersedSections>();
  for (const std::size_t offsets_from : {5U, 2U}) {  // all of minimal form, and mixed
    const Hull hull = minimal_box(offsets_from);
    const Hull box = test::box_barge(40.0, 10.0, 4.0, 6.0, 5);
    ASSERT_TRUE(immerse(hull, hull.loading, *by_form).ok());
    ASSERT_TRUE(immerse(box, box.loading, *by_offsets).ok());
    const auto a = hydrostatics(hull, hull.loading, *by_form);
    const auto b = hydrostatics(box, box.loading, *by_offsets);
    ASSERT_TRUE(a.ok() && b.ok());
    // Morrish's rule is exact for the rectangle: rounding only.
    EXPECT_NEAR(a->kb, b->kb, 1e-12);
    EXPECT_NEAR(a->gm, b->gm, 1e-12);
    EXPECT_NEAR(a->volume, b->volume, 1e-9);
  }
}

TEST(MinimalForm, OtherDraughtsThanTheHullFilesAreRefused) {
  const Hull hull = minimal_box();
  Loading loading = hull.loading;
  loading.draught_aft += 0.003;  // within 0.1 % of 4 m
  EXPECT_EQ(error_of(hull, loading), Error::kNone);
  loading.draught_aft += 0.003;
  EXPECT_EQ(error_of(hull, loading), Error::kDraughtNotSupported);
  EXPECT_EQ(error_of(minimal_box(2), loading), Error::kDraughtNotSupported);
}

TEST(MinimalForm, CruiserSternMayBeShallowButSomeStationMustReachTheBaseLine) {
  Hull hull = minimal_box();
  hull.stations[0].draught = 1.0;
  hull.stations[0].area = 5.0;
  EXPECT_EQ(error_of(hull, hull.loading), Error::kNone);
  for (Station& station : hull.stations) {
    station.draught = 3.9;  // the file's loading says 4.0
  }
  EXPECT_EQ(error_of(hull, hull.loading), Error::kDraughtNotSupported);
}

TEST(MinimalForm, CentroidLiesNearThatOfTriangleAndSemicircle) {
  Hull hull = minimal_box();
  hull.stations[1].area = 20.0;  // triangle: T/3, exact
  hull.stations[2].breadth = 8.0;
  hull.stations[2].area = 0.5 * kPi * 16.0;  // semicircle of radius 4: 4 r / (3 pi)
  const auto sections = std::make_unique<ImmersedSections>();
  ASSERT_TRUE(immerse(hull, hull.loading, *sections).ok());
  EXPECT_NEAR((*sections)[1].centroid_z, -4.0 / 3.0, 1e-12);
  // Morrish's rule is an estimate: 0.4 % of the draught here.
  EXPECT_NEAR((*sections)[2].centroid_z, -16.0 / (3.0 * kPi), 0.005 * 4.0);
}

TEST(MinimalForm, SectionWithoutBreadthAtTheWaterlineIsABulb) {
  Hull hull = minimal_box();
  hull.stations[4].breadth = 0.0;
  hull.stations[4].area = 3.0;
  const auto sections = std::make_unique<ImmersedSections>();
  ASSERT_TRUE(immerse(hull, hull.loading, *sections).ok());
  EXPECT_EQ(sections->back().breadth, 0.0);
  // A parabola over the draught; as a polygon of 41 points it is symmetrical to 1e-4 of the draught.
  EXPECT_NEAR(sections->back().centroid_z, -2.0, 1e-3);
}

// What others take for granted of a contour, over every section that a file may hold.
TEST(MinimalForm, ContourHasTheGivenBreadthDraughtAndAreaForEveryShape) {
  const double draught = 8.0;
  for (const double h0 : {0.0, 1e-3, 0.05, 0.3, 0.9, 1.0, 1.34, 3.0, 10.0, 100.0}) {
    for (double sigma = 0.01; sigma < 4.0; sigma *= 1.03) {
      const double breadth = 2.0 * h0 * draught;
      const double area = (h0 > 0.0 ? breadth : 2.0) * draught * sigma;
      StaticVector<Offset, kMaxOffsets + 2> contour;
      minimal_contour(breadth, draught, area, contour);
      ASSERT_GE(contour.size(), 2U);
      EXPECT_EQ(contour.front().z, -draught) << h0 << ' ' << sigma;
      EXPECT_EQ(contour.back().z, 0.0);
      EXPECT_NEAR(contour.back().y, 0.5 * breadth, 1e-12 * breadth);
      double measured = 0.0;
      for (std::size_t i = 1; i < contour.size(); ++i) {
        EXPECT_GE(contour[i].y, 0.0);
        EXPECT_GE(contour[i].z, contour[i - 1].z);
        measured += (contour[i].z - contour[i - 1].z) * (contour[i].y + contour[i - 1].y);
      }
      EXPECT_NEAR(measured, area, 1e-9 * area) << h0 << ' ' << sigma;
    }
  }
}

TEST(MinimalForm, SectionInTheLewisRangeKeepsNearToItsLewisForm) {
  // H0 1, sigma pi/4: the semicircle. Morrish's centroid moves the contour by up to 1 % of the radius.
  StaticVector<Offset, kMaxOffsets + 2> contour;
  minimal_contour(2.0, 1.0, 0.5 * kPi, contour);
  for (const Offset& offset : contour) {
    EXPECT_NEAR(std::hypot(offset.y, offset.z), 1.0, 0.02);
  }
}

TEST(MinimalForm, S175StandsUprightWithinSixCentimetresOfGm) {
  const auto hull = std::make_unique<Hull>(test::s175());
  const auto sections = std::make_unique<ImmersedSections>();
  ASSERT_TRUE(immerse(*hull, hull->loading, *sections).ok());
  const auto exact = hydrostatics(*hull, hull->loading, *sections);
  for (std::size_t i = 0; i < hull->stations.size(); ++i) {
    Station& station = hull->stations[i];
    station.offsets.clear();
    station.breadth = (*sections)[i].breadth;
    station.draught = (*sections)[i].draught;
    station.area = (*sections)[i].area;
  }
  ASSERT_TRUE(immerse(*hull, hull->loading, *sections).ok());
  const auto minimal = hydrostatics(*hull, hull->loading, *sections);
  ASSERT_TRUE(exact.ok() && minimal.ok());
  EXPECT_NEAR(minimal->volume, exact->volume, 1e-9 * exact->volume);
  EXPECT_NEAR(minimal->bm, exact->bm, 1e-9);
  // The centroids are guessed: the afterbody is finer at the waterline than any rule of three figures knows.
  EXPECT_NEAR(minimal->gm, exact->gm, 0.06);
}

TEST(MinimalForm, MissingOrNegativeFiguresAreRefused) {
  for (double Station::*field : {&Station::draught, &Station::area}) {
    Hull hull = minimal_box();
    hull.stations[1].*field = 0.0;
    EXPECT_EQ(error_of(hull, hull.loading), Error::kOutOfRange);
  }
  Hull hull = minimal_box();
  hull.stations[1].breadth = -1.0;
  EXPECT_EQ(error_of(hull, hull.loading), Error::kOutOfRange);
}

}  // namespace
}  // namespace quickstrip
