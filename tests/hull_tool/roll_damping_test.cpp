// quickstrip-hull roll-damping and motions --wave-amplitude-m: what scripts rely on.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Row = std::map<std::string, std::string>;

std::filesystem::path own_file(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("qs_roll_" + std::to_string(getpid()) + "_" + name);
}

// The S-175 with Ikeda's damping instead of a ratio.
std::string ikeda_ship() {
  std::ifstream file(std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/s175.hull.toml");
  std::stringstream text;
  text << file.rdbuf();
  std::string hull = text.str();
  for (const std::array<std::string, 2>& change :
       {std::array<std::string, 2>{"method = \"ratio\"", "method = \"ikeda\""}}) {
    const std::size_t at = hull.find(change[0]);
    if (at != std::string::npos) {
      hull.replace(at, change[0].size(), change[1]);
    }
  }
  const auto path = own_file("ikeda.hull.toml");
  std::ofstream(path) << hull;
  return path.string();
}

std::vector<Row> rows_of(const std::string& arguments) {
  const auto path = own_file("out.csv");
  const std::string command = std::string(QUICKSTRIP_HULL_PROGRAM) + " " + arguments + " >" + path.string();
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::ifstream file(path);
  const auto fields = [](const std::string& line) {
    std::vector<std::string> out(1);
    for (const char c : line) {
      if (c == ',') {
        out.emplace_back();
      } else {
        out.back() += c;
      }
    }
    return out;
  };
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = fields(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> values = fields(line);
    EXPECT_EQ(values.size(), names.size()) << line;
    Row row;
    for (std::size_t i = 0; i < std::min(values.size(), names.size()); ++i) {
      row[names[i]] = values[i];
    }
    rows.push_back(row);
  }
  std::filesystem::remove(path);
  return rows;
}

double number(const Row& row, const std::string& name) {
  const auto at = row.find(name);
  EXPECT_NE(at, row.end()) << name;
  return at == row.end() ? 0.0 : std::stod(at->second);
}

class RollDampingCommand : public ::testing::Test {
 protected:
  RollDampingCommand() : ship_(ikeda_ship()) {}
  ~RollDampingCommand() override { std::filesystem::remove(ship_); }
  std::string ship_;
};

TEST_F(RollDampingCommand, ComponentsAddUpAndHatsAreTheSameInOtherUnits) {
  const auto rows =
      rows_of("roll-damping " + ship_ + " --speed-kn 0,20 --amplitude-deg 0,10 --omega 0.3,0.35");
  ASSERT_EQ(rows.size(), 8u);
  for (const Row& row : rows) {
    double sum = 0.0;
    double hats = 0.0;
    for (const std::string part :
         {"b_constant", "b_friction", "b_eddy", "b_lift", "b_keel_normal", "b_keel_pressure", "b_wave"}) {
      sum += number(row, part);
      hats += number(row, part + "_hat");
    }
    const double added = number(row, "b_added");
    EXPECT_NEAR(sum, added, 1e-8 * added);  // ten digits are printed
    EXPECT_NEAR(hats, number(row, "b_added_hat"), 1e-8 * hats);
    EXPECT_EQ(row.at("outside_range"), "");
  }
  EXPECT_EQ(number(rows[0], "b_lift"), 0.0);
  EXPECT_GT(number(rows[4], "b_lift"), 0.0);
}

TEST_F(RollDampingCommand, NaturalFrequencyIsTheDefaultAndWhatIsOutOfRangeIsNamed) {
  const auto rows = rows_of("roll-damping " + ship_ + " --speed-kn 0 --amplitude-deg 25");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(number(rows[0], "omega_rad_s"), 0.348, 0.001);  // 18 s
  EXPECT_EQ(rows[0].at("outside_range"), "amplitude");
}

TEST_F(RollDampingCommand, ARatioOnTheCommandLineReplacesTheComponents) {
  const auto rows =
      rows_of("roll-damping " + ship_ + " --speed-kn 10 --amplitude-deg 10 --roll-damping-ratio 0.05");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(number(rows[0], "added_ratio_of_critical"), 0.05, 1e-9);
  EXPECT_EQ(number(rows[0], "b_keel_normal"), 0.0);
}

TEST_F(RollDampingCommand, RollPerMetreFallsAsTheWaveGrowsAndGreatRollIsFlagged) {
  const std::string wave = "motions " + ship_ + " --speed-kn 0 --mu-deg 90 --omega 0.35 --wave-amplitude-m ";
  const Row low = rows_of(wave + "0.1").at(0);
  const Row high = rows_of(wave + "8").at(0);
  EXPECT_GT(number(low, "roll_amp"), 1.5 * number(high, "roll_amp"));
  EXPECT_EQ(low.at("quality").find("extreme_motion"), std::string::npos);
  EXPECT_NE(high.at("quality").find("extreme_motion"), std::string::npos);
  EXPECT_NE(high.at("quality").find("roll_damping_range"), std::string::npos);
  // Without the option: one metre. Heave does not care.
  const Row unit = rows_of("motions " + ship_ + " --speed-kn 0 --mu-deg 90 --omega 0.35").at(0);
  EXPECT_EQ(unit.at("roll_amp"), rows_of(wave + "1").at(0).at("roll_amp"));
  EXPECT_EQ(unit.at("heave_amp"), high.at("heave_amp"));
}

}  // namespace
