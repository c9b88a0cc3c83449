// Stations given by breadth, draught and area [Journee1992] §4: one draught, and what is known of them.
#include <gtest/gtest.h>

#include <memory>

#include "core/hull/hydrostatics.hpp"
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
  EXPECT_NEAR(sections->back().centroid_z, -2.0, 1e-12);
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
