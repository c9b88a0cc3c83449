#include "msgs/files/voyage_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

const std::string kVoyage = R"(schema = 1
name = "v"
end_utc = 2019-09-01T00:00:00Z
[[leg]]
from_utc = 2019-08-30T00:00:00Z
heading_deg = 90.0
speed_kn = 10.0
[[leg]]
from_utc = 2019-08-31T02:00:00+02:00
heading_deg = 180.0
speed_kn = 12.0
)";

std::string refusal(const std::string& from, const std::string& to) {
  std::string text = kVoyage;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  Voyage voyage;
  return parse_voyage(text.replace(at, from.size(), to), "v.toml", voyage).line();
}

TEST(VoyageFile, TimesAreMicrosecondsSinceTheEpochWhateverTheirOffset) {
  Voyage voyage;
  ASSERT_TRUE(parse_voyage(kVoyage, "v.toml", voyage).ok());
  ASSERT_EQ(voyage.legs.size(), 2u);
  EXPECT_EQ(voyage.legs[0].from_utime, 1'567'123'200'000'000);  // date -u -d 2019-08-30 +%s
  EXPECT_EQ(voyage.legs[1].from_utime, 1'567'123'200'000'000 + 86'400'000'000);
  EXPECT_EQ(voyage.end_utime, 1'567'123'200'000'000 + 2 * 86'400'000'000);
  EXPECT_DOUBLE_EQ(voyage.legs[0].speed, from_knots(10.0));
}

TEST(VoyageFile, ALegHoldsUntilTheNextBegins) {
  Voyage voyage;
  ASSERT_TRUE(parse_voyage(kVoyage, "v.toml", voyage).ok());
  const std::int64_t begin = voyage.legs[0].from_utime;
  EXPECT_EQ(leg_at(voyage, begin - 1), nullptr);
  EXPECT_EQ(leg_at(voyage, begin), &voyage.legs[0]);
  EXPECT_EQ(leg_at(voyage, voyage.legs[1].from_utime - 1), &voyage.legs[0]);
  EXPECT_EQ(leg_at(voyage, voyage.legs[1].from_utime), &voyage.legs[1]);
  EXPECT_EQ(leg_at(voyage, voyage.end_utime), nullptr);
}

TEST(VoyageFile, WhatIsWrongIsNamed) {
  EXPECT_EQ(refusal("heading_deg = 90.0", "heading_deg = 360.0"),
            "v.toml: leg[1].heading_deg = 360.0: 0 is wanted for north (line 6)");
  EXPECT_NE(refusal("2019-08-31T02:00:00+02:00", "2019-08-29T00:00:00Z").find("after that of the leg before"),
            std::string::npos);
  EXPECT_NE(refusal("2019-08-31T02:00:00+02:00", "2019-10-01T00:00:00Z").find("before end_utc"),
            std::string::npos);
  EXPECT_NE(refusal("2019-08-30T00:00:00Z", "2019-08-30T00:00:00").find("with its offset"),
            std::string::npos);
  EXPECT_NE(refusal("speed_kn = 10.0", "speed_kn = nan").find("leg[1].speed_kn = nan"), std::string::npos);
  EXPECT_NE(refusal("speed_kn = 10.0", "sped_kn = 10.0").find("nearest known one is speed_kn"),
            std::string::npos);
}

TEST(VoyageFile, DorianPassageCoversItsTenDaysAtTwelveToEighteenKnots) {
  Voyage voyage;
  const FileStatus status = read_voyage_file(
      std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/voyages/dorian_passage.voyage.toml", voyage);
  ASSERT_TRUE(status.ok()) << status.line();
  EXPECT_EQ(voyage.legs.front().from_utime, 1'567'123'200'000'000);
  EXPECT_EQ(voyage.end_utime - voyage.legs.front().from_utime, 10 * 86'400'000'000);
  for (const VoyageLeg& leg : voyage.legs) {
    EXPECT_GE(to_knots(leg.speed), 12.0 - 1e-9);  // rounding of knots
    EXPECT_LE(to_knots(leg.speed), 18.0 + 1e-9);
  }
}

}  // namespace
}  // namespace quickstrip
