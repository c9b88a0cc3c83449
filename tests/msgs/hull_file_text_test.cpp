// The hull file written: what is read again is the ship that was written.
#include "msgs/files/hull_file_text.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "msgs/files/hull_file.hpp"
#include "msgs/files/text_file.hpp"

namespace quickstrip {
namespace {

// Every key that a hull file may have, none at its default, numbers that ten digits hold.
const std::string kWhole = R"(# of a test
schema = 1
name = "a \"box\" \\ of Åland"

[particulars]
lpp_m = 100.25
breadth_m = 20.0

[[station]]
x_m = 0.0
offsets_m = [
  [0.0, 0.125], [9.0, 10.0]
]

[[station]]
x_m = 50.0
breadth_m = 19.5
draught_m = 4.75
area_m2 = 80.5

[[station]]
x_m = 101.5
offsets_m = [
  [0.0, 0.0], [4.0, 0.0], [8.0, 12.0]
]

[loading]
draught_aft_m = 5.0
draught_fwd_m = 4.5
kg_m = 7.0
free_surface_correction_m = 0.25
gm_m = 1.5
roll_gyradius_m = 7.0
pitch_gyradius_m = 25.0
yaw_gyradius_m = 26.0
measured_roll_period_s = 11.5
water_density_kg_m3 = 1010.0
viscosity_m2_s = 1.1e-06
gravity_m_s2 = 9.81

[roll_damping]
method = "ratio"
ratio = 0.075
bilge_keel = { x_aft_m = 30.0, x_fwd_m = 70.0, breadth_m = 0.4 }

[[point]]
name = "wheelhouse"
role = "bridge"
x_m = 12.0
y_m = -1.5
z_m = 25.0

[[point]]
name = "stem"
role = "fp"
x_m = 100.0
y_m = 0.0
z_m = 13.0

[[point]]
name = "hatch"
role = "deck"
x_m = 60.0
y_m = 0.0
z_m = 11.0

[[point]]
name = "saloon"
role = "passengers"
x_m = 30.0
y_m = 0.0
z_m = 11.0

[[point]]
name = "mast"
role = "other"
x_m = 30.0
y_m = 0.0
z_m = 31.0

[[slamming]]
name = "forefoot"
x_m = 88.0

[[freeboard]]
name = "break of the deck"
x_m = 80.0
height_m = 9.0

[propeller]
x_m = 2.0
tip_z_m = 3.0

[handling]
min_steerage_kn = 2.5
turn_rate_deg_min = 24.0
slow_down_kn_min = 1.5
speed_up_kn_min = 0.4

[resistance]
speed_kn_force_n = [
  [4.0, 12000.5],
  [8.0, 50000.0],
  [13.5, 190000.0],
]

[grid]
speeds_kn = { from = 2.0, to = 14.0, step = 1.5 }
heading_step_deg = 10.0
)";

TEST(HullFileText, OfAFileWithEveryKeyIsThatFile) {
  const auto hull = std::make_unique<Hull>();
  const FileStatus status = parse_hull(kWhole, "whole", *hull);
  ASSERT_TRUE(status.ok()) << status.line();
  EXPECT_EQ(hull_file_text(*hull, "of a test"), kWhole);
}

TEST(HullFileText, KeepsTheMethodOfRollDamping) {
  const auto hull = std::make_unique<Hull>();
  const auto again = std::make_unique<Hull>();
  ASSERT_TRUE(parse_hull(kWhole, "whole", *hull).ok());
  hull->roll_damping.method = RollDampingMethod::kIkeda;
  for (const double ratio : {0.0, 0.01}) {
    hull->roll_damping.ratio = ratio;
    const FileStatus status = parse_hull(hull_file_text(*hull, ""), "again", *again);
    ASSERT_TRUE(status.ok()) << status.line();
    EXPECT_EQ(again->roll_damping.method, RollDampingMethod::kIkeda);
    EXPECT_EQ(again->roll_damping.ratio, ratio);
  }
}

TEST(HullFileText, OfEveryShipOfTheProjectIsReadAsTheSameShip) {
  const auto hull = std::make_unique<Hull>();
  const auto again = std::make_unique<Hull>();
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(QUICKSTRIP_SOURCE_DIR "/sim/hulls")) {
    ASSERT_TRUE(read_hull_file(entry.path(), *hull).ok());
    const std::string text = hull_file_text(*hull, "two\nlines");
    EXPECT_EQ(text.rfind("# two\n# lines\nschema = 1\n", 0), 0u);
    const FileStatus status = parse_hull(text, "again", *again);
    ASSERT_TRUE(status.ok()) << status.line();
    ASSERT_EQ(again->stations.size(), hull->stations.size());
    for (std::size_t i = 0; i < hull->stations.size(); ++i) {
      EXPECT_EQ(again->stations[i].x, hull->stations[i].x);
      EXPECT_EQ(again->stations[i].area, hull->stations[i].area);
      ASSERT_EQ(again->stations[i].offsets.size(), hull->stations[i].offsets.size());
      for (std::size_t k = 0; k < hull->stations[i].offsets.size(); ++k) {
        EXPECT_EQ(again->stations[i].offsets[k].y, hull->stations[i].offsets[k].y);
        EXPECT_EQ(again->stations[i].offsets[k].z, hull->stations[i].offsets[k].z);
      }
    }
    EXPECT_EQ(again->loading, hull->loading);
    EXPECT_EQ(hull_file_text(*again, ""), hull_file_text(*hull, ""));
    ++count;
  }
  EXPECT_GE(count, 7);
}

TEST(TextFile, IsWrittenWholeOrNotAtAll) {
  const auto folder = std::filesystem::temp_directory_path() / ("qs_text_" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  EXPECT_TRUE(write_text_file("one", folder / "file").ok());
  EXPECT_TRUE(write_text_file("two", folder / "file").ok());
  EXPECT_EQ(read_text_file(folder / "file", 100), "two");
  EXPECT_EQ(write_text_file("three", folder / "none" / "file").line(),
            (folder / "none" / "file").string() + ": cannot be written");
  EXPECT_EQ(write_text_file("three", folder).line(),
            folder.string() + ": a folder: the name of a file is wanted");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace quickstrip
