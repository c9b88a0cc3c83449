#include "msgs/files/limits_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/base/angles.hpp"
#include "msgs/files/hull_file.hpp"

namespace quickstrip {
namespace {

const Hull& s175() {
  static Hull hull;
  static const bool is_read =
      read_hull_file(std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/s175.hull.toml", hull).ok();
  EXPECT_TRUE(is_read);
  return hull;
}

std::string criterion(const std::string& lines) {
  return "schema = 1\nname = \"ours\"\n[[criterion]]\nname = \"c\"\n" + lines;
}

LimitsProfile profile_of(const std::string& lines) {
  LimitsProfile profile;
  EXPECT_EQ(parse_limits(criterion(lines), "l.toml", s175(), profile).line(), "");
  return profile;
}

void expect_refused(const std::string& lines, std::initializer_list<const char*> words) {
  LimitsProfile profile;
  const std::string line = parse_limits(criterion(lines), "l.toml", s175(), profile).line();
  EXPECT_EQ(line.rfind("l.toml: ", 0), 0u) << line;
  for (const char* word : words) {
    EXPECT_NE(line.find(word), std::string::npos) << "wanted '" << word << "' in: " << line;
  }
}

TEST(LimitsFile, EachKindOfLimitArrivesInSiUnits) {
  LimitsProfile p = profile_of("quantity = \"roll\"\nstatistic = \"rms\"\nlimit_deg = 6.0\n");
  ASSERT_EQ(p.criteria.size(), 1u);
  EXPECT_EQ(p.name.view(), "ours");
  EXPECT_DOUBLE_EQ(p.criteria[0].limit, radians(6.0));
  EXPECT_EQ(p.criteria[0].caution_fraction, 0.75);
  p = profile_of(
      "quantity = \"vertical_acceleration\"\nrole = \"bridge\"\nstatistic = \"significant\"\n"
      "limit_g = 0.3\ncaution_fraction = 0.5\n");
  EXPECT_DOUBLE_EQ(p.criteria[0].limit, 0.3 * 9.80665);
  EXPECT_EQ(p.criteria[0].statistic, Statistic::kSignificant);
  EXPECT_EQ(p.criteria[0].place, 0);
  EXPECT_EQ(p.criteria[0].caution_fraction, 0.5);
  p = profile_of("quantity = \"slamming\"\nstatistic = \"per_hour\"\nlimit_per_hour = 20\n");
  EXPECT_EQ(p.criteria[0].limit, 20.0);
  EXPECT_EQ(p.criteria[0].statistic, Statistic::kPerHour);
  p = profile_of(
      "quantity = \"deck_wetness\"\nplace = \"bow\"\nstatistic = \"probability\"\n"
      "limit_probability = 0.05\n");
  EXPECT_EQ(p.criteria[0].limit, 0.05);
  p = profile_of("quantity = \"propeller_emergence\"\nstatistic = \"per_hour\"\nlimit_per_hour = 90\n");
  EXPECT_EQ(p.criteria[0].quantity, Quantity::kPropellerEmergence);
  EXPECT_EQ(p.criteria[0].limit, 90.0);
  EXPECT_EQ(p.criteria[0].place, 0);
  EXPECT_TRUE(check_criteria(p.criteria, s175()).ok());
  Hull without = s175();
  without.propeller.reset();
  EXPECT_FALSE(check_criteria(p.criteria, without).ok());
  EXPECT_TRUE(check_criteria(p.criteria, s175()).ok());
}

TEST(LimitsFile, ARoleThatTheHullHasNotIsKeptAsNotWatched) {
  const LimitsProfile p = profile_of(
      "quantity = \"lateral_acceleration\"\nrole = \"passengers\"\nstatistic = \"rms\"\nlimit_g = 0.05\n");
  ASSERT_EQ(p.criteria.size(), 1u);
  EXPECT_EQ(p.criteria[0].place, kNowhere);
  EXPECT_FALSE(p.criteria[0].is_watched());
}

TEST(LimitsFile, WhatIsWrongIsNamed) {
  expect_refused("quantity = \"rol\"\nstatistic = \"rms\"\nlimit_deg = 6.0\n",
                 {"criterion[1].quantity = \"rol\"", "\"roll\""});
  expect_refused("quantity = \"roll\"\nstatistic = \"probability\"\nlimit_deg = 6.0\n",
                 {"criterion[1].statistic = \"probability\"", "\"rms\", \"significant\""});
  expect_refused("quantity = \"roll\"\nstatistic = \"rms\"\nlimit_g = 6.0\n", {"limit_g = 6.0", "limit_deg"});
  expect_refused("quantity = \"roll\"\nstatistic = \"rms\"\n", {"limit_deg", "missing"});
  expect_refused("quantity = \"roll\"\nstatistic = \"rms\"\nlimit_deg = 0.0\n", {"limit_deg = 0.0"});
  expect_refused("quantity = \"roll\"\nstatistic = \"rms\"\nlimit_deg = 6.0\nrole = \"bridge\"\n",
                 {"role = \"bridge\"", "no place is wanted"});
  expect_refused(
      "quantity = \"vertical_acceleration\"\nplace = \"crane\"\nstatistic = \"rms\"\nlimit_g = 0.1\n",
      {"place = \"crane\"", "\"bridge\""});
  expect_refused(
      "quantity = \"vertical_acceleration\"\nrole = \"bridge\"\nstatistic = \"rms\"\nlimit_g = 0.1\n"
      "limit_m_s2 = 1.0\n",
      {"limit_m_s2", "only one"});
  expect_refused("quantity = \"slamming\"\nstatistic = \"rms\"\nlimit_m = 1.0\n",
                 {"statistic = \"rms\"", "\"per_hour\""});
  expect_refused("quantity = \"slamming\"\nstatistic = \"probability\"\nlimit_probability = 3\n",
                 {"limit_probability = 3", "0.999"});
  LimitsProfile profile;
  EXPECT_NE(
      parse_limits("schema = 1\nname = \"none\"\n", "l.toml", s175(), profile).line().find("none given"),
      std::string::npos);
}

}  // namespace
}  // namespace quickstrip
