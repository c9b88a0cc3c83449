// Corrupted hull, limits, hull table and state files: refused at the start by a line that says which, or, for
// the state, started without what is damaged. Nothing is published by an advisor that refuses.
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>

#include "tests/faults/fault_test.hpp"

namespace quickstrip::faults {
namespace {

class CorruptFile : public FaultTest {
 protected:
  void expect_refused(const std::vector<std::string>& options, const std::string& file,
                      const std::string& what) {
    Start how;
    how.options = options;
    EXPECT_FALSE(advisor_.start(how)) << what << ": started";
    EXPECT_EQ(advisor_.wait_for_end(10.0 * kPatience), std::optional<int>(1)) << what;
    const std::string line = advisor_.journal();
    EXPECT_NE(line.find(file), std::string::npos) << what << ": which file? " << line;
    EXPECT_EQ(line.find('\n'), line.size() - 1) << what << ": not one line: " << line;
    EXPECT_EQ(num_advices_ + num_grids_ + num_healths_, 0) << what << ": something was published";
    if (advisor_.is_running()) {
      advisor_.kill_hard();
    }
  }
  void expect_hull_refused(const std::string& text, const std::string& what) {
    const std::string file = folder_.file("bad.hull.toml", text);
    expect_refused({"--hull", file, "--url", url_}, "bad.hull.toml", what);
  }
  void expect_limits_refused(const std::string& text, const std::string& what) {
    const std::string file = folder_.file("bad.limits.toml", text);
    std::vector<std::string> options = usual_options();
    options.insert(options.end(), {"--limits", file});
    expect_refused(options, "bad.limits.toml", what);
  }
  std::string noise(std::size_t size) {
    std::string bytes(size, '\0');
    for (char& c : bytes) {
      c = static_cast<char>(random_());
    }
    return bytes;
  }
  std::mt19937 random_{20'261'123};
};

TEST_F(CorruptFile, ACorruptedHullIsRefusedByName) {
  const std::string good = test::source_text("sim/hulls/s175.hull.toml");
  expect_hull_refused("", "empty");
  expect_hull_refused(good.substr(0, good.size() / 2), "cut short");
  expect_hull_refused(noise(2000), "noise");
  expect_hull_refused(std::string(4096, '\0'), "zeros, as after a power cut");
  expect_hull_refused(test::edited(good, "lpp_m = 175.0", "lpp_m = nan"), "length not a number");
  expect_hull_refused(test::edited(good, "lpp_m = 175.0", "lpp_m = -175.0"), "length negative");
  expect_hull_refused(test::edited(good, "lpp_m = 175.0", "lpp_m = 1e300"), "length enormous");
  expect_hull_refused(test::edited(good, "schema = 1", "schema = 2"), "of another schema");
  const std::string folder = folder_.file("folder.hull.toml");
  std::filesystem::create_directories(folder);
  expect_refused({"--hull", folder, "--url", url_}, "folder.hull.toml", "a folder");
  expect_refused({"--hull", folder_.file("none.hull.toml"), "--url", url_}, "none.hull.toml", "not there");
}

TEST_F(CorruptFile, CorruptedLimitsAreRefusedByName) {
  const std::string good = test::source_text("firmware/profiles/quickstrip_cargo.limits.toml");
  expect_limits_refused("", "empty");
  expect_limits_refused(good.substr(0, good.size() - 40), "cut short");
  expect_limits_refused(noise(2000), "noise");
  expect_limits_refused(test::edited(good, "limit_deg = 6.0", "limit_deg = nan"), "a limit not a number");
  expect_limits_refused(test::edited(good, "limit_deg = 6.0", "limit_deg = -1.0"), "a limit below zero");
  expect_limits_refused(test::edited(good, "limit_deg = 6.0", "limit_deg = inf"), "a limit without end");
}

class CorruptTable : public CorruptFile {
 protected:
  void SetUp() override {
    hull_file_ = folder_.file("small.hull.toml", small_hull());
    oracle_ = nullptr;  // it knows no table
    table_ = folder_.file("small.qst");
    const std::string command = std::string(QUICKSTRIP_HULL_PROGRAM) + " compile " + hull_file_ +
                                " --sections lewis --out " + table_ + " >/dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::ifstream file(table_, std::ios::binary);
    good_ = {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    ASSERT_GT(good_.size(), 1000U);
  }
  static std::string small_hull() {
    return R"(schema = 1
name = "barge"
particulars = { lpp_m = 60.0, breadth_m = 12.0 }
[[station]]
x_m = 0.0
offsets_m = [[0.0, 0.0], [6.0, 5.0]]
[[station]]
x_m = 30.0
offsets_m = [[0.0, 0.0], [6.0, 0.5], [6.0, 5.0]]
[[station]]
x_m = 60.0
offsets_m = [[0.0, 0.0], [5.0, 2.0], [6.0, 5.0]]
[loading]
draught_aft_m = 2.0
draught_fwd_m = 2.0
kg_m = 2.0
roll_gyradius_m = 4.0
pitch_gyradius_m = 15.0
yaw_gyradius_m = 15.0
[roll_damping]
method = "ratio"
ratio = 0.05
[[point]]
name = "bridge"
role = "bridge"
x_m = 5.0
z_m = 12.0
[grid]
speeds_kn = { from = 0.0, to = 10.0, step = 5.0 }
heading_step_deg = 90.0
)";
  }
  std::vector<std::string> with_table(const std::string& file) const {
    std::vector<std::string> options = usual_options();
    options.insert(options.end(), {"--table", file});
    return options;
  }
  void expect_table_refused(const std::string& bytes, const std::string& what) {
    expect_refused(with_table(folder_.file("bad.qst", bytes)), "bad.qst", what);
  }
  std::string table_;
  std::string good_;
};

TEST_F(CorruptTable, TheGoodOneIsTaken) {
  start({"--table", table_});
  ASSERT_TRUE(until([this] { return num_advices_ > 0; }));
  EXPECT_NE(advisor_.journal().find("small.qst: hull table"), std::string::npos);
}

TEST_F(CorruptTable, ACorruptedTableIsRefusedByName) {
  expect_table_refused("", "empty");
  expect_table_refused(good_.substr(0, good_.size() - 4), "a word short");
  expect_table_refused(good_.substr(0, good_.size() / 2), "half of it");
  expect_table_refused(good_ + std::string(4, '\0'), "a word long");
  expect_table_refused(noise(good_.size()), "noise");
  expect_table_refused(std::string(good_.size(), '\0'), "zeros, as after a power cut");
  for (int i = 0; i < 20; ++i) {
    std::string flipped = good_;
    const std::size_t bit = random_() % (8 * flipped.size());
    flipped[bit / 8] = static_cast<char>(static_cast<unsigned char>(flipped[bit / 8]) ^ (1U << (bit % 8)));
    expect_table_refused(flipped, "bit " + std::to_string(bit) + " flipped");
  }
}

TEST_F(CorruptTable, TheTableOfAnotherHullIsRefused) {
  hull_file_ = std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/s175.hull.toml";
  expect_refused(with_table(table_), "small.qst", "another ship's");
}

class CorruptState : public CorruptFile {
 protected:
  /// Started on this state, without sensors: what it says for a second.
  void start_on(const std::string& bytes) {
    const std::string file = folder_.file("state.log", bytes);
    has_sensors_ = false;
    start({"--state", file});
    listen(0.5);
  }
  std::string good_state() {
    start({"--state", folder_.file("state.log")});
    send_sea(kBadSea_m);
    EXPECT_TRUE(until_advice());
    listen(0.5);
    advisor_.kill_hard();
    std::ifstream file(folder_.file("state.log"), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
};

TEST_F(CorruptState, CutShortAnywhereItStartsAndNothingOfItIsUsed) {
  const std::string good = good_state();
  for (const std::size_t size : {std::size_t{0}, std::size_t{20}, good.size() / 3, good.size() - 1}) {
    start_on(good.substr(0, size));
    EXPECT_NE(advice_.no_advice, 0) << "cut to " << size;
    EXPECT_EQ(advisor_.journal().find("damaged") != std::string::npos, size > 0) << advisor_.journal();
    advisor_.kill_hard();
  }
  start_on(good);
  EXPECT_EQ(advice_.no_advice, 0) << why_not();
}

// A flipped bit must not become a lower sea: the checker compares with what was sent.
TEST_F(CorruptState, ABitFlippedAnywhereNothingOfItIsUsed) {
  const std::string good = good_state();
  for (int i = 0; i < 25; ++i) {
    std::string flipped = good;
    const std::size_t bit = random_() % (8 * flipped.size());
    flipped[bit / 8] = static_cast<char>(static_cast<unsigned char>(flipped[bit / 8]) ^ (1U << (bit % 8)));
    const std::string file = folder_.file("state.log", flipped);
    has_sensors_ = false;
    if (try_start({{"--state", file}, {}})) {
      listen(0.15);
      advisor_.kill_hard();
    } else {
      EXPECT_NE(advisor_.journal().find("state.log"), std::string::npos) << advisor_.journal();
    }
  }
}

}  // namespace
}  // namespace quickstrip::faults
