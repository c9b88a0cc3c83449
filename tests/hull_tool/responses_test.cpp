// quickstrip-hull responses: columns that scripts rely on, local motions, and swell-up switched on and off.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/single_precision.hpp"

namespace {

using quickstrip::kSingle;

using Row = std::map<std::string, std::string>;

/// Rows of the S-175 in head seas of 9 m, by "quantity@where".
std::map<std::string, Row> responses(const std::string& options, std::string* header = nullptr) {
  const auto path =
      std::filesystem::temp_directory_path() / ("qs_responses_" + std::to_string(getpid()) + ".csv");
  std::string command(QUICKSTRIP_HULL_PROGRAM);
  command.append(" responses ").append(QUICKSTRIP_SOURCE_DIR).append("/sim/hulls/s175.hull.toml");
  command.append(" --spectrum bretschneider --hs-m 9 --t1-s 11 --mu-deg 180 --speed-kn 16 ").append(options);
  command.append(" >").append(path.string());
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  if (header != nullptr) {
    *header = line;
  }
  const auto fields = [](const std::string& text) {
    std::vector<std::string> out(1);
    bool quoted = false;
    for (const char c : text) {
      quoted = c == '"' ? !quoted : quoted;
      if (c == ',' && !quoted) {
        out.emplace_back();
      } else if (c != '"') {
        out.back() += c;
      }
    }
    return out;
  };
  const std::vector<std::string> names = fields(line);
  std::map<std::string, Row> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> values = fields(line);
    EXPECT_EQ(values.size(), names.size()) << line;
    Row row;
    for (std::size_t i = 0; i < std::min(values.size(), names.size()); ++i) {
      row[names[i]] = values[i];
    }
    rows[row["quantity"] + "@" + row["where"]] = row;
  }
  std::filesystem::remove(path);
  return rows;
}

double number(const Row& row, const char* name) {
  return std::stod(row.at(name));
}

TEST(Responses, KeepTheColumnsOfTheContractAndPutNewOnesBehind) {
  std::string header;
  const auto rows = responses("", &header);
  EXPECT_EQ(header,
            "speed_kn,mu_deg,quantity,where,unit,rms,significant,t1_s,t2_s,probability,per_hour,quality,t4_s,"
            "bandwidth,most_probable_max,level,exceedance,exceedances_per_hour,mean");
  for (const char* key : {"roll@G", "vertical_acceleration@bridge", "slamming@bow", "deck_wetness@bow",
                          "propeller_emergence@propeller", "displacement_z@bridge", "velocity_x@bridge",
                          "relative_motion@slamming at bow", "relative_velocity@deck_wetness at bow",
                          "relative_motion@propeller"}) {
    EXPECT_EQ(rows.count(key), 1u) << key;
  }
}

// A mean and nothing else; two methods of one force, Fn 0.2, in the range of both.
TEST(Responses, GiveTheMeanAddedResistanceByBothMethods) {
  const auto rows = responses("");
  const double strip = number(rows.at("added_resistance@G"), "mean");
  const double empirical = number(rows.at("added_resistance_empirical@G"), "mean");
  EXPECT_GT(strip, 0.0);
  EXPECT_GT(empirical, 0.5 * strip);
  EXPECT_LT(empirical, 2.0 * strip);
  EXPECT_EQ(rows.at("added_resistance@G").at("unit"), "N");
  EXPECT_EQ(rows.at("added_resistance@G").at("rms"), "");
  EXPECT_EQ(rows.at("roll@G").at("mean"), "");
}

TEST(Responses, OfAPointGivenAreThoseOfTheHullFilesPoint) {
  auto rows = responses("--point 30,0,35 --point 85,12.7,20");
  for (const char* quantity : {"displacement_z", "velocity_z", "vertical_acceleration"}) {
    const std::string name(quantity);
    EXPECT_EQ(rows.at(name + "@30,0,35").at("rms"), rows.at(name + "@bridge").at("rms"));
    EXPECT_EQ(rows.count(name + "@85,12.7,20"), 1u);
  }
  // The velocity's period is the displacement's T4, and its RMS 2 pi / T2 of the displacement's.
  const Row& z = rows.at("displacement_z@bridge");
  const Row& rate = rows.at("velocity_z@bridge");
  EXPECT_NEAR(number(rate, "t2_s") / number(z, "t4_s"), 1.0, kSingle);
  EXPECT_NEAR(number(rate, "rms"), number(z, "rms") * 2.0 * M_PI / number(z, "t2_s"), kSingle);
}

TEST(Responses, OfSlammingRestOnTheRelativeMotionThere) {
  const auto rows = responses("");
  EXPECT_EQ(rows.at("slamming@bow").at("rms"), rows.at("relative_motion@slamming at bow").at("rms"));
  EXPECT_EQ(rows.at("slamming@bow").at("t2_s"), rows.at("relative_motion@slamming at bow").at("t2_s"));
}

TEST(Responses, LevelsAreExceededAndTheLargestOfSomeHoursIsFoundAsTheFormulasSay) {
  const auto rows = responses("--level heave=4 --hours 3");
  const Row& heave = rows.at("heave@G");
  const double rms = number(heave, "rms");
  const double exceedance = std::exp(-8.0 / (rms * rms));
  EXPECT_NEAR(number(heave, "exceedance"), exceedance, 1e-8);
  EXPECT_NEAR(number(heave, "exceedances_per_hour"), 3600.0 / number(heave, "t2_s") * exceedance, 1e-6);
  EXPECT_NEAR(number(heave, "most_probable_max"),
              rms * std::sqrt(2.0 * std::log(3.0 * 3600.0 / number(heave, "t2_s"))), 1e-7);
  EXPECT_EQ(rows.at("roll@G").at("level"), "");
}

TEST(Responses, WithoutSwellUpTheBowIsSaidToBeSaferAndPaperIsWithout) {
  const auto on = responses("");
  const auto off = responses("--swell-up off");
  for (const char* key : {"slamming@bow", "deck_wetness@bow", "propeller_emergence@propeller"}) {
    EXPECT_GT(number(on.at(key), "probability"), number(off.at(key), "probability")) << key;
    EXPECT_NEAR(number(on.at(key), "rms") / number(off.at(key), "rms"), 1.15, kSingle) << key;  // CB 0.57
  }
  EXPECT_EQ(on.at("heave@G").at("rms"), off.at("heave@G").at("rms"));
  EXPECT_NE(on.at("slamming@bow").at("quality").find("swell_up_range"), std::string::npos);
  EXPECT_EQ(on.at("heave@G").at("quality").find("swell_up_range"), std::string::npos);
  EXPECT_EQ(off.at("slamming@bow").at("quality").find("swell_up_range"), std::string::npos);
  const auto paper = responses("--paper");
  const auto paper_on = responses("--paper --swell-up onboard");
  EXPECT_GT(number(paper_on.at("deck_wetness@bow"), "probability"),
            number(paper.at("deck_wetness@bow"), "probability"));
}

TEST(Responses, SayWhereTheBandIsTooWideForRayleighMaxima) {
  const auto rows = responses("");
  EXPECT_EQ(rows.at("heave@G").at("quality").find("wide_band"), std::string::npos);
  EXPECT_NE(rows.at("slamming@bow").at("quality").find("wide_band"), std::string::npos);
  EXPECT_GT(number(rows.at("slamming@bow"), "bandwidth"), 0.745);
}

}  // namespace
