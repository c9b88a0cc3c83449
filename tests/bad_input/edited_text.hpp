// A good file with one thing wrong in it, and what its refusal must say.
#pragma once

#include <gtest/gtest.h>

#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace quickstrip::test {

struct WrongText {
  const char* what;
  std::string from;  // in the good text; empty: `to` is put at the end
  std::string to;
  std::vector<std::string> words;  // of the one line: field, value, what would be right
};

inline std::string edited(const std::string& good, const std::string& from, const std::string& to) {
  if (from.empty()) {
    return good + to;
  }
  std::string text = good;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from << " is not in the good file";
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// One line without control characters, and every word in it.
inline void expect_line(const std::string& what, const std::string& line,
                        const std::vector<std::string>& words) {
  ASSERT_FALSE(line.empty()) << what << ": accepted";
  for (const char c : line) {
    ASSERT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F) << what << ": not one line: " << line;
  }
  EXPECT_LT(line.size(), 400U) << what << ": " << line;
  for (const std::string& word : words) {
    EXPECT_NE(line.find(word), std::string::npos) << what << ": \"" << word << "\" is not in: " << line;
  }
}

inline std::string source_text(const std::string& path) {
  std::ifstream file(std::string(QUICKSTRIP_SOURCE_DIR) + "/" + path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// A folder of this process, taken away at the end.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(std::filesystem::path(testing::TempDir()) / ("qs_bad_" + name + std::to_string(getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code none;
    std::filesystem::remove_all(path_, none);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::string file(const std::string& name) const { return path_ / name; }
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace quickstrip::test
