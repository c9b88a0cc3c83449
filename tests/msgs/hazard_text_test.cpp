// Every hazard bit has one wording, and CHANNELS.md says it.
#include "msgs/convert/hazard_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <string>

namespace quickstrip {
namespace {

TEST(HazardText, HasEveryBitOnceInOrderWithATokenOfItsOwn) {
  std::set<std::string> tokens;
  for (std::size_t i = 0; i < kHazardWords.size(); ++i) {
    EXPECT_EQ(static_cast<std::uint32_t>(kHazardWords[i].bit), 1u << i);
    EXPECT_TRUE(tokens.insert(kHazardWords[i].token).second) << kHazardWords[i].token;
    EXPECT_EQ(std::string(kHazardWords[i].token).find_first_not_of("abcdefghijklmnopqrstuvwxyz_"),
              std::string::npos);
  }
}

TEST(HazardText, AllBitsFitTheSignedFieldOfTheWire) {
  EXPECT_LE((1 << kNumHazardBits) - 1, std::numeric_limits<std::int16_t>::max());
}

TEST(HazardText, EveryZoneHasASentenceForTheBridge) {
  for (const HazardWords& words : kHazardWords) {
    if ((words.bit & kZoneBits) != 0) {
      EXPECT_GT(std::string(words.bridge).size(), 20u) << words.token;
      EXPECT_LT(std::string(words.bridge).size(), 120u) << words.token;
    }
  }
}

TEST(HazardText, EveryBitIsDocumentedByItsValueInChannels) {
  std::ifstream file(QUICKSTRIP_SOURCE_DIR "/msgs/CHANNELS.md");
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::size_t from = page.find("`hazards` (bits):");
  ASSERT_NE(from, std::string::npos);
  std::string list = page.substr(from, page.find("\n4 to 1024", from) - from);
  for (char& c : list) {
    c = c == '\n' ? ' ' : c;
  }
  std::size_t at = list.find(": ") + 1;
  for (const HazardWords& words : kHazardWords) {
    const std::string value = fmt::format(" {} ", static_cast<std::uint32_t>(words.bit));
    at = list.find(value, at);
    ASSERT_NE(at, std::string::npos) << words.token;
    at += value.size() - 1;
  }
  EXPECT_EQ(list.find(fmt::format(" {} ", 1u << kNumHazardBits)), std::string::npos);
}

TEST(HazardText, AWarningIsNamedBeforeACaution) {
  EXPECT_EQ(leading_zone(kHazardNoSteerage | kHazardMotions | kHazardMarginalSurfRiding), nullptr);
  EXPECT_EQ(leading_zone(kHazardSynchronousRoll | kHazardPureLoss)->bit, kHazardSynchronousRoll);
  EXPECT_EQ(leading_zone(kHazardSurfRiding | kHazardPureLoss | kHazardPureLossGm)->bit, kHazardPureLossGm);
}

}  // namespace
}  // namespace quickstrip
