// The programs as processes: what they print and how they end, in a folder of the test's own.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/bad_input/edited_text.hpp"

namespace quickstrip::test {

inline const std::string kSource = QUICKSTRIP_SOURCE_DIR;
inline const std::string kHull = QUICKSTRIP_HULL_PROGRAM;
inline const std::string kSim = QUICKSTRIP_SIM_PROGRAM;
inline const std::string kAdvisor = QUICKSTRIP_ADVISOR_PROGRAM;
inline const std::string kS175 = kSource + "/sim/hulls/s175.hull.toml";

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

class Programs : public testing::Test {
 protected:
  Outcome run(const std::string& command) {
    const std::string line =
        "cd " + folder_.path().string() + " && timeout 60 " + command + " >.out 2>.err </dev/null";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(".out"), text_of(".err")};
  }
  [[nodiscard]] std::string text_of(const std::string& name) const {
    std::ifstream file(folder_.file(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  [[nodiscard]] std::size_t num_files() const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      count += entry.path().filename().string().front() == '.' ? 0U : 1U;
    }
    return count;
  }
  void expect_bad(const std::string& command, const std::vector<std::string>& words) {
    const std::size_t before = num_files();
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 1) << command << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << command;
    EXPECT_EQ(num_files(), before) << command << ": left something behind";
    ASSERT_FALSE(outcome.err.empty()) << command;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << command << ": not one line: " << outcome.err;
    expect_line(command, outcome.err.substr(0, outcome.err.size() - 1), words);
  }
  void expect_wrong_use(const std::string& command, const std::vector<std::string>& words) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 2) << command << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << command;
    for (const std::string& word : words) {
      EXPECT_NE(outcome.err.find(word), std::string::npos)
          << command << ": \"" << word << "\" not in " << outcome.err;
    }
  }

  Folder folder_{"programs"};
};

}  // namespace quickstrip::test
