// Limits, voyage and sea files with everything wrong, and what no reader takes: folders, binaries, gigabytes.
#include <functional>
#include <memory>

#include "core/hull/hull.hpp"
#include "msgs/files/hull_file.hpp"
#include "msgs/files/limits_file.hpp"
#include "msgs/files/printable.hpp"
#include "msgs/files/voyage_file.hpp"
#include "sim/sea_files/sea_file.hpp"
#include "tests/bad_input/edited_text.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::test {
namespace {

using List = std::vector<WrongText>;

const std::string kLimits = R"(schema = 1
name = "heavy work on deck"
[[criterion]]
name = "roll"
quantity = "roll"
statistic = "rms"
limit_deg = 4.0
[[criterion]]
name = "bridge"
quantity = "vertical_acceleration"
role = "bridge"
statistic = "rms"
limit_g = 0.15
caution_fraction = 0.75
)";

const std::string kVoyage = R"(schema = 1
name = "six hours"
end_utc = 2019-09-02T06:00:00Z
[[leg]]
from_utc = 2019-09-02T00:00:00Z
heading_deg = 75.0
speed_kn = 16.0
[[leg]]
from_utc = 2019-09-02T03:00:00Z
heading_deg = 0
speed_kn = 10
)";

const std::string kSea = R"(quickstrip-sea 1
source buoy
frequencies_hz 0.05 0.1 0.15
hour 2019-08-30T00:40:00Z
density_m2_hz 0 12.5 3
alpha1_deg 51 218 220
alpha2_deg 50 231 360
r1_percent 20 35 90
r2_percent 99 93 80
hour 2019-08-30T01:40Z
density_m2_hz 0 11.5 3
alpha1_deg 51 218 220
alpha2_deg 50 231 360
r1_percent 20 35 90
r2_percent 99 93 80
)";

std::string limits_line(const std::string& text) {
  static const auto hull = std::make_unique<Hull>(s175());
  LimitsProfile out;
  return parse_limits(text, "a.toml", *hull, out).line();
}

std::string voyage_line(const std::string& text) {
  Voyage out;
  return parse_voyage(text, "a.toml", out).line();
}

std::string sea_line(const std::string& text) {
  BuoyRecord out;
  return parse_sea_file(text, "a.sea", out).line();
}

