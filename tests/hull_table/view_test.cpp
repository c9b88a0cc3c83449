// A table that is not whole, or not this ship's: refused with its reason, in memory and as a file.
#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <random>

#include "msgs/files/hull_table_file.hpp"
#include "tests/bad_input/edited_text.hpp"
#include "tests/hull_table/compiled.hpp"

namespace quickstrip::test {
namespace {

using Words = std::vector<std::uint32_t>;

struct Small {
  std::unique_ptr<Hull> hull = thinned_s175(8);
  Compiled made{*hull, HullSections::kLewis, {{9.0, 9.5}, {}}};
};

const Small& small() {
  static const Small kSmall;
  return kSmall;
}

Words good() {
  return small().made.table.words;
}

void seal(Words& words) {
  const std::uint64_t checksum = hull_table_checksum(words);
  words[kWordChecksum] = static_cast<std::uint32_t>(checksum);
  words[kWordChecksum + 1] = static_cast<std::uint32_t>(checksum >> 32U);
}

void expect_refused(const Words& words, Error wanted, const char* what) {
  const Result<HullTable> table = HullTable::view(words);
  ASSERT_FALSE(table.ok()) << what;
  EXPECT_EQ(table.error(), wanted) << what << ": " << message(table.error());
}

TEST(HullTableView, OfAWholeTableSaysWhatItHolds) {
  const HullTable& table = small().made.view;
  EXPECT_EQ(table.num_stations(), small().hull->stations.size());
  EXPECT_EQ(table.num_levels(), 2u);
  EXPECT_FLOAT_EQ(static_cast<float>(table.level(1)), 9.5F);
  EXPECT_EQ(table.sections(), HullSections::kLewis);
  EXPECT_TRUE(table.check_hull(*small().hull).ok());
  const std::string text = provenance_text(table);
  EXPECT_NE(text.find("S-175 container ship, lewis sections"), std::string::npos) << text;
  EXPECT_EQ(text, small().made.table.provenance);
}

TEST(HullTableView, EveryFlippedBitIsFound) {
  std::mt19937 random(20'261'123);
  const Words whole = good();
  for (std::size_t i = 0; i < 2000; ++i) {
    Words words = whole;
    const std::size_t at = i < kHullTableHeaderWords ? i : random() % words.size();
    words[at] ^= 1U << (random() % 32U);
    EXPECT_FALSE(HullTable::view(words).ok()) << "word " << at;
  }
}

TEST(HullTableView, RefusesWhatIsNoTable) {
  expect_refused({}, Error::kHullTableForeign, "nothing");
  expect_refused(Words(10'000, 0x20202020U), Error::kHullTableForeign, "text");
  Words swapped = good();
  for (std::uint32_t& word : swapped) {
    word = (word >> 24U) | ((word >> 8U) & 0xFF00U) | ((word << 8U) & 0xFF0000U) | (word << 24U);
  }
  expect_refused(swapped, Error::kHullTableForeign, "the other byte order");
}

TEST(HullTableView, RefusesAnotherVersionOrLength) {
  Words words = good();
  words[kWordVersion] = kHullTableVersion + 1;
  expect_refused(words, Error::kHullTableVersion, "version");
  words = good();
  words.pop_back();
  expect_refused(words, Error::kHullTableTruncated, "a word less");
  words = good();
  words.push_back(0);
  expect_refused(words, Error::kHullTableTruncated, "a word more");
  words = good();
  words.resize(kHullTableHeaderWords);
  expect_refused(words, Error::kHullTableTruncated, "the header alone");
}

// What a program that writes tables could get wrong, the checksum right.
TEST(HullTableView, RefusesWhatNoCompilerShouldWrite) {
  const std::size_t levels = kHullTableHeaderWords + small().hull->stations.size();
  const std::size_t waves = levels + 2;
  struct Edit {
    const char* what;
    std::size_t at;
    std::uint32_t to;
    Error wanted;
  };
  const auto number = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  const std::vector<Edit> edits = {
      {"a NaN", waves + 400, number(std::numeric_limits<float>::quiet_NaN()), Error::kHullTableCorrupt},
      {"an infinity", waves + 400, number(std::numeric_limits<float>::infinity()), Error::kHullTableCorrupt},
      {"a number that no section has", waves + 400, number(1e10F), Error::kHullTableCorrupt},
      {"levels that fall", levels + 1, number(8.0F), Error::kHullTableCorrupt},
      {"levels alike", levels + 1, number(9.0F), Error::kHullTableCorrupt},
      {"waves out of order", waves + 5, number(1e-6F), Error::kHullTableCorrupt},
      {"a negative frequency", waves + kHullTableWaves, number(-1.0F), Error::kHullTableCorrupt},
      {"no level", kWordLevels, 0, Error::kHullTableCorrupt},
      {"a level too many", kWordLevels, 3, Error::kHullTableCorrupt},
      {"many levels", kWordLevels, 0x7FFFFFFF, Error::kTooMany},
      {"many stations", kWordStations, 0xFFFFFFFF, Error::kTooMany},
      {"sections of no kind", kWordSections, 3, Error::kHullTableCorrupt},
  };
  for (const Edit& edit : edits) {
    Words words = good();
    words[edit.at] = edit.to;
    seal(words);
    expect_refused(words, edit.wanted, edit.what);
  }
}

TEST(HullTableView, IsOfOneGeometryWhateverItsLoading) {
  auto hull = std::make_unique<Hull>(*small().hull);
  hull->loading.draught_aft = 9.1;
  hull->loading.kg = 8.0;
  hull->points.clear();
  EXPECT_TRUE(small().made.view.check_hull(*hull).ok());
  hull->stations[2].offsets[3].y += 1e-3;
  const Status changed = small().made.view.check_hull(*hull);
  ASSERT_FALSE(changed.ok());
  EXPECT_EQ(changed.error(), Error::kHullTableOtherHull);
}

class HullTableFile : public testing::Test {
 protected:
  std::string bytes(const Words& words) {
    std::string out(4 * words.size(), '\0');
    std::memcpy(out.data(), words.data(), out.size());
    return out;
  }
  void expect_line_for(const char* what, const std::string& path, const std::vector<std::string>& words) {
    std::optional<HullTable> table;
    const FileStatus status = read_hull_table(path, *small().hull, memory_, table);
    EXPECT_FALSE(table.has_value()) << what;
    expect_line(what, status.line(), words);
  }
  Folder folder_{"hull_table"};
  Words memory_ = Words(kMaxHullTableBytes / 4);
};

TEST_F(HullTableFile, ComesBackAsItWasWritten) {
  const std::string path = folder_.file("good.qst");
  ASSERT_TRUE(write_hull_table(good(), path).ok());
  std::optional<HullTable> table;
  const FileStatus status = read_hull_table(path, *small().hull, memory_, table);
  ASSERT_TRUE(status.ok()) << status.line();
  EXPECT_EQ(table->checksum(), small().made.view.checksum());
}

TEST_F(HullTableFile, IsRefusedInOneLineThatNamesItAndTheReason) {
  const std::string whole = bytes(good());
  expect_line_for("none", folder_.file("none.qst"), {"none.qst: no such file"});
  expect_line_for("folder", folder_.path(), {"a folder"});
  expect_line_for("empty", folder_.file("empty.qst", ""), {"empty.qst: this is not a hull table"});
  expect_line_for("text", folder_.file("a.toml", source_text("sim/hulls/s175.hull.toml")),
                  {"a.toml: this is not a hull table"});
  expect_line_for("cut", folder_.file("cut.qst", whole.substr(0, whole.size() / 2)), {"cut short"});
  expect_line_for("a byte less", folder_.file("odd.qst", whole.substr(0, whole.size() - 1)), {"cut short"});
  expect_line_for("a byte more", folder_.file("more.qst", whole + "x"), {"too long"});
  std::string flipped = whole;
  flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 0x10);
  expect_line_for("flipped", folder_.file("bit.qst", flipped), {"bit.qst: the hull table is damaged"});
  std::string version = whole;
  version[4 * kWordVersion] = 9;
  expect_line_for("version", folder_.file("v.qst", version), {"another version", "compile it again"});
  expect_line_for("large", folder_.file("large.qst", std::string(kMaxHullTableBytes + 4, ' ')),
                  {"819204 bytes", "at most 819200"});
  const Compiled other(*thinned_s175(7), HullSections::kLewis, {{9.5}, {}});
  expect_line_for("other", folder_.file("other.qst", bytes(other.table.words)),
                  {"another hull", "S-175 container ship"});
}

TEST_F(HullTableFile, IsNotWrittenHalf) {
  const FileStatus status = write_hull_table(good(), folder_.path() / "none" / "x.qst");
  expect_line("no folder", status.line(), {"x.qst: cannot be written"});
}

}  // namespace
}  // namespace quickstrip::test
