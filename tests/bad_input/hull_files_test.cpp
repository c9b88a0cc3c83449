// Hull files with everything wrong, one thing at a time: the S-175's file, edited.
#include <algorithm>
#include <chrono>
#include <memory>

#include "core/hull/hull.hpp"
#include "msgs/files/hull_file.hpp"
#include "tests/bad_input/edited_text.hpp"

namespace quickstrip::test {
namespace {

using List = std::vector<WrongText>;

class BadHullFile : public testing::Test {
 protected:
  static std::string line_of(const std::string& text) {
    const auto hull = std::make_unique<Hull>();
    return parse_hull(text, "ship.toml", *hull).line();
  }
  void expect_each(const List& list) const {
    for (const WrongText& wrong : list) {
      expect_line(wrong.what, line_of(edited(good_, wrong.from, wrong.to)), wrong.words);
    }
  }
  /// The file with other stations.
  [[nodiscard]] std::string with_stations(const std::string& stations) const {
    return good_.substr(0, good_.find("[[station]]")) + stations + good_.substr(good_.find("[loading]"));
  }
  static std::string station(double x) {
    return "[[station]]\nx_m = " + std::to_string(x) + "\noffsets_m = [[12.7, 0.0], [12.7, 11.0]]\n";
  }

  // Her roll damped by a ratio, which needs a number.
  std::string good_ = edited(source_text("sim/hulls/s175.hull.toml"), "method = \"ikeda\"",
                             "method = \"ratio\"\nratio = 0.05");
};

const std::string kLpp = "lpp_m = 175.0";
const std::string kKg = "kg_m = 9.55";

TEST_F(BadHullFile, TheGoodOneIsTakenAlsoWithAByteOrderMarkAndDosLineEnds) {
  EXPECT_EQ(line_of(good_), "");
  EXPECT_EQ(line_of("\xEF\xBB\xBF" + good_), "");
  std::string dos;
  for (const char c : good_) {
    dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  EXPECT_EQ(line_of(dos), "");
}

TEST_F(BadHullFile, NumbersThatAreNoneOrAbsurdAreRefusedWithFieldValueAndRange) {
  expect_each({
      {"missing", kLpp + "\n", "", {"ship.toml: particulars.lpp_m: missing", "1 to 500 m"}},
      {"nan", kLpp, "lpp_m = nan", {"particulars.lpp_m = nan", "1 to 500 m", "line 8"}},
      {"inf", kLpp, "lpp_m = -inf", {"particulars.lpp_m = -inf", "1 to 500 m"}},
      {"negative", kLpp, "lpp_m = -175.0", {"particulars.lpp_m = -175", "1 to 500 m"}},
      {"1e308", kLpp, "lpp_m = 1e308", {"particulars.lpp_m = 1e+308", "1 to 500 m"}},
      {"beyond double", kLpp, "lpp_m = 1e400", {"line 8", "1e400"}},
      {"beyond 64 bits", kLpp, "lpp_m = 99999999999999999999", {"line 8", "64 bits"}},
      {"text", kLpp, "lpp_m = \"175\"", {"particulars.lpp_m = \"175\"", "a number"}},
      {"boolean", kLpp, "lpp_m = true", {"particulars.lpp_m = true", "a number"}},
      {"list", kLpp, "lpp_m = [175.0]", {"particulars.lpp_m = [175.0]", "a number"}},
      {"table", kLpp, "lpp_m = { m = 175.0 }", {"particulars.lpp_m = {...}", "a number"}},
      {"date", kLpp, "lpp_m = 2019-01-01", {"particulars.lpp_m = 2019-01-01", "a number"}},
      {"decimal comma", kLpp, "lpp_m = 175,0", {"line 8", "','"}},
      {"with unit", kLpp, "lpp_m = 175 m", {"line 8", "'m'"}},
      {"swapped",
       kLpp + "\nbreadth_m = 25.4",
       "lpp_m = 25.4\nbreadth_m = 175.0",
       {"particulars.breadth_m = 175"}},
      {"breadth above length", "breadth_m = 25.4", "breadth_m = 25.4\n[x]\n", {"x = {...}", "unknown key"}},
      {"t/m3",
       kKg,
       kKg + "\nwater_density_kg_m3 = 1.025",
       {"water_density_kg_m3 = 1.025", "950 to 1060 kg/m3"}},
      {"gravity", kKg, kKg + "\ngravity_m_s2 = 0", {"gravity_m_s2 = 0", "9.7 to 9.9 m/s2"}},
      {"viscosity in mm2/s", kKg, kKg + "\nviscosity_m2_s = 1.19", {"viscosity_m2_s = 1.19", "m2/s"}},
      {"roll period",
       kKg,
       kKg + "\nmeasured_roll_period_s = 0",
       {"measured_roll_period_s = 0", "0.5 to 80 s"}},
      {"per cent", "ratio = 0.05", "ratio = 5", {"roll_damping.ratio = 5", "0 to 0.5 of critical"}},
      {"damping nan", "ratio = 0.05", "ratio = nan", {"roll_damping.ratio = nan"}},
      {"steerage",
       "min_steerage_kn = 3.0",
       "min_steerage_kn = -3",
       {"handling.min_steerage_kn = -3", "0 to 15 kn"}},
      {"propeller", "tip_z_m = 6.5", "tip_z_m = 65", {"propeller.tip_z_m = 65", "m above the base line"}},
  });
}

TEST_F(BadHullFile, KeysThatAreMissingUnknownMisspeltOrDoubleAreRefusedByName) {
  expect_each({
      {"no schema", "schema = 1\n", "", {"schema: missing", "schema = 1 is wanted"}},
      {"schema of tomorrow", "schema = 1", "schema = 2", {"schema = 2", "schema = 1 is wanted"}},
      {"schema as text", "schema = 1", "schema = \"1\"", {"schema = \"1\"", "schema = 1 is wanted"}},
      {"misspelt",
       "roll_gyradius_m",
       "roll_giradius_m",
       {"loading.roll_giradius_m = 8.331", "roll_gyradius_m"}},
      {"wrong unit", "kg_m = 9.55", "kg_cm = 955", {"loading.kg_cm = 955", "nearest known one is kg_m"}},
      {"unknown table", "", "\n[rudder]\narea_m2 = 5\n", {"rudder = {...}", "unknown key"}},
      {"misspelt table", "[particulars]", "[particular]", {"particular", "nearest known one is particulars"}},
      {"control character", kKg, "\"kg\\nm\" = 9.55", {"loading.kg?m", "unknown key"}},
      {"endless", kKg, std::string(5000, 'x') + " = 9.55", {"loading.xxxxx", "... = 9.55: unknown key"}},
      {"twice", kKg, kKg + "\nkg_m = 9.5", {"line 190", "kg_m"}},
      {"table twice", "", "\n[loading]\nkg_m = 9\n", {"cannot redefine", "loading"}},
      {"no table", "[loading]", "[[loading]]", {"loading", "a table [loading] is wanted"}},
      {"role",
       "role = \"bridge\"",
       "role = \"brigde\"",
       {"point[1].role = \"brigde\"", "nearest is \"bridge\""}},
      {"role as number", "role = \"fp\"", "role = 1", {"point[2].role = 1", "\"passengers\""}},
      {"method", "\"ratio\"", "\"Ratio\"", {"roll_damping.method = \"Ratio\"", "nearest is \"ratio\""}},
      {"ratio missing", "ratio = 0.05", "", {"roll_damping.ratio: missing"}},
      {"no name", "name = \"S-175 container ship\"\n", "", {"name: missing", "text in quotes"}},
      {"empty name", "\"S-175 container ship\"", "\"\"", {"name = \"\"", "1 to 31 bytes"}},
      {"long name", "\"S-175 container ship\"", "\"" + std::string(32, 'x') + "\"", {"1 to 31 bytes", "32"}},
      {"two lines",
       "\"S-175 container ship\"",
       "\"a\\nb\"",
       {"name = \"a?b\"", "without control characters"}},
      {"escape",
       "\"S-175 container ship\"",
       "\"a\\u001Bb\"",
       {"name = \"a?b\"", "without control characters"}},
      {"delete",
       "\"S-175 container ship\"",
       "\"a\\u007Fb\"",
       {"name = \"a?b\"", "without control characters"}},
      {"C1",
       "\"S-175 container ship\"",
       "\"a\\u0085b\"",
       {"name = \"a" + std::string(2, '?') + "b\"", "without control characters"}},
      {"one name twice",
       "\"forward perpendicular\"",
       "\"bridge\"",
       {"point[2].name = \"bridge\"", "of its own"}},
  });
}

TEST_F(BadHullFile, StationsThatMakeNoShipAreRefused) {
  const std::string first = "[0.0, 9.02], [0.43, 9.26], [0.85, 9.5], [1.97, 10.25], [2.83, 11.0]";
  expect_each({
      {"two at one x", "x_m = 4.375", "x_m = 0.0", {"station[3].x_m = 0", "station[2] has the same"}},
      {"almost", "x_m = 4.375", "x_m = 1e-10", {"station[3].x_m = 1e-10", "station[2] has almost the same"}},
      {"far ahead", "x_m = 4.375", "x_m = 4375", {"station[3].x_m = 4375", "-35 to 210 m"}},
      {"nan", "x_m = 4.375", "x_m = nan", {"station[3].x_m = nan"}},
      {"downwards",
       "[0.0, 9.02], [0.43, 9.26]",
       "[0.43, 9.26], [0.0, 9.02]",
       {"station[1].offsets_m[2] = [0.0, 9.02]", "at least 9.26", "keel to deck"}},
      {"triple",
       "[0.43, 9.26]",
       "[0.43, 9.26, 1.0]",
       {"station[1].offsets_m[2] = [0.43, 9.26, 1.0]", "a pair"}},
      {"negative", "[0.43, 9.26]", "[-0.43, 9.26]", {"station[1].offsets_m[2][1] = -0.43", "half-breadth"}},
      {"beyond the breadth",
       "[0.43, 9.26]",
       "[25.4, 9.26]",
       {"station[1].offsets_m[2][1] = 25.4", "half-breadth"}},
      {"millimetres", "[0.43, 9.26]", "[0.43, 9260]", {"station[1].offsets_m[2][2] = 9260", "m (height)"}},
      {"nan", "[0.43, 9.26]", "[nan, 9.26]", {"station[1].offsets_m[2][1] = nan"}},
      {"text", "[0.43, 9.26]", "[\"0.43\", 9.26]", {"station[1].offsets_m[2][1] = \"0.43\""}},
      {"one point", first, "[0.0, 9.02]", {"station[1].offsets_m", "at least two points"}},
      {"none", first, "", {"station[1].offsets_m = []", "a list of pairs"}},
      {"flat", first, "[0.0, 9.02], [1.0, 9.02]", {"station[1].offsets_m", "different height"}},
      {"two forms", "x_m = 4.375", "x_m = 4.375\narea_m2 = 5", {"station[3].area_m2 = 5", "not both"}},
      {"too narrow for the breadth",
       "breadth_m = 25.4",
       "breadth_m = 50.8",
       {"particulars.breadth_m = 50.8", "the widest has 25.4 m"}},
      {"too short for the length", kLpp, "lpp_m = 300.0", {"particulars.lpp_m = 300", "-1.6625 to 175"}},
  });
  expect_line("none", line_of(with_stations("")), {"station: 0 given", "at least three"});
  expect_line("one", line_of(with_stations(station(0))), {"station: 1 given", "at least three"});
  expect_line("two", line_of(with_stations(station(0) + station(175))), {"station: 2 given"});
  expect_line("a table", line_of(with_stations("[station]\nx_m = 0\n")), {"station = {...}", "[[station]]"});
  std::string offsets;
  for (int i = 0; i < 129; ++i) {
    offsets += "[1.0, " + std::to_string(0.08 * i) + "],";
  }
  expect_line("129 offsets",
              line_of(with_stations(station(1) + station(2) + "[[station]]\nx_m = 0\noffsets_m = [" +
                                    offsets + "]\n")),
              {"station[3].offsets_m: 129 pairs given", "at most 128"});
}

TEST_F(BadHullFile, TenThousandStationsAreRefusedInALineAndAtOnce) {
  std::string stations;
  for (int i = 0; i < 10'000; ++i) {
    stations += station(0.0175 * i);
  }
  const auto start = std::chrono::steady_clock::now();
  expect_line("ten thousand", line_of(with_stations(stations)), {"station: 10000 given", "at most 64"});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 20.0);  // 0.1 s here; a sanitizer on a busy machine takes a hundred times that
}

TEST_F(BadHullFile, LoadingsThatCannotBeAreRefused) {
  expect_each({
      {"no draught",
       "draught_aft_m = 9.5",
       "draught_aft_m = 0.0",
       {"loading.draught_aft_m = 0", "0.254 to 40 m"}},
      {"hardly any",
       "draught_fwd_m = 9.5",
       "draught_fwd_m = 0.02",
       {"loading.draught_fwd_m = 0.02", "0.254 to 40 m"}},
      {"negative", "draught_aft_m = 9.5", "draught_aft_m = -9.5", {"loading.draught_aft_m = -9.5"}},
      {"above the deck",
       "draught_aft_m = 9.5",
       "draught_aft_m = 12",
       {"draught_aft_m = 12", "highest offset, 11 m"}},
      {"bow out",
       "draught_fwd_m = 9.5",
       "draught_fwd_m = 0.5",
       {"loading.draught_fwd_m = 0.5", "within 8.75 m"}},
      {"KG 0", kKg, "kg_m = 0", {"loading.kg_m = 0", "above the base line"}},
      {"KG above sense", kKg, "kg_m = 95.5", {"loading.kg_m = 95.5", "0.001 to 50.8 m"}},
      {"GM below zero", kKg, kKg + "\ngm_m = -0.3", {"loading.gm_m = -0.3", "GM must be positive"}},
      {"GM zero", kKg, kKg + "\ngm_m = 0", {"loading.gm_m = 0", "GM must be positive"}},
      {"correction", "_correction_m = 0.0", "_correction_m = -1", {"loading.free_surface_correction_m = -1"}},
      {"gyradius of the ship",
       "roll_gyradius_m = 8.331",
       "roll_gyradius_m = 30",
       {"roll_gyradius_m = 30", "19.05 m"}},
      {"a share for metres",
       "roll_gyradius_m = 8.331",
       "roll_gyradius_m = 0.328",
       {"= 0.328", "3.81 to 19.05 m"}},
      {"pitch",
       "pitch_gyradius_m = 42.0",
       "pitch_gyradius_m = 200",
       {"pitch_gyradius_m = 200", "17.5 to 87.5 m"}},
      {"swapped", "roll_gyradius_m = 8.331", "roll_gyradius_m = 42", {"roll_gyradius_m = 42"}},
      {"keel swapped",
       "x_aft_m = 61.0, x_fwd_m = 114.0",
       "x_aft_m = 114.0, x_fwd_m = 61.0",
       {"bilge_keel.x_fwd_m = 61", "more than x_aft_m = 114", "swapped?"}},
      {"keel of metres", "breadth_m = 0.35 }", "breadth_m = 35 }", {"bilge_keel.breadth_m = 35", "1.9 m"}},
      {"keel deeper than the ship",
       "breadth_m = 0.35 }",
       "breadth_m = 2.1 }",
       {"bilge_keel.breadth_m = 2.1", "1.9 m", "a fifth of the draught"}},
      {"keel without breadth",
       "breadth_m = 0.35 }",
       "breadth_m = 0 }",
       {"bilge_keel.breadth_m = 0", "0.0001 to 1.9 m"}},
      {"keel longer than the ship",
       "x_aft_m = 61.0, x_fwd_m = 114.0",
       "x_aft_m = -20.0, x_fwd_m = 200.0",
       {"bilge_keel.x_aft_m = -20", "-1.6625 to 175 m", "where the ship has stations"}},
      {"keel off the bow",
       "x_fwd_m = 114.0",
       "x_fwd_m = 180",
       {"bilge_keel.x_fwd_m = 180", "-1.6625 to 175 m"}},
      {"keel far off",
       "x_fwd_m = 114.0",
       "x_fwd_m = 1140",
       {"bilge_keel.x_fwd_m = 1140", "-1.6625 to 175 m"}},
  });
}

TEST_F(BadHullFile, PlacesOffTheShipAndGridsLargerThanCapacityAreRefused) {
  const auto many = [](const std::string& table, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
      text += table + "name = \"p" + std::to_string(i) + "\"\n";
    }
    return text;
  };
  expect_each({
      {"high", "z_m = 35.0", "z_m = 3500", {"point[1].z_m = 3500", "0 to 150 m"}},
      {"abeam", "y_m = 0.0", "y_m = 100", {"point[1].y_m = 100", "-15.24 to 15.24 m to port"}},
      {"outside the side", "y_m = 0.0", "y_m = -16", {"point[1].y_m = -16", "-15.24 to 15.24 m"}},
      {"ahead", "x_m = 30.0", "x_m = 300.0", {"point[1].x_m = 300", "-10.4125 to 183.75 m"}},
      {"astern", "x_m = 30.0", "x_m = -30.0", {"point[1].x_m = -30", "-10.4125 to 183.75 m"}},
      {"under the keel", "z_m = 35.0", "z_m = -1", {"point[1].z_m = -1", "above the base line"}},
      {"slamming behind the ship",
       "\"bow\"\nx_m = 157.5",
       "\"bow\"\nx_m = -10.0",
       {"slamming[1].x_m = -10", "-1.6625 to 175 m", "between the first and the last station"}},
      {"slamming ahead of the ship",
       "\"bow\"\nx_m = 157.5",
       "\"bow\"\nx_m = 176",
       {"slamming[1].x_m = 176", "-1.6625 to 175"}},
      {"freeboard ahead",
       "x_m = 175.0\nheight_m",
       "x_m = 195.0\nheight_m",
       {"freeboard[1].x_m = 195", "-10.4125 to 183.75"}},
      {"propeller above water",
       "tip_z_m = 6.5",
       "tip_z_m = 9.6",
       {"propeller.tip_z_m = 9.6", "below the waterline there, 9.5 m"}},
      {"propeller ashore", "x_m = 4.0", "x_m = -40", {"propeller.x_m = -40", "-10.4125 to 183.75 m"}},
      {"15 points more",
       "",
       many("[[point]]\nrole = \"deck\"\nx_m = 1\nz_m = 1\n", 15),
       {"point: 17 given", "16"}},
      {"9 slamming", "", many("[[slamming]]\nx_m = 1\n", 9), {"slamming: 10 given", "at most 8"}},
      {"9 freeboard",
       "",
       many("[[freeboard]]\nx_m = 1\nheight_m = 20\n", 9),
       {"freeboard: 10 given", "at most 8"}},
      {"awash",
       "height_m = 16.0",
       "height_m = 9",
       {"freeboard[1].height_m = 9", "above the waterline there, 9.5 m"}},
      {"step 0", "step = 1.0", "step = 0", {"grid.speeds_kn.step = 0", "0.1 to 60 kn"}},
      {"backwards", "step = 1.0", "step = -1", {"grid.speeds_kn.step = -1"}},
      {"26 speeds", "to = 24.0", "to = 25.0", {"at most 25 speeds", "26"}},
      {"descending", "from = 0.0, to = 24.0", "from = 24.0, to = 0.0", {"grid.speeds_kn.to = 0", "swapped?"}},
      {"not dividing", "step = 1.0", "step = 7", {"grid.speeds_kn.step = 7", "divides 24"}},
      {"nan", "to = 24.0", "to = nan", {"grid.speeds_kn.to = nan"}},
      {"100 kn", "to = 24.0", "to = 100", {"grid.speeds_kn.to = 100", "0 to 60 kn"}},
      {"7 degrees", "_step_deg = 5.0", "_step_deg = 7", {"grid.heading_step_deg = 7", "divides 360"}},
      {"25 degrees", "_step_deg = 5.0", "_step_deg = 25", {"grid.heading_step_deg = 25", "divides 360"}},
      {"1 degree", "_step_deg = 5.0", "_step_deg = 1", {"grid.heading_step_deg = 1", "5 to 90 degrees"}},
      {"725 degrees",
       "_step_deg = 5.0",
       "_step_deg = 725",
       {"grid.heading_step_deg = 725", "5 to 90 degrees"}},
      {"0 degrees", "_step_deg = 5.0", "_step_deg = 0", {"grid.heading_step_deg = 0", "5 to 90 degrees"}},
      {"a misspelt key",
       "heading_step_deg",
       "headings_step_deg",
       {"grid.headings_step_deg", "heading_step_deg"}},
  });
}

}  // namespace
}  // namespace quickstrip::test
