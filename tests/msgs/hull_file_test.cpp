#include "msgs/files/hull_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "msgs/convert/units.hpp"
#include "msgs/files/toml_table.hpp"

namespace quickstrip {
namespace {

const std::string kHulls = std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/";

// A small ship with everything given; tests change one line of it.
const std::string kShip = R"(schema = 1
name = "box"
[particulars]
lpp_m = 100.0
breadth_m = 20.0
[[station]]
x_m = 100.0
offsets_m = [[0.0, 0.0], [4.0, 0.0], [8.0, 12.0]]
[[station]]
x_m = 0.0
offsets_m = [[0.0, 0.0], [9.0, 10.0]]
[[station]]
x_m = 50.0
offsets_m = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]]
[loading]
draught_aft_m = 5.0
draught_fwd_m = 4.5
kg_m = 7.0
roll_gyradius_m = 7.0
pitch_gyradius_m = 25.0
yaw_gyradius_m = 25.0
[roll_damping]
method = "ratio"
ratio = 0.05
)";

std::string with(std::string from, const std::string& to) {
  std::string text = kShip;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// The one line of refusal; "" when the text is accepted.
std::string refusal(const std::string& text) {
  static Hull hull;
  return parse_hull(text, "ship.hull.toml", hull).line();
}

void expect_refused(const std::string& text, std::initializer_list<const char*> words) {
  const std::string line = refusal(text);
  EXPECT_EQ(line.rfind("ship.hull.toml: ", 0), 0u) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  for (const char* word : words) {
    EXPECT_NE(line.find(word), std::string::npos) << "wanted '" << word << "' in: " << line;
  }
}

TEST(HullFile, S175HasItsTwentyFourStationsAndWhatIsWatched) {
  static Hull hull;
  const FileStatus status = read_hull_file(kHulls + "s175.hull.toml", hull);
  ASSERT_TRUE(status.ok()) << status.line();
  EXPECT_EQ(hull.name.view(), "S-175 container ship");
  ASSERT_EQ(hull.stations.size(), 24u);
  EXPECT_DOUBLE_EQ(hull.stations.front().x, -1.6625);
  EXPECT_DOUBLE_EQ(hull.stations.back().x, 175.0);
  EXPECT_DOUBLE_EQ(hull.loading.kg, 9.55);
  ASSERT_TRUE(hull.loading.free_surface_correction.has_value());
  ASSERT_EQ(hull.points.size(), 2u);
  EXPECT_EQ(hull.points[0].role, PointRole::kBridge);
  EXPECT_EQ(hull.points[1].role, PointRole::kForwardPerpendicular);
  EXPECT_DOUBLE_EQ(hull.freeboard[0].height, 16.0);
  EXPECT_NEAR(hull.grid.speed_to, 24.0 * 0.514444, 1e-4);  // 0.514444 is rounded
  EXPECT_NEAR(hull.grid.heading_step, 0.0872665, 1e-7);    // likewise
}

// Displacement 24,616 t of the ITTC ship at 9.5 m, sections by trapezoids in z, ship by trapezoids in x; the
// published figure is 24,610 t (ShipX VERES): 0.1 % for the quadrature.
TEST(HullFile, S175OffsetsGiveItsPublishedDisplacement) {
  static Hull hull;
  ASSERT_TRUE(read_hull_file(kHulls + "s175.hull.toml", hull).ok());
  const auto area = [](const Station& station, double draught) {
    double sum = 0.0;
    for (std::size_t i = 1; i < station.offsets.size(); ++i) {
      const Offset& a = station.offsets[i - 1];
      const Offset& b = station.offsets[i];
      const double z = std::min(b.z, draught);
      if (b.z > a.z && z > a.z) {
        const double y = a.y + (b.y - a.y) * (z - a.z) / (b.z - a.z);
        sum += (a.y + y) * (z - a.z);
      }
    }
    return sum;
  };
  double volume = 0.0;
  for (std::size_t i = 1; i < hull.stations.size(); ++i) {
    volume += 0.5 * (area(hull.stations[i - 1], 9.5) + area(hull.stations[i], 9.5)) *
              (hull.stations[i].x - hull.stations[i - 1].x);
  }
  EXPECT_NEAR(volume * 1.025, 24610.0, 0.001 * 24610.0);
}

TEST(HullFile, MinimalFormHasBreadthDraughtAndAreaAndNoOffsets) {
  static Hull hull;
  for (const char* file : {"s175_minimal.hull.toml", "shortest.hull.toml"}) {
    const FileStatus status = read_hull_file(kHulls + file, hull);
    ASSERT_TRUE(status.ok()) << status.line();
    double volume = 0.0;
    for (std::size_t i = 0; i < hull.stations.size(); ++i) {
      const Station& station = hull.stations[i];
      EXPECT_TRUE(station.is_minimal());
      EXPECT_GT(station.area, 0.0);
      if (i > 0) {
        volume += 0.5 * (station.area + hull.stations[i - 1].area) * (station.x - hull.stations[i - 1].x);
      }
    }
    EXPECT_NEAR(volume * 1.025, 24610.0, 0.01 * 24610.0) << file;  // thirteen sections: 1 %
  }
  // The last one read gives no freeboard: without offsets no deck edge is known.
  EXPECT_TRUE(hull.freeboard.empty());
  ASSERT_EQ(hull.slamming.size(), 1u);
  EXPECT_DOUBLE_EQ(hull.slamming[0].x, 157.5);
  EXPECT_FALSE(hull.loading.free_surface_correction.has_value());
  ASSERT_EQ(hull.points.size(), 1u);
}

TEST(HullFile, StationsComeOutInOrderOfX) {
  static Hull hull;
  ASSERT_TRUE(parse_hull(kShip, "ship", hull).ok());
  ASSERT_EQ(hull.stations.size(), 3u);
  EXPECT_EQ(hull.stations[0].x, 0.0);
  EXPECT_EQ(hull.stations[1].x, 50.0);
  EXPECT_EQ(hull.stations[2].x, 100.0);
  EXPECT_EQ(hull.stations[2].offsets.size(), 3u);  // the flat bottom's equal heights are kept
}

TEST(HullFile, WhatIsLeftOutHasTheDocumentedDefaults) {
  static Hull hull;
  ASSERT_TRUE(parse_hull(kShip, "ship", hull).ok());
  ASSERT_EQ(hull.slamming.size(), 1u);
  EXPECT_DOUBLE_EQ(hull.slamming[0].x, 90.0);
  EXPECT_FALSE(hull.slamming[0].threshold_velocity.has_value());
  ASSERT_EQ(hull.freeboard.size(), 1u);
  EXPECT_EQ(hull.freeboard[0].name.view(), "bow");
  EXPECT_DOUBLE_EQ(hull.freeboard[0].x, 100.0);
  EXPECT_DOUBLE_EQ(hull.freeboard[0].height, 12.0);
  ASSERT_EQ(hull.points.size(), 1u);
  EXPECT_EQ(hull.points[0].role, PointRole::kForwardPerpendicular);
  EXPECT_DOUBLE_EQ(hull.points[0].x, 100.0);
  EXPECT_DOUBLE_EQ(hull.points[0].z, 12.0);
  EXPECT_DOUBLE_EQ(hull.min_steerage_speed, from_knots(3.0));
  EXPECT_DOUBLE_EQ(hull.grid.speed_to, from_knots(24.0));
  EXPECT_DOUBLE_EQ(hull.loading.water_density, 1025.0);
  EXPECT_FALSE(hull.loading.gm.has_value());
  EXPECT_FALSE(hull.loading.measured_roll_period.has_value());
  EXPECT_FALSE(hull.propeller.has_value());
}

TEST(HullFile, UnknownKeyIsRefusedNamingTheNearestOne) {
  expect_refused(with("kg_m = 7.0", "kg_m = 7.0\nroll_gyradius = 7.0"),
                 {"loading.roll_gyradius = 7.0", "roll_gyradius_m"});
  expect_refused(with("name = \"box\"", "name = \"box\"\nshema = 1"), {"shema = 1", "schema"});
  expect_refused(with("ratio = 0.05", "ratio = 0.05\n[[freebord]]\nx_m = 1.0"), {"freebord", "freeboard"});
}

TEST(HullFile, MissingKeyIsRefusedByName) {
  expect_refused(with("kg_m = 7.0\n", ""), {"loading.kg_m", "missing", "a number from"});
  expect_refused(with("x_m = 50.0\n", ""), {"station[3].x_m", "missing"});
  expect_refused(with("schema = 1\n", ""), {"schema", "missing"});
  expect_refused(with("[roll_damping]\nmethod = \"ratio\"\nratio = 0.05\n", ""), {"roll_damping", "missing"});
}

TEST(HullFile, WrongTypeIsRefusedWithTheLine) {
  expect_refused(with("kg_m = 7.0", "kg_m = \"7.0\""), {"loading.kg_m = \"7.0\"", "a number", "(line 18)"});
  expect_refused(with("name = \"box\"", "name = 5"), {"name = 5", "text"});
  expect_refused(with("x_m = 50.0", "x_m = true"), {"station[3].x_m = true", "a number"});
}

TEST(HullFile, NumbersThatAreNotFiniteAreRefused) {
  for (const char* value : {"nan", "inf", "-inf"}) {
    expect_refused(with("kg_m = 7.0", std::string("kg_m = ") + value), {"loading.kg_m", value});
    expect_refused(with("[9.0, 10.0]", std::string("[9.0, ") + value + "]"), {"station[2].offsets_m[2][2]"});
  }
}

TEST(HullFile, BadSyntaxIsRefusedWithTheLine) {
  expect_refused(with("kg_m = 7.0", "kg_m = = 7.0"), {"line 18"});
}

TEST(HullFile, SwappedValuesAreRefused) {
  expect_refused(with("draught_aft_m = 5.0", "draught_aft_m = 12.5"),
                 {"loading.draught_aft_m = 12.5", "highest offset", "12"});
  expect_refused(with("lpp_m = 100.0\nbreadth_m = 20.0", "lpp_m = 20.0\nbreadth_m = 100.0"),
                 {"particulars.breadth_m", "swapped"});
  expect_refused(with("roll_gyradius_m = 7.0", "roll_gyradius_m = 25.0"),
                 {"loading.roll_gyradius_m = 25.0", "from 3 to 15 m"});
  expect_refused(with("[4.0, 0.0], [8.0, 12.0]", "[8.0, 12.0], [4.0, 0.0]"),
                 {"station[1].offsets_m[3]", "keel to deck"});
  expect_refused(with("[9.0, 10.0]", "[18.0, 10.0]"), {"station[2].offsets_m[2][1]", "half-breadth"});
}

TEST(HullFile, PlacesFarOutsideTheShipAreRefused) {
  expect_refused(with("x_m = 50.0", "x_m = 121.0"), {"station[3].x_m = 121.0", "from -20 to 120 m"});
  expect_refused(kShip + "[[slamming]]\nname = \"bow\"\nx_m = 900.0\n", {"slamming[1].x_m = 900.0"});
}

TEST(HullFile, StationsAtTheSamePlaceAreRefused) {
  expect_refused(with("x_m = 50.0", "x_m = 100.0"), {"station[3].x_m = 100.0", "station[1]"});
}

TEST(HullFile, LongOrRepeatedNamesAreRefused) {
  const std::string point = "[[point]]\nrole = \"deck\"\nx_m = 1.0\nz_m = 12.0\nname = ";
  EXPECT_EQ(refusal(kShip + point + "\"0123456789012345678901234567890\"\n"), "");  // 31 bytes
  expect_refused(kShip + point + "\"01234567890123456789012345678901\"\n", {"point[1].name", "31"});
  expect_refused(kShip + point + "\"a\"\n" + point + "\"a\"\n", {"point[2].name = \"a\"", "of its own"});
}

TEST(HullFile, MoreThanFitsIsRefusedByName) {
  std::string text = kShip;
  for (int i = 0; i < 62; ++i) {
    text += "[[station]]\nx_m = " + std::to_string(1 + i % 49) + "." + std::to_string(i) +
            "\noffsets_m = [[0.0, 0.0], [9.0, 10.0]]\n";
  }
  expect_refused(text, {"station", "65", "64"});
  std::string points = kShip;
  for (int i = 0; i < 16; ++i) {
    points += "[[point]]\nrole = \"deck\"\nx_m = 1.0\nz_m = 12.0\nname = \"p" + std::to_string(i) + "\"\n";
  }
  expect_refused(points, {"point", "16", "fp"});
}

TEST(HullFile, UnknownRoleIsRefusedNamingThoseThereAre) {
  expect_refused(kShip + "[[point]]\nname = \"a\"\nrole = \"bow\"\nx_m = 1.0\nz_m = 1.0\n",
                 {"point[1].role = \"bow\"", "\"bridge\"", "\"fp\""});
}

TEST(HullFile, IkedaIsTakenWithOrWithoutARatioAndABilgeKeel) {
  Hull hull;
  const std::string keel = "bilge_keel = { x_aft_m = 15.0, x_fwd_m = 35.0, breadth_m = 0.3 }";
  const std::string bare = with("method = \"ratio\"\nratio = 0.05", "method = \"ikeda\"");
  ASSERT_TRUE(parse_hull(bare, "ship.hull.toml", hull).ok());
  EXPECT_EQ(hull.roll_damping.method, RollDampingMethod::kIkeda);
  EXPECT_FALSE(hull.roll_damping.bilge_keel);
  const std::string both =
      with("method = \"ratio\"\nratio = 0.05", "method = \"ikeda\"\nratio = 0.05\n" + keel);
  ASSERT_TRUE(parse_hull(both, "ship.hull.toml", hull).ok());
  EXPECT_EQ(hull.roll_damping.method, RollDampingMethod::kIkeda);
  ASSERT_TRUE(hull.roll_damping.bilge_keel);
  EXPECT_DOUBLE_EQ(hull.roll_damping.bilge_keel->x_fwd, 35.0);
}

TEST(HullFile, StabilisersAreARatioAtASpeed) {
  Hull hull;
  const std::string with_fins =
      with("ratio = 0.05", "ratio = 0.05\nstabiliser = { ratio = 0.2, speed_kn = 18.0 }");
  ASSERT_TRUE(parse_hull(with_fins, "ship.hull.toml", hull).ok());
  ASSERT_TRUE(hull.roll_damping.stabiliser);
  EXPECT_DOUBLE_EQ(hull.roll_damping.stabiliser->ratio, 0.2);
  EXPECT_DOUBLE_EQ(hull.roll_damping.stabiliser->speed, from_knots(18.0));
  expect_refused(with("ratio = 0.05", "ratio = 0.05\nstabiliser = { ratio = 2.0, speed_kn = 18.0 }"),
                 {"roll_damping.stabiliser.ratio = 2"});
  expect_refused(with("ratio = 0.05", "ratio = 0.05\nstabiliser = { ratio = 0.2 }"),
                 {"roll_damping.stabiliser.speed_kn"});
}

TEST(HullFile, GridMustFitItsCapacityAndTheDirections) {
  const std::string speeds = "[grid]\nspeeds_kn = { from = 0.0, to = ";
  expect_refused(kShip + speeds + "25.0, step = 1.0 }\n", {"grid.speeds_kn.step", "25", "26"});
  expect_refused(kShip + speeds + "24.0, step = 5.0 }\n", {"grid.speeds_kn.step", "divides 24"});
  EXPECT_EQ(refusal(kShip + speeds + "2.4, step = 0.1 }\n"), "");  // 0.1 has no exact binary form
  expect_refused(kShip + "[grid]\nheading_step_deg = 25.0\n", {"grid.heading_step_deg = 25.0", "360"});
  expect_refused(kShip + "[grid]\nheading_step_deg = 7.5\n",
                 {"grid.heading_step_deg = 7.5", "multiple of 5"});
}

TEST(HullFile, BothFormsOfAStationAtOnceAreRefused) {
  expect_refused(with("x_m = 50.0", "x_m = 50.0\narea_m2 = 80.0"), {"station[3].area_m2 = 80.0", "not both"});
}

TEST(HullFile, ARefusedFileLeavesTheHullAsItWas) {
  static Hull hull;
  ASSERT_TRUE(parse_hull(kShip, "ship", hull).ok());
  ASSERT_FALSE(parse_hull(with("ratio = 0.05", "ratio = 5.0"), "ship", hull).ok());
  EXPECT_EQ(hull.name.view(), "box");
  EXPECT_EQ(hull.stations.size(), 3u);
}

TEST(HullFile, AFileThatIsNotThereIsNamed) {
  static Hull hull;
  EXPECT_EQ(read_hull_file("no/such.hull.toml", hull).line(), "no/such.hull.toml: no such file");
}

TEST(EditDistance, KittenToSittingIsThree) {  // the textbook's example
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("kg_m", "kg_m"), 0u);
}

}  // namespace
}  // namespace quickstrip
