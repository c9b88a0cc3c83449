// Every quality bit has one wording, and CHANNELS.md says it.
#include "msgs/convert/quality_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "msgs/convert/advice_text.hpp"

namespace quickstrip {
namespace {

TEST(QualityText, HasEveryBitOnceInOrderWithATokenOfItsOwn) {
  std::set<std::string> tokens;
  for (std::size_t i = 0; i < kQualityWords.size(); ++i) {
    EXPECT_EQ(static_cast<std::uint32_t>(kQualityWords[i].bit), 1u << i);
    EXPECT_TRUE(tokens.insert(kQualityWords[i].token).second) << kQualityWords[i].token;
    EXPECT_EQ(std::string(kQualityWords[i].token).find_first_not_of("abcdefghijklmnopqrstuvwxyz_"),
              std::string::npos);
  }
  EXPECT_EQ(tokens.size(), kNumQualityBits);
}

TEST(QualityText, EveryBitIsDocumentedByItsValueInChannels) {
  std::ifstream file(QUICKSTRIP_SOURCE_DIR "/msgs/CHANNELS.md");
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::size_t from = page.find("`quality` (bits):");
  ASSERT_NE(from, std::string::npos);
  std::string list = page.substr(from, page.find("\n\n", from) - from);
  for (char& c : list) {
    c = c == '\n' ? ' ' : c;
  }
  std::size_t at = list.find(": ") + 1;
  for (const QualityWords& words : kQualityWords) {  // in order, each after a "·" but the first
    const std::string value = fmt::format(" {} ", static_cast<std::uint32_t>(words.bit));
    at = list.find(value, at);
    ASSERT_NE(at, std::string::npos) << words.token;
    at += value.size() - 1;
    EXPECT_GT(std::min(list.find("·", at), list.size()) - at, 3u) << words.token;
  }
  EXPECT_EQ(list.find(fmt::format(" {} ", 1u << kNumQualityBits)), std::string::npos);
}

TEST(QualityText, TheBridgeIsToldInWholeWordsThatFitTheAdvice) {
  Advice advice;
  advice.no_advice = NoAdvice::kNone;
  advice.present.verdict = Verdict::kGood;
  for (const QualityWords& words : kQualityWords) {
    advice.present.quality = words.bit;
    Sentence out;
    add_reasons(advice, {}, {}, out);
    const bool is_said = *words.bridge != '\0';
    EXPECT_EQ(out.view() != "All limits kept", is_said) << words.token;
    EXPECT_EQ(out.view().find(words.bridge) != std::string_view::npos, true);
    EXPECT_LT(out.view().size(), 256u);  // the field of advice_t
  }
}

}  // namespace
}  // namespace quickstrip
