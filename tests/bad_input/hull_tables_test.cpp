// Compiled hull tables as a new user would get them wrong: in quickstrip-hull compile, and behind --table.
#include <cstddef>

#include "tests/bad_input/programs.hpp"

namespace quickstrip::test {
namespace {

// A barge of three stations: quick to compile.
const std::string kBarge = R"(schema = 1
name = "barge"
particulars = { lpp_m = 60.0, breadth_m = 12.0 }
[[station]]
x_m = 0.0
offsets_m = [[0.0, 0.0], [6.0, 5.0]]
[[station]]
x_m = 30.0
offsets_m = [[0.0, 0.0], [6.0, 0.5], [6.0, 5.0]]
[[station]]
x_m = 60.0
offsets_m = [[0.0, 0.0], [5.0, 2.0], [6.0, 5.0]]
[loading]
draught_aft_m = 2.0
draught_fwd_m = 2.0
kg_m = 2.0
roll_gyradius_m = 4.0
pitch_gyradius_m = 15.0
yaw_gyradius_m = 15.0
[roll_damping]
method = "ratio"
ratio = 0.05
[[point]]
name = "bridge"
role = "bridge"
x_m = 5.0
z_m = 12.0
[grid]
speeds_kn = { from = 0.0, to = 10.0, step = 5.0 }
heading_step_deg = 90.0
)";

class HullTables : public Programs {
 protected:
  std::string barge(const std::string& name, const std::string& from = "", const std::string& to = "") {
    return folder_.file(name, edited(kBarge, from, to));
  }
  void compile(const std::string& hull, const std::string& out) {
    const Outcome made = run(kHull + " compile " + hull + " --sections lewis --out " + out);
    EXPECT_EQ(made.exit_code, 0) << made.err;
  }
  std::string bytes_of(const std::string& name) const { return text_of(name); }
};

const std::string kMotions = " --speed-kn 5 --mu-deg 90 --omega 0.8";

TEST_F(HullTables, ContoursThatCannotBeAreRefusedByStation) {
  static_cast<void>(barge("cross.toml", "[[0.0, 0.0], [6.0, 0.5], [6.0, 5.0]]",
                          "[[0.0, 0.0], [6.0, 0.5], [2.0, 0.5], [6.0, 0.5], [6.0, 5.0]]"));
  expect_bad(kHull + " compile cross.toml --out o.qst",
             {"cross.toml: station x_m = 30", "crosses itself between points 1-2 and 3-4"});
  static_cast<void>(barge("twice.toml", "[[0.0, 0.0], [6.0, 0.5], [6.0, 5.0]]",
                          "[[0.0, 0.0], [6.0, 0.5], [6.0, 1.0], [4.0, 1.0], [7.0, 1.0], [6.0, 5.0]]"));
  expect_bad(kHull + " compile twice.toml --sections frank --out o.qst",
             {"twice.toml: station x_m = 30", "contour that"});
  static_cast<void>(barge("down.toml", "[6.0, 0.5]", "[6.0, 5.5]"));
  expect_bad(kHull + " compile down.toml --out o.qst",
             {"down.toml: station[2].offsets_m[3]", "at least 5.5"});
  static_cast<void>(barge("one.toml", "[[0.0, 0.0], [6.0, 5.0]]", "[[6.0, 5.0]]"));
  expect_bad(kHull + " compile one.toml --out o.qst", {"one.toml", "offsets_m"});
}

TEST_F(HullTables, ASectionOfTwoPointsIsAWedgeAndIsCompiled) {
  static_cast<void>(barge("barge.toml"));
  for (const char* sections : {"close-fit", "frank"}) {
    const Outcome made = run(kHull + " compile barge.toml --out o.qst --sections " + sections);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_NE(made.out.find("o.qst,3,2,3,"), std::string::npos) << made.out;
  }
}

TEST_F(HullTables, DraughtsAndFoldersThatCannotBeAreRefused) {
  static_cast<void>(barge("barge.toml"));
  const std::string compile = kHull + " compile barge.toml --sections lewis --out ";
  expect_bad(kHull + " compile none.toml --out o.qst", {"none.toml: no such file"});
  expect_bad(compile + "o.qst --draughts 6",
             {"barge.toml: station x_m = 0, waterline 6 m", "lesser draughts"});
  expect_bad(compile + "o.qst --draughts 2 --trims 5", {"barge.toml: these trims", "-0.5 m above base"});
  expect_bad(compile + "o.qst --draughts 1:3:0.1", {"barge.toml: 21 levels: at most 12"});
  expect_bad(compile + "none/o.qst", {"--out = none/o.qst: no folder"});
  expect_bad(compile + ".", {"--out = .: a folder"});
  expect_bad(kHull + " compile " + kS175 + " --out o.qst --draughts 7:9.2:0.2",
             {"12 levels of 24 stations", "fit on board, 9 levels"});
  const std::string minimal = kSource + "/sim/hulls/s175_minimal.hull.toml";
  expect_bad(kHull + " compile " + minimal + " --out o.qst --draughts 9,9.5",
             {"draught 9.5 m and trim 0 m alone", "offsets are wanted"});
  expect_wrong_use(compile + "o.qst --draughts 3:1:1", {"--draughts: 3:1:1"});
  expect_wrong_use(compile + "o.qst --draughts two", {"--draughts: two"});
  expect_wrong_use(compile + "o.qst --draughts 0", {"--draughts: 0", "0.001 ... 100"});
  expect_wrong_use(compile + "o.qst --draughts nan", {"--draughts: nan"});
  expect_wrong_use(compile + "o.qst --trims 99", {"--trims: 99"});
  expect_wrong_use(kHull + " compile barge.toml --out o.qst --sections tasai", {"--sections", "close-fit"});
  expect_wrong_use(kHull + " compile barge.toml", {"--out"});
}

TEST_F(HullTables, WhatIsNoTableOfThisHullStopsEveryProgram) {
  static_cast<void>(barge("barge.toml"));
  static_cast<void>(barge("other.toml", "x_m = 30.0", "x_m = 31.0"));
  compile("other.toml", "other.qst");
  compile("barge.toml", "good.qst");
  std::string bytes = bytes_of("good.qst");
  static_cast<void>(folder_.file("cut.qst", bytes.substr(0, bytes.size() - 100)));
  bytes[bytes.size() - 7] = static_cast<char>(bytes[bytes.size() - 7] ^ 1);
  static_cast<void>(folder_.file("bit.qst", bytes));
  static_cast<void>(folder_.file("empty.qst", ""));
  static_cast<void>(folder_.file("empty.log", ""));
  struct Case {
    const char* table;
    std::string line;
  };
  for (const Case& one : {Case{"none.qst", "none.qst: no such file"},
                          {"barge.toml", "barge.toml: this is not a hull table"},
                          {"empty.qst", "empty.qst: this is not a hull table"},
                          {"cut.qst", "cut.qst: the hull table is cut short"},
                          {"bit.qst", "bit.qst: the hull table is damaged"},
                          {"other.qst", "other.qst: the hull table is of another hull"},
                          {".", ".: a folder"}}) {
    const std::string table = std::string(" --table ") + one.table;
    expect_bad(kHull + " motions barge.toml" + kMotions + table, {one.line});
    expect_bad(kAdvisor + " --hull barge.toml --url memq://" + table, {one.line});
    expect_bad(kSim + " replay empty.log --hull barge.toml --recorded ignore" + table, {one.line});
  }
  expect_bad(kHull + " motions barge.toml --loads boundary-value" + kMotions,
             {"--loads = boundary-value", "--table FILE"});
  expect_bad(kAdvisor + " --hull barge.toml --url memq:// --loads boundary-value",
             {"--loads = boundary-value", "--table FILE"});
}

TEST_F(HullTables, ADraughtOutsideTheLevelsIsSaidAndFlaggedAndLewisFormsStandIn) {
  static_cast<void>(barge("barge.toml"));
  compile("barge.toml", "good.qst");
  const std::string light = kHull + " motions barge.toml --draught-aft-m 1.8 --draught-fwd-m 1.8" + kMotions;
  const Outcome outside = run(light + " --table good.qst");
  EXPECT_EQ(outside.exit_code, 0) << outside.err;
  expect_line("outside", outside.err.substr(0, outside.err.size() - 1),
              {"good.qst: waterlines from 2 to 2 m", "1.8 m aft", "Lewis forms stand in"});
  EXPECT_NE(outside.out.find("outside_hull_table"), std::string::npos) << outside.out;
  const Outcome lewis = run(light);
  const std::string numbers = lewis.out.substr(0, lewis.out.rfind(','));
  EXPECT_EQ(outside.out.substr(0, numbers.size()), numbers);
  const Outcome inside = run(kHull + " motions barge.toml" + kMotions + " --table good.qst");
  EXPECT_EQ(inside.err, "");
  EXPECT_EQ(inside.out.find("outside_hull_table"), std::string::npos) << inside.out;
}

TEST_F(HullTables, TheAdvisorSaysAtTheStartWhichTableItUses) {
  static_cast<void>(barge("barge.toml"));
  const Outcome made =
      run(kHull + " compile barge.toml --sections lewis --draughts 1.9,2,2.1 --out good.qst");
  const std::string checksum = made.out.substr(made.out.rfind("0x") + 2, 16);
  const Outcome live = run("timeout --preserve-status -s TERM 3 " + kAdvisor +
                           " --hull barge.toml --url memq:// --table good.qst");
  EXPECT_EQ(live.exit_code, 0) << live.err;
  EXPECT_NE(
      live.err.find("good.qst: hull table " + checksum + ", 3 levels from 1.9 to 2.1 m; by quickstrip-hull "),
      std::string::npos)
      << live.err;
  EXPECT_NE(live.err.find("barge, lewis sections, 0 of 9 sections flagged"), std::string::npos) << live.err;
}

}  // namespace
}  // namespace quickstrip::test
