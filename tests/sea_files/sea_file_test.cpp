#include "sim/sea_files/sea_file.hpp"

#include <gtest/gtest.h>

#include "sim/sea_files/utc_time.hpp"
#include "tests/sea_files/temporary_folder.hpp"

namespace quickstrip {
namespace {

using testing::TemporaryFolder;

constexpr const char* kText =
    "quickstrip-sea 1\n"
    "# a comment\n"
    "source a buoy at sea\n"
    "frequencies_hz 0.05 0.1 0.15\n"
    "\n"
    "hour 2019-09-04T12:40:00Z\n"
    "density_m2_hz 0 2.25 0.01\n"
    "alpha1_deg 10 359 360\n"
    "alpha2_deg 20 180 0\n"
    "r1_percent 80 70 60\n"
    "r2_percent 50 40 30\n"
    "hour 2019-09-04T13:40Z\n"
    "density_m2_hz 0 3 0.01\n"
    "alpha1_deg 10 359 360\n"
    "alpha2_deg 20 180 0\n"
    "r1_percent 80 70 60\n"
    "r2_percent 50 40 30\n";

std::string replaced(const std::string& what, const std::string& by) {
  std::string text = kText;
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(SeaFile, ReadsWhatTheFormatSays) {
  BuoyRecord record;
  const FileStatus status = parse_sea_file(kText, "x.sea", record);
  ASSERT_TRUE(status) << status.line();
  EXPECT_EQ(record.source, "a buoy at sea");
  EXPECT_EQ(record.frequencies_hz, (std::vector<double>{0.05, 0.1, 0.15}));
  ASSERT_EQ(record.hours.size(), 2U);
  EXPECT_EQ(record.hours[1].utime_us, *parse_utc("2019-09-04T13:40Z"));
  EXPECT_EQ(record.hours[0].density_m2_hz, (std::vector<double>{0, 2.25, 0.01}));
  EXPECT_EQ(record.hours[0].alpha1_deg, (std::vector<double>{10, 359, 360}));
  EXPECT_EQ(record.hours[0].r2_percent, (std::vector<double>{50, 40, 30}));
}

TEST(SeaFile, WritesAndReadsBackTheSameRecord) {
  const TemporaryFolder folder;
  BuoyRecord record;
  ASSERT_TRUE(parse_sea_file(kText, "x.sea", record));
  record.hours[0].density_m2_hz[1] = 0.1 + 0.2;  // needs 17 digits
  const auto path = folder.path() / "copy.sea";
  ASSERT_TRUE(write_sea_file(record, path));
  BuoyRecord copy;
  const FileStatus status = read_sea_file(path, copy);
  ASSERT_TRUE(status) << status.line();
  EXPECT_EQ(copy, record);
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
}

TEST(SeaFile, LinesMayEndAsOnWindows) {
  std::string text;
  for (const char* c = kText; *c != '\0'; ++c) {
    text += *c == '\n' ? "\r\n" : std::string(1, *c);
  }
  BuoyRecord windows;
  BuoyRecord unix_like;
  ASSERT_TRUE(parse_sea_file(text, "x.sea", windows));
  ASSERT_TRUE(parse_sea_file(kText, "x.sea", unix_like));
  EXPECT_EQ(windows, unix_like);
}

TEST(SeaFile, RefusesInOneLineThatNamesFileLineFieldAndValue) {
  const auto expect = [](const std::string& what, const std::string& by, const std::string& start) {
    BuoyRecord record;
    const std::string line = parse_sea_file(replaced(what, by), "x.sea", record).line();
    EXPECT_TRUE(line.starts_with("x.sea:" + start)) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_TRUE(record.hours.empty());
  };
  expect("sea 1", "sea 2", "1: title = quickstrip-sea 2: ");
  expect("source a buoy at sea\n", "", "3: line = frequencies_hz: the line source");
  expect("0.1 0.15", "0.1 0.1", "4: frequencies_hz = 0.1: ");
  expect("0.1 0.15", "0.1", "4: frequencies_hz = 2 numbers: ");
  expect("2.25", "-2.25", "7: density_m2_hz = -2.25: ");
  expect("2.25", "nan", "7: density_m2_hz = nan: ");
  expect("2.25", "2,25", "7: density_m2_hz = 2,25: ");
  expect("0 2.25 0.01", "0 2.25", "7: density_m2_hz = 2 numbers: 3 are needed");
  expect("0 2.25 0.01", "0 0 0", "11: hour = 2019-09-04T12:40:00Z: some energy");
  expect("10 359", "10 361", "8: alpha1_deg = 361: ");
  expect("80 70", "101 70", "10: r1_percent = 101: ");
  expect("alpha2_deg", "alpha3_deg", "9: line = alpha3_deg: the line alpha2_deg is needed here");
  expect("T13:40Z", "T12:40Z", "12: hour = 2019-09-04T12:40Z: a time after 2019-09-04T12:40:00Z");
  expect("T13:40Z", "T13:40", "12: hour = hour 2019-09-04T13:40: ");
}

TEST(SeaFile, RefusesAFileThatIsCutShortAtAnyLine) {
  const std::string text = kText;
  for (std::size_t at = text.find('\n'); at + 1 < text.size(); at = text.find('\n', at + 1)) {
    const std::string head = text.substr(0, at + 1);
    BuoyRecord record;
    const bool complete = head.ends_with("r2_percent 50 40 30\n");
    EXPECT_EQ(parse_sea_file(head, "x.sea", record).ok(), complete) << head;
  }
}

TEST(SeaFile, RefusesWhatIsNotThere) {
  BuoyRecord record;
  EXPECT_TRUE(read_sea_file("/nowhere/x.sea", record).line().starts_with("/nowhere/x.sea: no such file"));
  EXPECT_FALSE(read_sea_file(std::filesystem::temp_directory_path(), record));
  ASSERT_TRUE(parse_sea_file(kText, "x.sea", record));
  EXPECT_FALSE(write_sea_file(record, "/nowhere/x.sea"));
}

}  // namespace
}  // namespace quickstrip
