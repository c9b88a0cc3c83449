#include "sim/sea_files/ndbc_import.hpp"

#include <gtest/gtest.h>

#include "sim/sea_files/sea_series.hpp"
#include "sim/sea_files/utc_time.hpp"
#include "tests/sea_files/temporary_folder.hpp"

namespace quickstrip {
namespace {

using testing::TemporaryFolder;

constexpr const char* kHeader = "#YY  MM DD hh mm  .0500  .1000  .1500  .2000\n";

// Four bands, three hours; the energy of the bands at 2 m2/Hz is 0.05, 0.1, 0.1, 0.05 m2.
struct Files {
  std::string w = std::string(kHeader) +
                  "2019 09 04 10 40   2.00   2.00   2.00   2.00\n"
                  "2019 09 04 11 40   0.01   2.00   2.00   2.00\n"
                  "2019 09 04 12 40   3.00   2.00   2.00   2.00\n";
  std::string d = hours(" 45 90 135 180");
  std::string i = hours(" 40 95 130 185");
  std::string j = hours(" 80 70 60 50");
  std::string k = hours(" 50 40 30 20");

  static std::string hours(const std::string& values) {
    std::string text = kHeader;
    for (const char* time : {"2019 09 04 10 40", "2019 09 04 11 40", "2019 09 04 12 40"}) {
      text += time + values + "\n";
    }
    return text;
  }
  FileStatus import(BuoyRecord& record, NdbcNotes& notes) const {
    const TemporaryFolder folder;
    folder.write("b_41010w_2019.txt", w);
    folder.write("b_41010d_2019.txt", d);
    folder.write("b_41010i_2019.txt", i);
    folder.write("b_41010j_2019.txt", j);
    folder.write("b_41010k_2019.txt", k);
    folder.write("b_41010west.txt", "another file\n");  // a letter after the letter: not one of the five
    return import_ndbc((folder.path() / "b_41010").string(), record, notes);
  }
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(NdbcImport, ReadsTheFiveFiles) {
  BuoyRecord record;
  NdbcNotes notes;
  const FileStatus status = Files{}.import(record, notes);
  ASSERT_TRUE(status) << status.line();
  ASSERT_EQ(record.hours.size(), 3U);
  EXPECT_EQ(notes.num_gaps, 0U);
  EXPECT_EQ(record.frequencies_hz, (std::vector<double>{0.05, 0.1, 0.15, 0.2}));
  EXPECT_EQ(record.hours[2].utime_us, *parse_utc("2019-09-04T12:40Z"));
  EXPECT_EQ(record.hours[2].density_m2_hz, (std::vector<double>{3, 2, 2, 2}));
  EXPECT_EQ(record.hours[0].alpha1_deg, (std::vector<double>{45, 90, 135, 180}));
  EXPECT_EQ(record.hours[0].alpha2_deg, (std::vector<double>{40, 95, 130, 185}));
  EXPECT_EQ(record.hours[0].r1_percent, (std::vector<double>{80, 70, 60, 50}));
  EXPECT_EQ(record.hours[0].r2_percent, (std::vector<double>{50, 40, 30, 20}));
}

TEST(NdbcImport, SourceOfACommandLineNamesThePrefix) {
  const TemporaryFolder folder;
  const Files files;
  folder.write("xw", files.w);
  folder.write("xd", files.d);
  folder.write("xi", files.i);
  folder.write("xj", files.j);
  folder.write("xk", files.k);
  SeaSeries series;
  const FileStatus status = load_sea("ndbc:" + (folder.path() / "x").string(), series);
  ASSERT_TRUE(status) << status.line();
  ASSERT_EQ(series.records.size(), 3U);
  EXPECT_NEAR(series.records[0].hs, 4.0 * std::sqrt(0.3), 1e-12);  // 2 m2/Hz from 0.05 to 0.2 Hz
}

TEST(NdbcImport, MissingDensityIsAGap) {
  Files files;
  files.w = replaced(files.w, "2019 09 04 11 40   0.01", "2019 09 04 11 40 999.00");
  BuoyRecord record;
  NdbcNotes notes;
  ASSERT_TRUE(files.import(record, notes));
  ASSERT_EQ(record.hours.size(), 2U);
  EXPECT_EQ(notes.num_gaps, 1U);
  EXPECT_EQ(record.hours[1].utime_us - record.hours[0].utime_us, 2 * kUtimePerHour);
}

// In the second hour the first band holds 0.00025 of 0.25 m2, in the others 0.05 of 0.3 m2 and more.
TEST(NdbcImport, MissingDirectionIsIsotropicWithoutEnergyAndAGapWithIt) {
  Files files;
  files.d = Files::hours(" 999 90 135 180");
  BuoyRecord record;
  NdbcNotes notes;
  ASSERT_TRUE(files.import(record, notes));
  ASSERT_EQ(record.hours.size(), 1U);
  EXPECT_EQ(notes.num_gaps, 2U);
  EXPECT_EQ(notes.num_isotropic_bands, 1U);
  EXPECT_EQ(record.hours[0].r1_percent, (std::vector<double>{0, 70, 60, 50}));
  EXPECT_EQ(record.hours[0].r2_percent, (std::vector<double>{0, 40, 30, 20}));
}

TEST(NdbcImport, AnHourThatIsNotInAllFilesIsAGap) {
  Files files;
  files.k = replaced(files.k, "2019 09 04 11 40 50 40 30 20\n", "");
  BuoyRecord record;
  NdbcNotes notes;
  ASSERT_TRUE(files.import(record, notes));
  EXPECT_EQ(record.hours.size(), 2U);
  EXPECT_EQ(notes.num_gaps, 1U);
}

TEST(NdbcImport, RefusesInOneLineThatNamesFileLineFieldAndValue) {
  BuoyRecord record;
  NdbcNotes notes;
  const auto line_after = [&](std::string Files::*file, const std::string& what, const std::string& by) {
    Files files;
    files.*file = replaced(files.*file, what, by);
    const std::string line = files.import(record, notes).line();
    EXPECT_EQ(line.find('\n'), std::string::npos);
    return line;
  };
  const auto contains = [](const std::string& line, const std::string& part) {
    EXPECT_NE(line.find(part), std::string::npos) << line;
  };
  contains(line_after(&Files::w, "3.00", "-3.0"), "b_41010w_2019.txt:4: density_m2_hz = -3.0: ");
  contains(line_after(&Files::w, "3.00", "nan"), ":4: density_m2_hz = nan: ");
  contains(line_after(&Files::d, "135", "361"), "b_41010d_2019.txt:2: alpha1_deg = 361: ");
  contains(line_after(&Files::j, "80", "101"), ":2: r1_percent = 101: ");
  contains(line_after(&Files::j, " 50\n", "\n"), ":2: hour = 8 words: 9 are needed");
  contains(line_after(&Files::w, "09 04 11", "09 31 11"), ":3: time = 2019 09 31 11 40: ");
  contains(line_after(&Files::w, "04 11 40", "04 10 40"), ":3: time = 2019-09-04T10:40:00Z: each hour once");
  contains(line_after(&Files::w, ".1500", ".0900"), ":1: band = .0900: ");
  contains(line_after(&Files::k, ".1500", ".1600"), "b_41010k_2019.txt:1: bands");
  EXPECT_NE(import_ndbc("/nowhere/at_all", record, notes).line().find("/nowhere/at_allw*: files = 0: "),
            std::string::npos);
}

}  // namespace
}  // namespace quickstrip
