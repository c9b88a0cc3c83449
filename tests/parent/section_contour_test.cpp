// What is a contour of a section and what is refused, in words that a user can act on.
#include "sim/parent/section_contour.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "msgs/files/hull_file.hpp"

namespace quickstrip {
namespace {

using Points = std::vector<Offset>;

std::string refusal(const Points& points) {
  try {
    static_cast<void>(section_contour(points));
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

TEST(SectionContour, KeepsABoxAndGivesItsAreaOfBothSides) {
  const SectionContour box = section_contour(Points{{0, -2}, {3, -2}, {3, 0}});
  EXPECT_EQ(box.points.size(), 3U);
  EXPECT_DOUBLE_EQ(area(box), 12.0);
  EXPECT_DOUBLE_EQ(box.half_breadth(), 3.0);
  EXPECT_DOUBLE_EQ(box.draught(), 2.0);
  EXPECT_FALSE(box.is_submerged());
}

TEST(SectionContour, TakesTunnelledReentrantAndSubmergedForms) {
  EXPECT_DOUBLE_EQ(area(section_contour(Points{{0, -1}, {1, -2}, {3, -2}, {3, 0}})), 11.0);
  EXPECT_FALSE(section_contour(Points{{0, -4}, {2, -3}, {0.5, -2}, {2, 0}}).is_submerged());
  const SectionContour bulb = section_contour(Points{{0, -4}, {1, -3}, {0, -2}});
  EXPECT_TRUE(bulb.is_submerged());
  EXPECT_DOUBLE_EQ(area(bulb), 2.0);
  EXPECT_EQ(bulb.half_breadth(), 0.0);
}

TEST(SectionContour, MakesOnePointOfPointsThatCoincide) {
  const SectionContour box = section_contour(Points{{0, -2}, {3, -2}, {3, -2}, {3, -1e-7}, {3, 0}});
  EXPECT_EQ(box.points.size(), 3U);
  EXPECT_EQ(box.points.back().z, 0.0);
}

TEST(SectionContour, RefusesFewerThanThreePoints) {
  EXPECT_EQ(refusal({{0, -2}, {3, 0}}), "a contour of fewer than three points");
  EXPECT_EQ(refusal({}), "a contour of fewer than three points");
  EXPECT_EQ(refusal({{0, -2}, {3, 0}, {3, 0}}), "a contour of fewer than three points that differ");
}

TEST(SectionContour, SaysBetweenWhichPointsAContourCrossesItself) {
  EXPECT_EQ(refusal({{0, -5}, {4, -4}, {4, -1}, {1, -3}, {1, -6}, {6, 0}}),
            "a contour that crosses itself between points 1-2 and 4-5");
  // Counted in the points given, where two of them coincide.
  EXPECT_EQ(refusal({{0, -5}, {0, -5}, {4, -4}, {4, -1}, {1, -3}, {1, -6}, {6, 0}}),
            "a contour that crosses itself between points 1-3 and 5-6");
  EXPECT_EQ(refusal({{0, -5}, {4, -4}, {2, -4.5}, {4, 0}}),
            "a contour that turns back upon itself at point 2");
}

TEST(SectionContour, RefusesWhatIsNotInTheWaterOnOneSide) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal({{0, -2}, {nan, -2}, {3, 0}}), "a contour whose point 2 is not finite");
  EXPECT_EQ(refusal({{0, -2}, {-1, -2}, {3, 0}}),
            "a contour that crosses the centre plane at point 2 (y < 0)");
  EXPECT_EQ(refusal({{0, -2}, {1, -2}, {3, 0.5}}), "a contour that leaves the water at point 3 (z > 0)");
  EXPECT_NE(refusal({{0, -2}, {1, 0}, {3, 0}}), "");
  EXPECT_NE(refusal({{0, -2}, {1, -1}, {0, -0.5}, {3, 0}}), "");
  EXPECT_NE(refusal({{1, -2}, {1, -1}, {3, 0}}), "");
  EXPECT_NE(refusal({{0, 0}, {1, -1}, {3, 0}}), "");
  EXPECT_NE(refusal({{0, -2}, {1, -1}, {3, -0.5}}), "");
  EXPECT_NE(refusal({{0, -2}, {1, -1}, {0, 0}}), "");
  EXPECT_NE(refusal({{0, -2}, {1, -3}, {0, -4}}), "");  // submerged, from the top downwards
}

ImmersedSection cut(const Points& points) {
  ImmersedSection section;
  for (const Offset& p : points) {
    EXPECT_TRUE(section.contour.push_back(p));
  }
  return section;
}

TEST(SectionContour, AddsTheFlatBottomOfACutStation) {
  const SectionContour box = section_contour(cut({{3, -2}, {3, 0}}));
  ASSERT_EQ(box.points.size(), 3U);
  EXPECT_EQ(box.points.front().y, 0.0);
  EXPECT_DOUBLE_EQ(area(box), 12.0);
}

TEST(SectionContour, DividesTheStraightFrameThatACutLeaves) {
  EXPECT_DOUBLE_EQ(area(section_contour(cut({{0, -2}, {3, 0}}))), 6.0);
}

TEST(SectionContour, EveryStationOfTheS175HasOneWithItsArea) {
  auto hull = std::make_unique<Hull>();
  ASSERT_TRUE(read_hull_file(QUICKSTRIP_SOURCE_DIR "/sim/hulls/s175.hull.toml", *hull));
  auto sections = std::make_unique<ImmersedSections>();
  ASSERT_TRUE(immerse(*hull, hull->loading, *sections));
  ASSERT_GT(sections->size(), 20U);
  for (const ImmersedSection& section : *sections) {
    EXPECT_NEAR(area(section_contour(section)), section.area, 1e-6 * section.area) << section.x;
  }
}

}  // namespace
}  // namespace quickstrip
