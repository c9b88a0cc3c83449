#include "firmware/nmea/sentence.hpp"

#include <gtest/gtest.h>

#include "firmware/nmea/fields.hpp"
#include "firmware/nmea/line_framer.hpp"
#include "firmware/nmea/record_time.hpp"
#include "tests/nmea/support.hpp"

namespace quickstrip::nmea {
namespace {

Fate fate_of(std::string_view line, bool allow_missing = false) {
  Cut cut;
  return cut_sentence(line, allow_missing, cut);
}

TEST(NmeaSentence, TalkerFormatterAndFieldsAreCut) {
  Cut cut;
  ASSERT_EQ(cut_sentence("$INVTG,215.11,T,239.79,M,9.1,N,16.9,K,A*05", false, cut), Fate::kTaken);
  EXPECT_EQ(cut.talker, "IN");
  EXPECT_EQ(cut.formatter, "VTG");
  ASSERT_EQ(cut.fields.size(), 9U);
  EXPECT_EQ(cut.field(4), "9.1");
  EXPECT_EQ(cut.field(9), "");
  ASSERT_EQ(cut_sentence("$PSXN,23,0.35,-1.74,218.26,0.58*13", false, cut), Fate::kTaken);
  EXPECT_EQ(cut.talker, "P");
  EXPECT_EQ(cut.formatter, "SXN");
}

TEST(NmeaSentence, OneWrongCharacterAnywhereIsRefused) {
  const std::string good = "$INHDT,218.26,T*1A";
  ASSERT_EQ(fate_of(good), Fate::kTaken);
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = good[i] == '7' ? '3' : '7';  // two digits that differ in a bit, in the sum too
    EXPECT_TRUE(is_refused(fate_of(bad))) << bad;
  }
}

TEST(NmeaSentence, AMissingChecksumIsTakenOnlyOnDemandAndAWrongOneNever) {
  EXPECT_EQ(fate_of("$INHDT,218.26,T"), Fate::kNoChecksum);
  EXPECT_EQ(fate_of("$INHDT,218.26,T", true), Fate::kTaken);
  EXPECT_EQ(fate_of("$INHDT,218.26,T*1B", true), Fate::kBadChecksum);
  EXPECT_EQ(fate_of("$INHDT,218.26,T*", true), Fate::kBadChecksum);
  EXPECT_EQ(fate_of("$INHDT,218.26,T*1", true), Fate::kBadChecksum);
  EXPECT_EQ(fate_of("$INHDT,218.26,T*1A0", true), Fate::kBadChecksum);
  EXPECT_EQ(fate_of("$INHDT,218.26,T*1a"), Fate::kTaken);
}

TEST(NmeaSentence, TagBlocksArePassedOverWhenTheirOwnChecksumHolds) {
  const std::string tag = test::sealed("s:GP0001,c:1120959341").substr(1);
  EXPECT_EQ(fate_of("\\" + tag + "\\$INHDT,218.26,T*1A"), Fate::kTaken);
  EXPECT_EQ(fate_of("\\" + tag + "\\\\" + tag + "\\$INHDT,218.26,T*1A"), Fate::kTaken);
  EXPECT_EQ(fate_of("\\s:GP0001*00\\$INHDT,218.26,T*1A"), Fate::kBadTag);
  EXPECT_EQ(fate_of("\\" + tag + "$INHDT,218.26,T*1A"), Fate::kBadTag);
}

TEST(NmeaSentence, WhatIsNoSentenceSaysWhy) {
  EXPECT_EQ(fate_of(""), Fate::kEmpty);
  EXPECT_EQ(fate_of("GET / HTTP/1.1"), Fate::kNoSentence);
  EXPECT_EQ(fate_of(std::string("$INHDT,218\0.26,T*1A", 19)), Fate::kBadCharacter);
  EXPECT_EQ(fate_of("!AIVDM,1,1,,A,403,0*00"), Fate::kNotUsed);
  EXPECT_EQ(fate_of(test::sealed("HDT,1,T")), Fate::kBadAddress);
  EXPECT_EQ(fate_of(test::sealed("gphdt,1,T")), Fate::kBadAddress);
  EXPECT_EQ(fate_of("$" + std::string(kMaxLine, 'A')), Fate::kTooLong);
  EXPECT_EQ(fate_of(test::sealed("GPXDR" + std::string(60, ','))), Fate::kTooManyFields);
}

TEST(NmeaFields, ANumberIsDigitsWithAPointAndASignAndNothingElse) {
  EXPECT_EQ(number("12.5"), 12.5);
  EXPECT_EQ(number("-0.80"), -0.8);
  EXPECT_EQ(number("+.5"), 0.5);
  EXPECT_EQ(number("007"), 7.0);
  for (const char* bad : {"", "-", ".", "1e9", "inf", "nan", "0x10", "1.2.3", " 1", "1 ", "--1", "+-1", "1,2",
                          "123456789012345678901"}) {
    EXPECT_FALSE(number(bad)) << bad;
  }
}

TEST(NmeaFraming, LinesArePutTogetherHoweverTheyArrive) {
  for (const std::size_t piece : {1U, 2U, 7U, 100U}) {
    LineFramer framer;
    std::vector<std::string> lines;
    int num_long = 0;
    const auto take = [&](std::string_view line) { lines.emplace_back(line); };
    const auto drop = [&] { ++num_long; };
    const std::string bytes = "one\r\ntwo\n\n" + std::string(5000, 'x') + "\nthree\rfour";
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      framer.feed(std::string_view(bytes).substr(at, piece), take, drop);
    }
    framer.finish(take, drop);
    EXPECT_EQ(lines, (std::vector<std::string>{"one", "two", "three", "four"})) << piece;
    EXPECT_EQ(num_long, 1);
  }
}

TEST(NmeaRecordTime, AStampIsTakenOffTheLineAndNothingElseIs) {
  std::string_view line = "2014-08-01T00:00:00.285000Z $INHDT";
  EXPECT_EQ(take_stamp(line), 1'406'851'200'285'000);  // date -u -d 2014-08-01T00:00:00Z +%s
  EXPECT_EQ(line, "$INHDT");
  line = "2016-02-29T23:59:59 $X";
  EXPECT_EQ(take_stamp(line), 1'456'790'399'000'000);
  for (const std::string_view none :
       {"$INHDT,1,T", "2014-08-01", "2014-13-01T00:00:00Z $", "2015-02-29T00:00:00Z $",
        "1969-01-01T00:00:00Z $", "2014-08-01T24:00:00Z $", "2014-08-01T00:00:00Z$", ""}) {
    line = none;
    EXPECT_FALSE(take_stamp(line)) << none;
    EXPECT_EQ(line, none);
  }
}

}  // namespace
}  // namespace quickstrip::nmea
