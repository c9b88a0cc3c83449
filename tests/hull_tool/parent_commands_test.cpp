// parent, validate and times: what they print.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "msgs/cli/run_tool.hpp"
#include "sim/hull_tool/commands.hpp"

namespace quickstrip {
namespace {

const std::string kHulls = std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/";

using Line = std::vector<std::string>;

/// The lines of what a command prints, the header first; none of these prints quoted fields.
std::vector<Line> printed(void (*add)(CLI::App&), const std::string& arguments) {
  CLI::App app;
  add(app);
  testing::internal::CaptureStdout();
  try {
    app.parse(arguments);
  } catch (...) {
    testing::internal::GetCapturedStdout();
    throw;
  }
  std::istringstream text(testing::internal::GetCapturedStdout());
  std::vector<Line> out;
  for (std::string line; std::getline(text, line);) {
    std::istringstream fields(line);
    out.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) {
      out.back().push_back(field);
    }
  }
  return out;
}

TEST(ParentCommand, PrintsTheColumnsOfMotionsAndNeedsNoTableForBoundaryValues) {
  const std::string waves = kHulls + "s175.hull.toml --speed-kn 0,15 --mu-deg 120 --omega 0.4,0.6";
  const auto motions = printed(hull_tool::add_motions, "motions " + waves);
  const auto parent = printed(hull_tool::add_parent, "parent " + waves + " --loads boundary-value");
  ASSERT_EQ(parent.size(), 5u);
  EXPECT_EQ(parent[0], motions[0]);
  for (std::size_t row = 1; row < parent.size(); ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      EXPECT_EQ(parent[row][column], motions[row][column]);
    }
    // Heave: Lewis forms and Haskind's correction against true sections and boundary values.
    EXPECT_NEAR(std::stod(parent[row][8]) / std::stod(motions[row][8]), 1.0, 0.05);
  }
}

// The contours of a minimal form are Lewis forms, which the close fit gives back.
TEST(ParentCommand, TakesAHullOfMinimalForm) {
  const std::string wave =
      kHulls + "s175_minimal.hull.toml --speed-kn 0 --mu-deg 90 --omega 0.5 --loads classic";
  const auto motions = printed(hull_tool::add_motions, "motions " + wave);
  const auto parent = printed(hull_tool::add_parent, "parent " + wave);
  EXPECT_NEAR(std::stod(parent[1][6]) / std::stod(motions[1][6]), 1.0, 0.02);
}

TEST(ParentCommand, RefusesWhatDoesNotFloatWithItsReason) {
  EXPECT_THROW(printed(hull_tool::add_parent,
                       "parent " + kHulls + "s175.hull.toml --kg-m 12 --speed-kn 0 --mu-deg 90 --omega 0.5"),
               InputError);
}

// The paper: "very high accuracy". Lewis forms on the S-175 in her sea of Beaufort 8.
TEST(ValidateCommand, FindsTheProgramOnBoardCloseToTheParentInThePapersSetting) {
  const auto rows = printed(hull_tool::add_validate, "validate " + kHulls +
                                                         "s175.hull.toml --paper --speed-kn 16.1 --spectrum "
                                                         "bretschneider --hs-m 4.9 --t1-s 8.4");
  const std::map<std::string, double> most_percent = {{"longitudinal_acceleration", 1.0},
                                                      {"lateral_acceleration", 1.5},
                                                      {"vertical_acceleration", 1.5},
                                                      {"added_resistance", 3.0},
                                                      {"relative_motion_rms", 1.0}};
  ASSERT_EQ(rows.size(), 10u);
  std::size_t found = 0;
  for (const Line& row : rows) {
    if (const auto most = most_percent.find(row[4]); most != most_percent.end()) {
      EXPECT_LT(std::abs(std::stod(row[8])), most->second) << row[4];
      ++found;
    }
  }
  EXPECT_EQ(found, most_percent.size());
}

TEST(ValidateCommand, WantsAPeriodForEachHeight) {
  EXPECT_THROW(printed(hull_tool::add_validate,
                       "validate " + kHulls +
                           "s175.hull.toml --speed-kn 16 --spectrum bretschneider --hs-m 4,5 --t1-s 8"),
               CLI::ValidationError);
}

// The paper's 10 %; measured 0.2 % on one core, and any load of the machine falls on both.
TEST(TimesCommand, TheProgramOnBoardTakesLessThanATenthOfTheParentsTime) {
  const auto rows = printed(hull_tool::add_times, "times " + kHulls +
                                                      "s175.hull.toml --paper --speed-kn 16.1 --spectrum "
                                                      "bretschneider --hs-m 4.9 --t1-s 8.4");
  double quick = 0.0;
  for (const Line& row : rows) {
    if (row[0] == "quick" && row[1] == "all") {
      quick = std::stod(row[4]);
    }
  }
  EXPECT_GT(quick, 0.0);
  EXPECT_LT(quick, 10.0);
}

}  // namespace
}  // namespace quickstrip
