// What the documents cite: every [Author1900] stands in core/REFERENCES.md, and every test that
// firmware/HAZARDS.md names is a test of ours.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/arch/source_tree.hpp"

namespace quickstrip::arch {
namespace {

const std::vector<std::string> kRooms = {"core", "msgs", "firmware", "sim", "tests"};

// An entry of the reference list opens its line: "- **[Tag1900]** ...".
std::set<std::string> references() {
  std::set<std::string> tags;
  for (const std::string& line : lines_of(source_file("core/REFERENCES.md").text)) {
    if (line.starts_with("- **[")) {
      const auto first = citations_of(line.substr(0, line.find("**", 4)));
      tags.insert(first.begin(), first.end());
    }
  }
  return tags;
}

// Suite.Name in backticks.
std::set<std::string> named_tests(std::string_view text) {
  std::set<std::string> found;
  for (std::size_t open = text.find('`'); open != std::string_view::npos; open = text.find('`', open + 1)) {
    const std::size_t close = text.find('`', open + 1);
    if (close == std::string_view::npos) {
      break;
    }
    const std::string name(text.substr(open + 1, close - open - 1));
    const bool is_test = std::count(name.begin(), name.end(), '.') == 1 &&
                         name.find_first_of(" /(") == std::string::npos &&
                         std::isupper(static_cast<unsigned char>(name.front())) != 0 &&
                         std::isupper(static_cast<unsigned char>(name[name.find('.') + 1])) != 0;
    if (is_test) {
      found.insert(name);
    }
    open = close;
  }
  return found;
}

// TEST(Suite, Name), TEST_F and TEST_P alike, however clang-format has broken the line.
std::set<std::string> tests_of_ours() {
  std::set<std::string> found;
  for (const SourceFile& file : source_files({"tests"}, {"_test.cpp"})) {
    const auto words = words_of(code_of(file.text));
    for (std::size_t i = 0; i + 2 < words.size(); ++i) {
      if (words[i] == "TEST" || words[i] == "TEST_F" || words[i] == "TEST_P") {
        found.insert(words[i + 1] + "." + words[i + 2]);
      }
    }
  }
  return found;
}

TEST(Documents, EveryCitationStandsInTheReferences) {
  const auto known = references();
  ASSERT_GT(known.size(), 5U);
  auto files = source_files(kRooms, {".cpp", ".hpp", ".md", ".toml", ".csv", ".txt", ".lcm"});
  files.push_back(source_file("README.md"));
  for (const SourceFile& file : files) {
    if (file.path.starts_with("tests/arch/")) {
      continue;  // plants wrong ones
    }
    for (const std::string& tag : citations_of(file.text)) {
      EXPECT_TRUE(known.contains(tag))
          << file.path << " cites [" << tag << "], unknown to core/REFERENCES.md";
    }
  }
}

TEST(Documents, CitationsAreRecognisedAndIndicesAreNot) {
  EXPECT_EQ(citations_of("as in [Journee1992] §3 and [vonKerczekTuck1969]").size(), 2U);
  EXPECT_TRUE(citations_of("a[i] b[1992] [S] [C] values[kMax] [Journee92]").empty());
}

TEST(Documents, TheHazardListNamesTestsThatExist) {
  const SourceFile hazards = source_file("firmware/HAZARDS.md");
  ASSERT_FALSE(hazards.text.empty());
  const auto ours = tests_of_ours();
  ASSERT_TRUE(ours.contains("Documents.TheHazardListNamesTestsThatExist"));
  const auto named = named_tests(hazards.text);
  EXPECT_FALSE(named.empty());
  for (const std::string& name : named) {
    EXPECT_TRUE(ours.contains(name)) << "firmware/HAZARDS.md names " << name;
  }
}

}  // namespace
}  // namespace quickstrip::arch
