// [handling] and [resistance] of a hull file.
#include "msgs/files/hull_file_handling.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "msgs/convert/units.hpp"
#include "msgs/files/file_status.hpp"
#include "msgs/files/toml_table.hpp"

namespace quickstrip {
namespace {

/// "" when both tables are accepted, else the one line of refusal.
std::string read(const std::string& text, Hull& hull) {
  try {
    const TomlTable root = TomlTable::parse(text, "f");
    read_handling(root, hull);
    read_resistance(root, hull);
    return "";
  } catch (const FileError& error) {
    return FileStatus(error).line();
  }
}

TEST(HullHandling, DefaultsAreOursAndEveryKeyReplacesOne) {
  static Hull hull;
  EXPECT_EQ(read("", hull), "");
  EXPECT_DOUBLE_EQ(hull.min_steerage_speed, from_knots(3.0));
  EXPECT_DOUBLE_EQ(hull.handling.turn_rate, radians(0.5));
  EXPECT_DOUBLE_EQ(hull.handling.slowing, from_knots(1.0) / 60.0);
  EXPECT_DOUBLE_EQ(hull.handling.speeding_up, from_knots(0.5) / 60.0);
  EXPECT_TRUE(hull.resistance.empty());
  EXPECT_EQ(read("[handling]\nmin_steerage_kn = 4\nturn_rate_deg_min = 60\nslow_down_kn_min = 2\n"
                 "speed_up_kn_min = 1.5\n",
                 hull),
            "");
  EXPECT_DOUBLE_EQ(hull.handling.turn_rate, radians(1.0));
  EXPECT_DOUBLE_EQ(hull.handling.slowing, from_knots(2.0) / 60.0);
  EXPECT_DOUBLE_EQ(hull.handling.speeding_up, from_knots(1.5) / 60.0);
}

TEST(HullHandling, BrakePowerAndEfficiencyAreTheResistanceThatTheyMean) {
  static Hull hull;
  // eta P = R V: 0.6 x 5,144.444 kW at 10 kn (5.14444 m/s) is 600 kN.
  EXPECT_EQ(read("[resistance]\nspeed_kn_brake_power_kw = [[5, 500.0], [10, 5144.4444444]]\n"
                 "total_efficiency = 0.6\n",
                 hull),
            "");
  ASSERT_EQ(hull.resistance.size(), 2u);
  EXPECT_NEAR(hull.resistance[1].force, 600e3, 0.1);
  EXPECT_NEAR(hull.resistance[1].speed, 5.144444, 1e-6);
}

TEST(HullHandling, RefusesWhatCannotBeAndSaysWhatWouldBeRight) {
  static Hull hull;
  const std::pair<const char*, const char*> cases[] = {
      {"[handling]\nmin_steerage_kn = 3\nturn_rate_deg_min = 0\n", "turn_rate_deg_min = 0"},
      {"[handling]\nmin_steerage_kn = 3\nturn_rate = 3\n", "turn_rate_deg_min"},
      {"[resistance]\nspeed_kn_force_n = [[10, 1000.0]]\n", "at least two speeds"},
      {"[resistance]\nspeed_kn_force_n = [[10, 2000.0], [12, 1000.0]]\n", "speed_kn_force_n[2]"},
      {"[resistance]\nspeed_kn_force_n = [[10, 1000.0], [10, 2000.0]]\n", "speed_kn_force_n[2]"},
      {"[resistance]\nspeed_kn_force_n = [[10, 1000.0], [12, nan]]\n", "speed_kn_force_n[2]"},
      {"[resistance]\nspeed_kn_brake_power_kw = [[5, 500.0], [10, 5000.0]]\n", "total_efficiency"},
      {"[resistance]\nspeed_kn_force_n = [[5, 1.0], [6, 2.0]]\ntotal_efficiency = 0.6\n", "not both"},
      {"[resistance]\n", "speed_kn_brake_power_kw"}};
  for (const auto& [text, word] : cases) {
    const std::string line = read(text, hull);
    EXPECT_NE(line.find(word), std::string::npos) << text << ": " << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace quickstrip