TEST(BadLimitsFile, EverythingWrongIsRefusedByName) {
  EXPECT_EQ(limits_line(kLimits), "");
  const List list = {
      {"no schema", "schema = 1\n", "", {"a.toml: schema: missing", "schema = 1"}},
      {"no limit", "limit_deg = 4.0\n", "", {"criterion[1].limit_deg: missing"}},
      {"nan", "limit_deg = 4.0", "limit_deg = nan", {"criterion[1].limit_deg = nan", "90 degrees"}},
      {"negative", "limit_deg = 4.0", "limit_deg = -4", {"criterion[1].limit_deg = -4"}},
      {"725", "limit_deg = 4.0", "limit_deg = 725", {"criterion[1].limit_deg = 725", "90 degrees"}},
      {"letters swapped",
       "limit_deg",
       "limit_dge",
       {"criterion[1].limit_dge", "nearest known one is limit_deg"}},
      {"of another quantity", "limit_deg = 4.0", "limit_g = 4.0", {"criterion[1].limit_g", "limit_deg"}},
      {"two limits",
       "limit_g = 0.15",
       "limit_g = 0.15\nlimit_m_s2 = 1.5",
       {"criterion[2]", "only one limit"}},
      {"quantity", "\"roll\"\nstat", "\"rolling\"\nstat", {"quantity = \"rolling\"", "nearest is \"roll\""}},
      {"statistic", "\"rms\"", "\"rsm\"", {"criterion[1].statistic = \"rsm\"", "nearest is \"rms\""}},
      {"role", "role = \"bridge\"", "role = \"brig\"", {"criterion[2].role = \"brig\"", "nearest is"}},
      {"place", "role = \"bridge\"", "place = \"crane\"", {"criterion[2].place = \"crane\"", "\"bridge\""}},
      {"fraction", "= 0.75", "= 1.5", {"criterion[2].caution_fraction = 1.5", "0.01 to 1"}},
      {"one name twice",
       "name = \"bridge\"",
       "name = \"roll\"",
       {"criterion[2].name = \"roll\"", "of its own"}},
      {"twice", "limit_deg = 4.0", "limit_deg = 4.0\nlimit_deg = 5.0", {"line 8", "limit_deg"}},
  };
  for (const WrongText& wrong : list) {
    expect_line(wrong.what, limits_line(edited(kLimits, wrong.from, wrong.to)), wrong.words);
  }
  expect_line("none", limits_line("schema = 1\nname = \"x\"\n"), {"criterion: none given"});
  const auto one = [](const std::string& lines) {
    return limits_line("schema = 1\nname = \"x\"\n[[criterion]]\nname = \"c\"\n" + lines);
  };
  const std::string roll = "quantity = \"roll\"\nstatistic = \"rms\"\n";
  const std::string sick = "quantity = \"motion_sickness\"\nstatistic = \"share_of_people\"\n";
  const std::string stand = "quantity = \"motion_interruptions\"\nstatistic = \"per_minute\"\n";
  expect_line("sickness by RMS", one("quantity = \"motion_sickness\"\nstatistic = \"rms\"\nlimit_g = 0.1\n"),
              {"criterion[1].statistic = \"rms\"", "\"share_of_people\""});
  expect_line("roll by the minute", one("quantity = \"roll\"\nstatistic = \"per_minute\"\n"),
              {"criterion[1].statistic = \"per_minute\"", "\"rms\", \"significant\""});
  expect_line("a share as a part", one(sick + "limit_probability = 0.2\n"),
              {"criterion[1].limit_probability = 0.2", "limit_percent"});
  expect_line("200 %", one(sick + "limit_percent = 200\n"),
              {"criterion[1].limit_percent = 200", "99.9 % of people"});
  expect_line("a second", one(sick + "limit_percent = 20\nexposure_min = 0.0167\n"),
              {"criterion[1].exposure_min = 0.0167", "5 to 1440 minutes"});
  expect_line("roll for 4 h", one(roll + "limit_deg = 6\nexposure_min = 240\n"),
              {"criterion[1].exposure_min = 240", "motion_sickness"});
  expect_line("rolling stance", one(roll + "limit_deg = 6\nstance_height_m = 1.2\n"),
              {"criterion[1].stance_height_m = 1.2", "motion_interruptions"});
  expect_line("a giant", one(stand + "limit_per_minute = 1\nstance_height_m = 12\n"),
              {"criterion[1].stance_height_m = 12", "0.5 to 2 m"});
  expect_line("by the hour", one(stand + "limit_per_hour = 60\n"),
              {"criterion[1].limit_per_hour = 60", "limit_per_minute"});
  expect_line("one length", one(roll + "limit_deg_by_length = [[100, 6]]\n"),
              {"criterion[1].limit_deg_by_length[1]", "two lengths"});
  expect_line("lengths", one(roll + "limit_deg_by_length = [[100, 6], [90, 5]]\n"),
              {"criterion[1].limit_deg_by_length[2]", "increasing"});
  expect_line("length and not", one(roll + "limit_deg = 6\nlimit_deg_by_length = [[100, 6], [200, 5]]\n"),
              {"criterion[1].limit_deg_by_length", "only one limit"});
  expect_line("wrong limit by length", one(roll + "limit_deg_by_length = [[100, 6], [200, 900]]\n"),
              {"criterion[1].limit_deg_by_length[2][2] = 900", "90 degrees"});
  expect_line("unit", one(roll + "limit_g_by_length = [[100, 6], [200, 9]]\n"),
              {"criterion[1].limit_g_by_length", "limit_deg"});
  std::string many = kLimits.substr(0, kLimits.find("[["));
  for (int i = 0; i < 33; ++i) {
    many += "[[criterion]]\nname = \"r" + std::to_string(i) +
            "\"\nquantity = \"roll\"\nstatistic = \"rms\"\nlimit_deg = 4\n";
  }
  expect_line("33", limits_line(many), {"criterion: 33 given", "at most 32"});
}

TEST(BadVoyageFile, EverythingWrongIsRefusedByName) {
  EXPECT_EQ(voyage_line(kVoyage), "");
  const List list = {
      {"no end",
       "end_utc = 2019-09-02T06:00:00Z\n",
       "",
       {"a.toml: end_utc: missing", "2019-08-30T00:00:00Z"}},
      {"no zone",
       "end_utc = 2019-09-02T06:00:00Z",
       "end_utc = 2019-09-02T06:00:00",
       {"end_utc", "with its offset"}},
      {"a text",
       "= 2019-09-02T06:00:00Z",
       "= \"2019-09-02T06:00:00Z\"",
       {"end_utc = \"2019", "with its offset"}},
      {"30 February", "= 2019-09-02T06:00:00Z", "= 2019-02-30T06:00:00Z", {"line 3"}},
      {"1900", "= 2019-09-02T06:00:00Z", "= 1900-09-02T06:00:00Z", {"end_utc = 1900", "1970 to 2100"}},
      {"out of order",
       "2019-09-02T03:00:00Z",
       "2019-09-01T03:00:00Z",
       {"leg[2].from_utc", "after that of the leg before"}},
      {"after the end",
       "2019-09-02T03:00:00Z",
       "2019-09-02T06:00:00Z",
       {"leg[2].from_utc", "before end_utc"}},
      {"725", "heading_deg = 75.0", "heading_deg = 725", {"leg[1].heading_deg = 725", "0 to 360 degrees"}},
      {"360",
       "heading_deg = 75.0",
       "heading_deg = 360",
       {"leg[1].heading_deg = 360", "0 is wanted for north"}},
      {"nan", "speed_kn = 16.0", "speed_kn = nan", {"leg[1].speed_kn = nan", "0 to 60 kn"}},
      {"astern", "speed_kn = 16.0", "speed_kn = -5", {"leg[1].speed_kn = -5"}},
      {"misspelt",
       "speed_kn = 16.0",
       "speed_kt = 16.0",
       {"leg[1].speed_kt", "nearest known one is speed_kn"}},
  };
  for (const WrongText& wrong : list) {
    expect_line(wrong.what, voyage_line(edited(kVoyage, wrong.from, wrong.to)), wrong.words);
  }
  expect_line("no leg", voyage_line(kVoyage.substr(0, kVoyage.find("[["))), {"leg: none given"});
}

