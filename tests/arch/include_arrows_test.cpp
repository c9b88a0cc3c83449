// The arrows between rooms, on the tree as it is; and that a planted wrong arrow is found.
#include <gtest/gtest.h>

#include "tests/arch/include_rules.hpp"
#include "tests/arch/source_tree.hpp"

namespace quickstrip::arch {
namespace {

bool refuses(const std::string& path, const std::string& include) {
  return !forbidden_includes(path, "#include " + include + "\n").empty();
}

TEST(IncludeArrows, EveryFileIncludesOnlyItsOwnRoomAndRoomsToItsLeft) {
  const auto files = source_files({"core", "msgs", "firmware", "sim", "tests"}, {".cpp", ".hpp", ".c", ".h"});
  ASSERT_GT(files.size(), 20U);
  for (const SourceFile& file : files) {
    for (const std::string& line : forbidden_includes(file.path, file.text)) {
      ADD_FAILURE() << line;
    }
  }
}

TEST(IncludeArrows, RefusesAnArrowToTheRightInsideCore) {
  EXPECT_TRUE(refuses("core/sea/spectrum.cpp", "\"core/hull/hull.hpp\""));
  EXPECT_TRUE(refuses("core/hull/hull.cpp", "\"core/strip/section_table.hpp\""));
  EXPECT_TRUE(refuses("core/hazard/zones.cpp", "\"core/advice/grid.hpp\""));
  EXPECT_TRUE(refuses("core/advice/grid.cpp", "\"core/advisor.hpp\""));
  EXPECT_FALSE(refuses("core/strip/wave_loads.cpp", "\"core/hull/hull.hpp\""));
  EXPECT_FALSE(refuses("core/advisor.cpp", "\"core/advice/grid.hpp\""));
}

TEST(IncludeArrows, RefusesTheWorldOutsideCoreInCore) {
  EXPECT_TRUE(refuses("core/advisor.cpp", "\"msgs/convert/units.hpp\""));
  EXPECT_TRUE(refuses("core/advisor.cpp", "<lcm/lcm-cpp.hpp>"));
  EXPECT_TRUE(refuses("core/advisor.cpp", "\"quickstrip/sea_state_t.hpp\""));
  for (const char* header : {"<vector>", "<string>", "<functional>", "<iostream>", "<chrono>", "<thread>",
                             "<fstream>", "<cstdio>", "<memory>", "<map>", "<mutex>", "<random>"}) {
    EXPECT_TRUE(refuses("core/advisor.cpp", header)) << header;
  }
  EXPECT_FALSE(refuses("core/advisor.cpp", "<array>"));
}

TEST(IncludeArrows, LetsEigenInThroughOneDoor) {
  EXPECT_TRUE(refuses("core/strip/motions.cpp", "<Eigen/Core>"));
  EXPECT_FALSE(refuses("core/base/eigen.hpp", "<Eigen/Core>"));
}

TEST(IncludeArrows, KeepsTheOuterRoomsInOrder) {
  EXPECT_TRUE(refuses("msgs/convert/sea.cpp", "\"firmware/session/session.hpp\""));
  EXPECT_TRUE(refuses("firmware/advisor/main.cpp", "\"sim/seaway/seaway.hpp\""));
  EXPECT_TRUE(refuses("sim/replay/replay.cpp", "\"firmware/advisor/bus.hpp\""));
  EXPECT_FALSE(refuses("sim/replay/replay.cpp", "\"firmware/session/session.hpp\""));
  EXPECT_TRUE(refuses("sim/replay/replay.cpp", "\"tests/support/hulls.hpp\""));
  EXPECT_TRUE(refuses("firmware/session/session.cpp", "<lcm/lcm-cpp.hpp>"));
  EXPECT_TRUE(refuses("firmware/advisor/main.cpp", "<toml++/toml.h>"));
}

TEST(IncludeArrows, KeepsTheTableGeneratorAwayFromWhatUsesTheTable) {
  EXPECT_TRUE(refuses("sim/section_table/multipoles.cpp", "\"core/strip/section_table.hpp\""));
  EXPECT_TRUE(refuses("sim/section_table/multipoles.cpp", "\"core/sea/dispersion.hpp\""));
  EXPECT_FALSE(refuses("sim/section_table/multipoles.cpp", "\"core/hull/lewis_section.hpp\""));
}

TEST(IncludeArrows, RefusesAnIncludeThatDoesNotStartAtTheRoot) {
  EXPECT_TRUE(refuses("core/sea/spectrum.cpp", "\"spectrum.hpp\""));
  EXPECT_TRUE(refuses("firmware/nmea/sentence.cpp", "\"sentence.hpp\""));
}

}  // namespace
}  // namespace quickstrip::arch
