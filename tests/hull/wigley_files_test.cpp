// The Wigley hull files that the project ships against the formula that they quote.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "core/hull/hydrostatics.hpp"
#include "msgs/files/hull_file.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

std::string path_of(int which) {
  const char* const names[] = {"", "i", "ii", "iii", "iv"};
  return std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/wigley_" + names[which] + ".hull.toml";
}

TEST(WigleyFiles, HoldTheFormulaToTheirSixDecimals) {
  const auto hull = std::make_unique<Hull>();
  for (int which = 1; which <= 4; ++which) {
    const FileStatus status = read_hull_file(path_of(which), *hull);
    ASSERT_TRUE(status.ok()) << status.line();
    ASSERT_EQ(hull->stations.size(), 41U);
    for (const Station& station : hull->stations) {
      for (const Offset& offset : station.offsets) {
        const double depth = std::max(0.0, 0.1875 - offset.z);  // wall-sided above the waterline
        const double y = test::wigley_half_breadth(which, station.x - 1.5, depth);
        // y to half of the sixth decimal; z as well, times a slope dy/dz of up to 5 B/d at the keel of I and
        // II.
        EXPECT_NEAR(offset.y, y, 0.5e-6 * (1.0 + 5.0 * hull->breadth / 0.1875) + 1e-12);
      }
    }
  }
}

TEST(WigleyFiles, FloatUprightAtTheVolumeOfTheReport) {
  const auto hull = std::make_unique<Hull>();
  const auto sections = std::make_unique<ImmersedSections>();
  int which = 0;
  for (const double volume : {0.0946, 0.1892, 0.0780, 0.1560}) {
    ASSERT_TRUE(read_hull_file(path_of(++which), *hull).ok());
    ASSERT_TRUE(immerse(*hull, hull->loading, *sections).ok());
    const auto h = hydrostatics(*hull, hull->loading, *sections);
    ASSERT_TRUE(h.ok());
    // Four printed decimals, 41 stations and 25 points by straight lines: 0.2 %.
    EXPECT_NEAR(h->volume, volume, 0.002 * volume);
  }
}

}  // namespace
}  // namespace quickstrip