TEST(BadSeaFile, EverythingWrongIsRefusedByLineAndName) {
  EXPECT_EQ(sea_line(kSea), "");
  EXPECT_EQ(sea_line("\xEF\xBB\xBF" + kSea), "") << "byte order mark";
  const List list = {
      {"version",
       "quickstrip-sea 1",
       "quickstrip-sea 2",
       {"a.sea:1: title = quickstrip-sea 2", "quickstrip-sea 1"}},
      {"no source", "source buoy\n", "", {"a.sea:2: line = frequencies_hz", "source"}},
      {"two bands", "0.05 0.1 0.15", "0.05 0.1", {"a.sea:3: frequencies_hz = 2 numbers", "3 to 64"}},
      {"descending",
       "0.05 0.1 0.15",
       "0.05 0.15 0.1",
       {"frequencies_hz = 0.1", "above the one before, 0.15"}},
      {"rad/s", "0.05 0.1 0.15", "0.3 0.6 6.28", {"frequencies_hz = 6.28", "0.01 to 2"}},
      {"too slow", "0.05 0.1 0.15", "0.001 0.1 0.15", {"frequencies_hz = 0.001", "0.01 to 2"}},
      {"nan", "density_m2_hz 0 12.5 3", "density_m2_hz 0 nan 3", {"a.sea:5: density_m2_hz = nan", "0 to"}},
      {"negative", "density_m2_hz 0 12.5 3", "density_m2_hz 0 -12.5 3", {"density_m2_hz = -12.5"}},
      {"1e308", "density_m2_hz 0 12.5 3", "density_m2_hz 0 1e308 3", {"density_m2_hz = 1e308"}},
      {"a sea of 40 m",
       "density_m2_hz 0 12.5 3",
       "density_m2_hz 0 2000 3",
       {"density_m2_hz = Hs 40", "at most 30 m"}},
      {"no energy",
       "density_m2_hz 0 12.5 3",
       "density_m2_hz 0 0 0",
       {"hour = 2019-08-30T00:40:00Z", "some energy"}},
      {"one short",
       "alpha1_deg 51 218 220",
       "alpha1_deg 51 218",
       {"a.sea:6: alpha1_deg = 2 numbers", "3 are needed"}},
      {"725", "alpha1_deg 51 218 220", "alpha1_deg 51 725 220", {"alpha1_deg = 725", "0 to 360"}},
      {"per cent", "r1_percent 20 35 90", "r1_percent 20 350 90", {"r1_percent = 350", "0 to 100"}},
      {"out of order",
       "2019-08-30T01:40Z",
       "2019-08-29T01:40Z",
       {"a.sea:10: hour = 2019-08-29T01:40Z", "after"}},
      {"no time", "2019-08-30T01:40Z", "today", {"a.sea:10: hour", "2019-09-04T12:40:00Z"}},
      {"30 February", "2019-08-30T01:40Z", "2019-02-30T01:40Z", {"a.sea:10: hour"}},
      {"rows swapped",
       "alpha1_deg 51 218 220\nalpha2",
       "alpha2",
       {"a.sea:6: line = alpha2_deg", "alpha1_deg"}},
      {"cut off", "r2_percent 99 93 80\nhour", "hour", {"line = hour", "r2_percent"}},
      {"control characters", "hour 2019-08-30T01:40Z", "hour \x1B[2J\x07", {"hour = hour ?[2J?"}},
  };
  for (const WrongText& wrong : list) {
    expect_line(wrong.what, sea_line(edited(kSea, wrong.from, wrong.to)), wrong.words);
  }
}

