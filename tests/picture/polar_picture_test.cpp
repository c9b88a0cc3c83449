#include "sim/picture/polar_picture.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/constants.hpp"
#include "sim/picture/gnuplot.hpp"
#include "sim/picture/governing_regions.hpp"
#include "sim/picture/polar_geometry.hpp"
#include "sim/picture/polar_side_panel.hpp"

namespace quickstrip {
namespace {

/// 0 ... 4 kn, every 10 degrees, all good.
grid_t good_grid() {
  grid_t grid{};
  grid.num_speeds = 5;
  grid.num_headings = 36;
  for (int s = 0; s < grid.num_speeds; ++s) {
    grid.speed_kn[s] = static_cast<float>(s);
    for (int h = 0; h < grid.num_headings; ++h) {
      grid.verdict[s][h] = grid_t::VERDICT_GOOD;
      grid.governing[s][h] = 0;
    }
  }
  return grid;
}

TEST(PolarGeometry, BearingNinetyLiesToTheRight) {
  const PlanePoint east = at_bearing(90.0, 10.0);
  EXPECT_NEAR(east.x, 10.0, 1e-12);  // rounding of sin and cos
  EXPECT_NEAR(east.y, 0.0, 1e-12);
}

TEST(PolarGeometry, TheCellsCoverTheDiscWithoutOverlap) {
  const grid_t grid = good_grid();
  double area = 0.0;
  for (int s = 0; s < grid.num_speeds; ++s) {
    area += grid.num_headings * cell_area(grid, s);
  }
  EXPECT_NEAR(area, kPi * 4.5 * 4.5, 1e-9);  // rounding
}

TEST(PolarGeometry, TheShipsBowPointsWhereSheHeads) {
  const std::vector<PlanePoint> outline = ship_outline({0.0, 0.0}, 90.0, 2.0);
  EXPECT_GT(outline.front().x, 1.0);  // the first point is the bow
  EXPECT_NEAR(outline.front().y, 0.0, 1e-12);
}

TEST(PolarGeometry, TheArrowOfAWaveFromNorthPointsSouth) {
  const std::vector<PlanePoint> arrow = inward_arrow(0.0, 10.0, 5.0, 1.0);
  double lowest = 1e9;
  PlanePoint tip;
  for (const PlanePoint p : arrow) {
    if (p.y < lowest) {
      lowest = p.y;
      tip = p;
    }
  }
  EXPECT_NEAR(tip.y, 5.0, 1e-12);
  EXPECT_NEAR(tip.x, 0.0, 1e-12);
}

TEST(GoverningRegions, ARegionAcrossNorthIsOneRegion) {
  grid_t grid = good_grid();
  for (const int h : {34, 35, 0, 1, 2}) {
    grid.verdict[4][h] = grid_t::VERDICT_EXCEEDED;
    grid.governing[4][h] = 3;
  }
  const std::vector<GoverningRegion> regions = governing_regions(grid);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].criterion, 3);
  EXPECT_EQ(regions[0].speed, 4);
  EXPECT_EQ(regions[0].heading, 0);  // the middle of 34 ... 2
}

TEST(GoverningRegions, GoodCellsNeedNoReason) {
  EXPECT_TRUE(governing_regions(good_grid()).empty());
}

TEST(GoverningRegions, CriteriaOfOneQuantityAreNumbered) {
  limits_t limits{};
  limits.num_criteria = 3;
  limits.quantity[0] = 3;  // roll
  limits.quantity[1] = 8;  // vertical acceleration, twice
  limits.quantity[2] = 8;
  EXPECT_EQ(criterion_letters(limits), (std::vector<std::string>{"R", "V1", "V2"}));
}

TEST(SidePanel, QuotesInTextAreDoubledForGnuplot) {
  EXPECT_EQ(quoted("master's"), "'master''s'");
}

TEST(SidePanel, WordsAreWrappedAndALastLineThatIsCutSaysSo) {
  EXPECT_EQ(wrapped("come to port now", 8, 5), "come to\nport now");
  EXPECT_EQ(wrapped("come to port now", 8, 1), "come to …");
}

TEST(PolarPicture, GnuplotDrawsAPngAndLeavesNothingElse) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("quickstrip_polar_" + std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  PolarPicture picture;
  picture.time = "2019-09-04 12:40 UTC";
  picture.hs_m = 3.0;
  picture.waves = {{3.0, 9.0, 45.0}};
  picture.grid = good_grid();
  picture.advice.verdict = advice_t::VERDICT_GOOD;
  const std::string png = folder / "polar.png";
  const FileStatus status =
      draw_with_gnuplot([&](const std::string& file) { return polar_script(picture, file); }, png);
  ASSERT_TRUE(status.ok()) << status.line();
  std::ifstream file(png, std::ios::binary);
  std::string head(24, '\0');
  file.read(head.data(), 24);
  EXPECT_EQ(head.substr(1, 3), "PNG");
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(head[i]); };
  EXPECT_EQ(byte(18) * 256 + byte(19), 1600);  // width, big-endian, of the IHDR chunk
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST(PolarPicture, WithoutAGridThePictureSaysWhyThereIsNoAdvice) {
  PolarPicture picture;
  picture.advice.no_advice = 3;
  const std::string why = "No advice, because the sea state is stale.";
  std::copy(why.begin(), why.end(), picture.advice.no_advice_text);
  EXPECT_NE(polar_script(picture, "x.png").find("because the sea state is"), std::string::npos);
}

}  // namespace
}  // namespace quickstrip
