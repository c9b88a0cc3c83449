// Words that have no place in core, nor (virtual apart) in the session that the live process and the replay
// share: heap, exceptions, virtual calls, clocks, streams, threads.
#include <gtest/gtest.h>

#include <set>

#include "tests/arch/source_tree.hpp"

namespace quickstrip::arch {
namespace {

const std::set<std::string>& forbidden_words() {
  static const std::set<std::string> words = {"new",
                                              "malloc",
                                              "calloc",
                                              "realloc",
                                              "free",
                                              "alloca",
                                              "throw",
                                              "try",
                                              "catch",
                                              "virtual",
                                              "dynamic_cast",
                                              "typeid",
                                              "goto",
                                              "thread_local",
                                              "setjmp",
                                              "longjmp",
                                              "printf",
                                              "fprintf",
                                              "snprintf",
                                              "puts",
                                              "rand",
                                              "srand",
                                              "getenv",
                                              "gettimeofday",
                                              "clock_gettime",
                                              "std::vector",
                                              "std::string",
                                              "std::wstring",
                                              "std::function",
                                              "std::map",
                                              "std::multimap",
                                              "std::set",
                                              "std::unordered_map",
                                              "std::unordered_set",
                                              "std::list",
                                              "std::deque",
                                              "std::forward_list",
                                              "std::any",
                                              "std::shared_ptr",
                                              "std::unique_ptr",
                                              "std::make_unique",
                                              "std::make_shared",
                                              "std::thread",
                                              "std::jthread",
                                              "std::mutex",
                                              "std::async",
                                              "std::future",
                                              "std::cout",
                                              "std::cerr",
                                              "std::ostream",
                                              "std::istream",
                                              "std::stringstream",
                                              "std::ostringstream",
                                              "std::random_device",
                                              "std::mt19937",
                                              "std::stable_sort",
                                              "std::stable_partition",
                                              "std::inplace_merge",
                                              "std::locale",
                                              "std::to_string",
                                              "std::exception",
                                              "std::runtime_error",
                                              "std::regex",
                                              "std::malloc",
                                              "std::free",
                                              "std::printf",
                                              "std::snprintf"};
  return words;
}

// `= delete` and a namespace of a forbidden word ("std::chrono::...") need a look of their own.
std::vector<std::string> forbidden_words_in(std::string_view text) {
  std::vector<std::string> found;
  const std::string code = code_of(text);
  for (const std::string& line : lines_of(code)) {
    if (line.find('#') != std::string::npos && line.find("include") != std::string::npos) {
      continue;  // the arrows' business
    }
    for (const std::string& word : words_of(line)) {
      const bool is_forbidden = forbidden_words().contains(word) || word.starts_with("std::chrono") ||
                                word.starts_with("std::pmr") || word.starts_with("std::filesystem");
      if (is_forbidden) {
        found.push_back(word);
      }
      const std::size_t at = line.find("delete");
      if (word == "delete" && line.substr(0, at).find('=') == std::string::npos) {
        found.push_back(word);
      }
    }
  }
  return found;
}

TEST(ForbiddenWords, AreNotInCore) {
  const auto files = source_files({"core"}, {".cpp", ".hpp"});
  ASSERT_GT(files.size(), 10U);
  for (const SourceFile& file : files) {
    for (const std::string& word : forbidden_words_in(file.text)) {
      ADD_FAILURE() << file.path << ": `" << word << "` has no place in core";
    }
  }
}

// The session may have a door to the bus behind an interface; otherwise it is as bare as core.
TEST(ForbiddenWords, AreNotInTheSessionButForItsInterface) {
  const auto files = source_files({"firmware/session"}, {".cpp", ".hpp"});
  ASSERT_GT(files.size(), 2U);
  for (const SourceFile& file : files) {
    for (const std::string& word : forbidden_words_in(file.text)) {
      EXPECT_EQ(word, "virtual") << file.path;
    }
  }
}

TEST(ForbiddenWords, AreFoundWhereTheyArePlanted) {
  EXPECT_EQ(forbidden_words_in("std::vector<double> v;"), std::vector<std::string>{"std::vector"});
  EXPECT_EQ(forbidden_words_in("auto* p = new int;"), std::vector<std::string>{"new"});
  EXPECT_EQ(forbidden_words_in("delete p;"), std::vector<std::string>{"delete"});
  EXPECT_EQ(forbidden_words_in("void* p = malloc(3);"), std::vector<std::string>{"malloc"});
  EXPECT_EQ(forbidden_words_in("if (bad) { throw 1; }"), std::vector<std::string>{"throw"});
  EXPECT_FALSE(forbidden_words_in("auto now = std::chrono::steady_clock::now();").empty());
}

TEST(ForbiddenWords, MayStandInCommentsAndStringsAndInsideOtherNames) {
  EXPECT_TRUE(forbidden_words_in("// a new std::vector\nint renewed = 0; /* throw */").empty());
  EXPECT_TRUE(forbidden_words_in("const char* text = \"try a new course\";").empty());
  EXPECT_TRUE(forbidden_words_in("std::string_view name; T(const T&) = delete; int free_surface;").empty());
  EXPECT_TRUE(forbidden_words_in("int n = 1'000; double new_speed = 2.0;").empty());
}

}  // namespace
}  // namespace quickstrip::arch
