#include "sim/sea_files/utc_time.hpp"

#include <gtest/gtest.h>

namespace quickstrip {
namespace {

// date -u -d 2019-09-04T12:40:00Z +%s
TEST(UtcTime, IsMicrosecondsSince1970) {
  EXPECT_EQ(parse_utc("2019-09-04T12:40:00Z"), 1567600800LL * 1'000'000);
  EXPECT_EQ(parse_utc("2019-09-04T12:40Z"), 1567600800LL * 1'000'000);
  EXPECT_EQ(parse_utc("1970-01-01T00:00Z"), 0);
  EXPECT_EQ(parse_utc("2020-02-29T00:00Z"), 1582934400LL * 1'000'000);
}

TEST(UtcTime, WritesWhatItReads) {
  for (const char* text : {"2019-08-30T00:40:00Z", "2024-02-29T23:59:59Z", "1970-01-01T00:00:00Z"}) {
    EXPECT_EQ(format_utc(*parse_utc(text)), text);
  }
}

TEST(UtcTime, RefusesWhatIsNoTime) {
  for (const char* text : {"", "2019-09-04", "2019-09-04T12:40", "2019-09-04 12:40Z", "2019-13-04T12:40Z",
                           "2019-02-29T12:40Z", "2019-09-04T24:00Z", "2019-09-04T12:60Z", "x019-09-04T12:40Z",
                           "2019-09-04T12:40:61Z", "2019-09-04T12:4:00Z", "-019-09-04T12:40Z"}) {
    EXPECT_FALSE(parse_utc(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace quickstrip