// toml++ ran into undefined behaviour there (found by fuzzing).
TEST(BadFiles, LettersBeyondAsciiOutsideQuotesAreRefusedAndInsideThemTaken) {
  expect_line("key", voyage_line("höhe = 1\n" + kVoyage), {"a.toml: line 1: ", "ö"});
  expect_line("letter", limits_line("\xC7\x9C"), {"line 1: ", "ǜ"});
  expect_line("value", voyage_line(edited(kVoyage, "= 16.0", "= 16.0°")), {"line 7: ", "°"});
  expect_line("blank", voyage_line(edited(kVoyage, "= 16.0", "=\xC2\xA0\x31")), {"line 7: "});
  expect_line("in a number", voyage_line("a = 5/'\xEF\xB3\xBF\x61"), {"line 1: "});
  expect_line("not UTF-8", voyage_line("\x80\x80" + kVoyage), {"line 1: ", "utf-8"});
  EXPECT_EQ(voyage_line(edited(kVoyage, "\"six hours\"", "\"Sjøreise\" # på 6 timer")), "");
  EXPECT_EQ(voyage_line(edited(kVoyage, "\"six hours\"", "'Sjø\"reise'")), "");
}

struct Reader {
  const char* name;
  std::function<std::string(const std::string& path)> line_of;
};

std::vector<Reader> readers() {
  static const auto hull = std::make_unique<Hull>(s175());
  return {{"hull",
           [](const std::string& path) { return read_hull_file(path, *std::make_unique<Hull>()).line(); }},
          {"limits",
           [](const std::string& path) {
             LimitsProfile out;
             return read_limits_file(path, *hull, out).line();
           }},
          {"voyage",
           [](const std::string& path) {
             Voyage out;
             return read_voyage_file(path, out).line();
           }},
          {"sea", [](const std::string& path) {
             BuoyRecord out;
             return read_sea_file(path, out).line();
           }}};
}

TEST(BadFiles, FoldersDevicesAndNothingAreNoFiles) {
  const Folder folder("files");
  for (const Reader& reader : readers()) {
    const std::string here = folder.path();
    expect_line(reader.name, reader.line_of(here), {here, "a folder: a file is wanted"});
    expect_line(reader.name, reader.line_of(folder.file("none")), {"none: no such file"});
    expect_line(reader.name, reader.line_of(here + "/none/none"), {"no such file"});
    expect_line(reader.name, reader.line_of(""), {"no such file"});
    expect_line(reader.name, reader.line_of("/dev/zero"), {"/dev/zero: not a file"});
    expect_line(reader.name, reader.line_of("a\nb"), {"a?b: no such file"});
  }
}

TEST(BadFiles, EmptyBinaryAndForeignOnesAreRefusedInALine) {
  const Folder folder("content");
  std::string binary;
  for (int i = 0; i < 20'000; ++i) {
    binary += static_cast<char>((static_cast<unsigned>(i) * 2'654'435'761u >> 7) & 0xFFu);
  }
  std::string wide;
  for (const char c : kVoyage) {
    wide += std::string(1, c) + std::string(1, '\0');
  }
  for (const Reader& reader : readers()) {
    expect_line("empty", reader.line_of(folder.file("empty", "")), {"empty"});
    expect_line("blank", reader.line_of(folder.file("blank", "\n\n\n")), {"blank"});
    expect_line("binary", reader.line_of(folder.file("binary", binary)), {"binary"});
    expect_line("UTF-16", reader.line_of(folder.file("utf16", "\xFF\xFE" + wide)), {"utf16"});
    expect_line("brackets", reader.line_of(folder.file("nested", "a=" + std::string(100'000, '['))),
                {"nested"});
    expect_line("a long line", reader.line_of(folder.file("line", std::string(500'000, 'x'))), {"line"});
  }
}

TEST(BadFiles, AGigabyteIsRefusedUnread) {
  const Folder folder("big");
  const std::string path = folder.file("big", "");
  std::filesystem::resize_file(path, 1'000'000'000);  // sparse: takes no room
  for (const Reader& reader : readers()) {
    expect_line(reader.name, reader.line_of(path), {"1000000000 bytes", "at most"});
  }
}

TEST(Printable, KeepsUtf8ReplacesControlsAndWhatIsNotUtf8AndCutsBetweenCharacters) {
  EXPECT_EQ(printable("Sjø 5°"), "Sjø 5°");
  EXPECT_EQ(printable("a\n\r\t\x1B\x7F"
                      "b"),
            "a?????b");
  EXPECT_EQ(printable("\xC2\x85 \xC0\x80 \xFF \xE2\x82"), "?? ?? ? ??");
  EXPECT_EQ(printable("°°°", 5), "°°...");
  EXPECT_EQ(printable(std::string(100, 'x'), 10), "xxxxxxxxxx...");
}

}  // namespace
}  // namespace quickstrip::test
