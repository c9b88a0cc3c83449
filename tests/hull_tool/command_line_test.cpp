// The program itself: exit codes, streams, and what a script reads.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

const std::string kHulls = std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/";

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("qs_hull_" + std::to_string(getpid()) + "_" + name);
}

Outcome run(const std::string& arguments) {
  const auto out = scratch("out");
  const auto err = scratch("err");
  const std::string command =
      std::string(QUICKSTRIP_HULL_PROGRAM) + " " + arguments + " >" + out.string() + " 2>" + err.string();
  const int status = std::system(command.c_str());
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
  std::filesystem::remove(out);
  std::filesystem::remove(err);
  return outcome;
}

// The S-175 with one line of its file replaced; the path of the new file.
class ChangedHull {
 public:
  ChangedHull(const std::string& from, const std::string& to) : path_(scratch("changed.hull.toml")) {
    std::string text = content_of(kHulls + "s175.hull.toml");
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    std::ofstream(path_) << text.replace(at, from.size(), to);
  }
  ~ChangedHull() { std::filesystem::remove(path_); }
  ChangedHull(const ChangedHull&) = delete;
  ChangedHull& operator=(const ChangedHull&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

void expect_one_line_refusal(const Outcome& outcome, std::initializer_list<const char*> words) {
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  for (const char* word : words) {
    EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " in " << outcome.err;
  }
}

TEST(HullTool, HelpAndVersionGoToStandardOutputAndExitZero) {
  for (const char* arguments : {"--help", "--version", "check --help", "hydrostatics --help"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments;
    EXPECT_NE(outcome.out, "") << arguments;
    EXPECT_EQ(outcome.err, "") << arguments;
  }
}

TEST(HullTool, WrongUseExitsTwoAndPrintsNothingOnStandardOutput) {
  const std::string s175 = kHulls + "s175.hull.toml";
  for (const std::string& arguments :
       {std::string(), std::string("nonsense"), std::string("check"), "check " + s175 + " more",
        "hydrostatics " + s175 + " --kg-m nan", "hydrostatics " + s175 + " --kg-m -1",
        "hydrostatics " + s175 + " --kg-m 9,10", "hydrostatics " + s175 + " --format xml",
        "hydrostatics " + s175 + " --colour"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_NE(outcome.err, "") << arguments;
  }
}

TEST(HullTool, CheckOfTheS175EndsWithOk) {
  for (const char* name : {"s175", "s175_minimal", "shortest"}) {
    const Outcome outcome = run("check " + kHulls + name + ".hull.toml");
    EXPECT_EQ(outcome.exit_code, 0) << name;
    EXPECT_EQ(outcome.err, "") << name;
    EXPECT_EQ(outcome.out.substr(outcome.out.size() - 4), "\nok\n") << name;
  }
}

TEST(HullTool, CheckSaysWhatIsNotWatchedAndWhatIsDoubtful) {
  const std::string out = run("check " + kHulls + "shortest.hull.toml").out;
  EXPECT_NE(out.find("free_surface_correction_m is absent"), std::string::npos);
  EXPECT_NE(out.find("shipping of water: no [[freeboard]]"), std::string::npos);
  EXPECT_NE(out.find("propeller emergence: no [propeller]"), std::string::npos);
  const ChangedHull wide("breadth_m = 25.4", "breadth_m = 33.0");
  const std::string remarks = run("check " + wide.path()).out + run("check " + wide.path()).err;
  EXPECT_NE(remarks.find("roll_gyradius_m"), std::string::npos) << remarks;  // 0.25 B: unusual
}

TEST(HullTool, HydrostaticsHasTheKeysOfTheContractAndTheFiguresOfTheS175) {
  const Outcome outcome = run("hydrostatics " + kHulls + "s175.hull.toml");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.substr(0, outcome.out.find('\n')),
            "displacement_t,lcb_m,kb_m,gm_m,gml_m,lcf_m,waterplane_area_m2,cb,cm,cwp,roll_period_s");
  const std::string row = outcome.out.substr(outcome.out.find('\n') + 1);
  std::array<double, 4> figures{};
  ASSERT_EQ(std::sscanf(row.c_str(), "%lf,%lf,%lf,%lf", &figures[0], &figures[1], &figures[2], &figures[3]),
            4);
  EXPECT_NEAR(figures[0], 24616.0, 25.0);  // 0.1 %, as in tests/hull
  EXPECT_NEAR(figures[1], 84.953, 0.085);
  EXPECT_NEAR(figures[2], 5.207, 0.005);
  EXPECT_NEAR(figures[3], 0.994, 0.001);
}

TEST(HullTool, LoadingOptionsReplaceTheFilesLoading) {
  const std::string s175 = kHulls + "s175.hull.toml";
  const std::string by_option =
      run("hydrostatics " + s175 + " --kg-m 9 --draught-aft-m 9 --draught-fwd-m 8.5").out;
  const ChangedHull aft("draught_aft_m = 9.5", "draught_aft_m = 9.0");
  EXPECT_NE(by_option, run("hydrostatics " + aft.path()).out);
  EXPECT_EQ(run("hydrostatics " + s175 + " --draught-aft-m 9").out, run("hydrostatics " + aft.path()).out);
}

TEST(HullTool, JsonHasTheSameKeysAndNullForWhatIsNotKnown) {
  const Outcome outcome = run("hydrostatics --format json " + kHulls + "s175.hull.toml");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("\"displacement_t\": 24615."), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\"cwp\": "), std::string::npos);
}

TEST(HullTool, SectionsListsEveryStationAndSaysWhichFormsAreReplaced) {
  const Outcome outcome = run("sections " + kHulls + "s175.hull.toml");
  EXPECT_EQ(outcome.exit_code, 0);
  std::istringstream lines(outcome.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "x_m,breadth_m,draught_m,area_m2,h0,sigma,a1,a3,lewis_class,replaced");
  int rows = 0;
  std::string replaced;
  while (std::getline(lines, line)) {
    ++rows;
    if (line.substr(line.size() - 2) == ",1") {
      replaced += line.substr(0, line.find(',')) + " ";
    }
    if (line.rfind("87.5,", 0) == 0) {  // amidships: B/2T and A/BT
      EXPECT_EQ(line.rfind("87.5,25.4,9.5,233.15", 0), 0U) << line;
      EXPECT_NE(line.find(",1.336842105,0.966"), std::string::npos) << line;
    }
  }
  EXPECT_EQ(rows, 24);
  EXPECT_EQ(replaced, "8.75 175 ");  // the re-entrant skeg and the bulb at the forward perpendicular
}

TEST(HullTool, MappingSaysHowNearItComesAndWhySectionsGoToFrank) {
  const Outcome s175 = run("mapping " + kHulls + "s175.hull.toml");
  EXPECT_EQ(s175.exit_code, 0) << s175.err;
  EXPECT_EQ(s175.out.rfind("x_m,coefficients,rms_error_mm,", 0), 0U);
  EXPECT_NE(s175.out.find("\n87.5,10,"), std::string::npos);
  EXPECT_NE(s175.out.find(",0,thinner than a twentieth of its draught\n"), std::string::npos);
  const Outcome kcs = run("mapping " + kHulls + "kcs.hull.toml --coefficients 5");
  EXPECT_NE(kcs.out.find(",0,,,,,,0,wholly submerged\n"), std::string::npos);  // the bulb
  EXPECT_EQ(run("mapping " + kHulls + "s175.hull.toml --coefficients 11").exit_code, 2);
}

TEST(HullTool, ShipThatIsUnstableIsRefusedWithTheGreatestKg) {
  const ChangedHull top_heavy("kg_m = 9.55", "kg_m = 12.0");
  expect_one_line_refusal(
      run("check " + top_heavy.path()),
      {"changed.hull.toml: loading.kg_m = 12: GM is not positive", "-1.456 m", "less than 10.544 m"});
  expect_one_line_refusal(run("hydrostatics --kg-m 12 " + kHulls + "s175.hull.toml"),
                          {"--kg-m = 12", "10.544"});
}

TEST(HullTool, OvertoppedDeckAndOtherDraughtOfAMinimalFormAreRefusedByName) {
  expect_one_line_refusal(run("hydrostatics --draught-fwd-m 11.5 " + kHulls + "s175.hull.toml"),
                          {"s175.hull.toml: --draught-fwd-m = 11.5", "x_m = 140", "11 m"});
  expect_one_line_refusal(run("hydrostatics --draught-aft-m 9 " + kHulls + "s175_minimal.hull.toml"),
                          {"--draught-aft-m = 9", "9.5 m alone"});
  const ChangedHull deep("draught_fwd_m = 9.5", "draught_fwd_m = 10.9");
  EXPECT_EQ(run("check " + deep.path()).exit_code, 0);
}

TEST(HullTool, MissingFileAndUnknownKeyAreRefused) {
  expect_one_line_refusal(run("check nowhere.hull.toml"), {"nowhere.hull.toml"});
  const ChangedHull misspelt("kg_m = 9.55", "kgm = 9.55");
  expect_one_line_refusal(run("check " + misspelt.path()), {"kgm", "kg_m"});
}

TEST(HullTool, ComparePrintsOneLineASpeedAndDirectionAndRefusesAFileThatIsNone) {
  const std::string s175 = kHulls + "s175.hull.toml";
  const std::string golden = std::string(QUICKSTRIP_SOURCE_DIR) + "/tests/golden/s175_veres_amplitudes.csv";
  const Outcome table =
      run("compare " + s175 + " --with " + golden + " --method modified --surge inertia-only");
  EXPECT_EQ(table.exit_code, 0) << table.err;
  EXPECT_NE(table.out.find("RMS, %"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("20     150"), std::string::npos) << table.out;
  const Outcome csv = run("compare " + s175 + " --format csv --with " + golden);
  EXPECT_EQ(csv.out.substr(0, csv.out.find('\n')),
            "speed_kn,mu_deg,motion,frequencies,peak,scale,rms_percent,worst_percent,worst_omega_rad_s");
  expect_one_line_refusal(run("compare " + s175 + " --with " + s175), {"s175.hull.toml: line", "header"});
  expect_one_line_refusal(run("compare " + s175 + " --with nowhere.csv"), {"nowhere.csv"});
}

// The program compared with what it prints itself: nothing differs but the point of the motions.
TEST(HullTool, CompareWithItsOwnMotionsAtGFindsNoDifference) {
  const auto motions = scratch("motions.csv");
  const std::string s175 = kHulls + "s175.hull.toml --roll-damping-ratio 0.05";
  std::ofstream(motions)
      << run("motions " + s175 + " --speed-kn 0,15 --mu-deg 45,135 --omega 0.3:1.5:0.3").out;
  const Outcome same = run("compare " + s175 + " --at G --format csv --with " + motions.string());
  std::filesystem::remove(motions);
  EXPECT_EQ(same.exit_code, 0) << same.err;
  std::istringstream lines(same.out);
  std::string line;
  std::getline(lines, line);
  int rows = 0;
  for (; std::getline(lines, line); ++rows) {
    double rms = 1.0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%*f,%*f,%*[a-z],%*d,%*f,%*f,%lf", &rms), 1) << line;
    EXPECT_LT(rms, 1e-6) << line;  // ten digits are printed
  }
  EXPECT_EQ(rows, 24);
}

TEST(HullTool, FullDiskIsSaidAndExitsOne) {
  const auto err = scratch("err");
  const std::string command = std::string(QUICKSTRIP_HULL_PROGRAM) + " check " + kHulls +
                              "s175.hull.toml >/dev/full 2>" + err.string();
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_NE(content_of(err).find("standard output"), std::string::npos);
  std::filesystem::remove(err);
}

// A swell from 135 meets a ship heading north on her starboard quarter: mu = +45 degrees.
TEST(Zones, SayTheSideTheRollPeriodAndTheEndThatDecides) {
  const Outcome zones = run("zones " + kHulls +
                            "s175.hull.toml --spectrum jonswap --hs-m 4 --t1-s 8.344 --dir-from-deg 135"
                            " --heading-deg 0 --speed-kn 15");
  EXPECT_EQ(zones.exit_code, 0);
  EXPECT_NE(zones.out.find(",135,45,"), std::string::npos) << zones.out;
  EXPECT_NE(zones.out.find(",shortest,"), std::string::npos) << zones.out;
  EXPECT_NE(zones.out.find("synchronous_roll;parametric_roll"), std::string::npos) << zones.out;
  EXPECT_NE(zones.err.find("16.23 to 19.83 s (computed, 10 % either way); IS Code 18.30 s"),
            std::string::npos)
      << zones.err;
}

TEST(Grid, SaysTheShareOfUnknownCells) {
  const Outcome grid =
      run("grid " + kHulls + "s175.hull.toml --spectrum jonswap --hs-m 2 --t1-s 8.344 --dir-from-deg 180");
  EXPECT_NE(grid.err.find("unknown: "), std::string::npos) << grid.err;
  EXPECT_NE(grid.out.find(",unknown,"), std::string::npos);
}

std::string limits(const std::string& profile) {
  return " --limits " + std::string(QUICKSTRIP_SOURCE_DIR) + "/firmware/profiles/" + profile + ".limits.toml";
}

TEST(Limits, OfAProfileThatTheHullFileCannotGiveAreListedAndNoCellIsGood) {
  const std::string calm = " --spectrum bretschneider --hs-m 0.2 --t1-s 5 --dir-from-deg 0";
  const std::string s175 = kHulls + "s175.hull.toml";
  const Outcome check = run("check " + s175 + limits("passengers_transit"));
  EXPECT_EQ(check.exit_code, 0);
  EXPECT_NE(check.out.find("3 of them not watched: no cell will be good"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("\"motion sickness at passengers\" (motion_sickness)"), std::string::npos);
  EXPECT_EQ(run("grid " + s175 + calm + limits("passengers_transit")).out.find(",good,"), std::string::npos);
  EXPECT_NE(run("grid " + s175 + calm + limits("nordforsk_merchant")).out.find(",good,"), std::string::npos);
}

TEST(Limits, OfThePresentProfileAreTheOnesWithoutTheOption) {
  const std::string grid =
      "grid " + kHulls + "s175.hull.toml --spectrum bretschneider --hs-m 4 --t1-s 9 --dir-from-deg 40";
  EXPECT_EQ(run(grid).out, run(grid + limits("nordforsk_merchant")).out);
}

TEST(Limits, BringRowsOfPeopleToTheResponses) {
  const std::string responses = "responses " + kHulls +
                                "s175.hull.toml --spectrum bretschneider --hs-m 5 --t1-s 9 --speed-kn 12 "
                                "--mu-deg 130";
  const std::string out = run(responses + limits("naval_transit")).out;
  for (const char* row : {",motion_sickness,bridge,m/s2,", ",motion_interruptions,bridge to port,m/s2,",
                          ",motion_interruptions,bridge to starboard,m/s2,"}) {
    EXPECT_NE(out.find(row), std::string::npos) << row;
  }
  EXPECT_EQ(run(responses).out.find("motion_sickness"), std::string::npos);
}

}  // namespace
