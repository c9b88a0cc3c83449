// The disk under the state file full, read-only, gone: advice goes on, the journal says it, the inputs kept
// before are still whole.
#include <filesystem>
#include <memory>

#include "tests/faults/fault_test.hpp"
#include "tests/faults/small_disk.hpp"

namespace quickstrip::faults {
namespace {

class Disk : public FaultTest {
 protected:
  void SetUp() override {
    if (!disk_.is_mounted()) {
      GTEST_SKIP() << "mounting is not permitted here";
    }
  }
  void start_at_sea() {
    start({"--state", disk_.file("state.log")});
    send_sea(kBadSea_m, 60.0);
    ASSERT_TRUE(until_advice()) << why_not();
  }
  bool until_journal_says(const std::string& words) {
    return until([&] { return advisor_.journal().find(words) != std::string::npos; });
  }
  bool until_kept() {
    return until([this] { return std::filesystem::exists(disk_.file("state.log")); });
  }
  /// Killed and started again without sensors: what was kept, aged.
  void expect_restored_sea_of(std::int32_t seq) {
    advisor_.kill_hard();
    start({"--state", disk_.file("state.log")});
    ASSERT_TRUE(until_advice()) << advisor_.journal();
    EXPECT_EQ(advice_.input_use[0], int{advice_t::USE_RESTORED});
    EXPECT_EQ(advice_.input_seq[0], seq);
  }
  SmallDisk disk_{folder_.path() / "disk"};
};

TEST_F(Disk, FullFromTheStartAdviceComesAndTheJournalSaysThatNothingIsKept) {
  disk_.fill();
  start_at_sea();
  EXPECT_TRUE(until_journal_says("inputs are not kept: ")) << advisor_.journal();
  EXPECT_FALSE(std::filesystem::exists(disk_.file("state.log"))) << "half a file";
  ASSERT_TRUE(until_advice());
  disk_.make_room();
  send_sea(kBadSea_m);
  EXPECT_TRUE(until_kept()) << "not tried again";
  listen(0.5);
  expect_restored_sea_of(advice_.input_seq[0]);
}

TEST_F(Disk, FilledUnderWayTheInputsKeptBeforeStayWhole) {
  start_at_sea();
  ASSERT_TRUE(until_kept());
  listen(0.5);
  const std::int32_t kept_sea = advice_.input_seq[0];
  disk_.fill();
  send_sea(kGoodSea_m);
  ASSERT_TRUE(until_journal_says("inputs are not kept: "));
  ASSERT_TRUE(until_advice());
  EXPECT_GT(advice_.input_seq[0], kept_sea);
  expect_restored_sea_of(kept_sea);
  EXPECT_EQ(advice_.verdict, int{advice_t::VERDICT_EXCEEDED});
}

TEST_F(Disk, ReadOnlyUnderWayAdviceGoesOn) {
  start_at_sea();
  ASSERT_TRUE(until_kept());
  listen(0.3);
  ASSERT_TRUE(disk_.make_read_only(true));
  send_sea(kBadSea_m);
  ASSERT_TRUE(until_journal_says("inputs are not kept: ")) << advisor_.journal();
  ASSERT_TRUE(until_advice());
  ASSERT_TRUE(disk_.make_read_only(false));
  send_sea(kBadSea_m);
  listen(1.0);
  expect_restored_sea_of(advice_.input_seq[0]);
}

TEST_F(Disk, ReadOnlyFromTheStartAdviceComes) {
  ASSERT_TRUE(disk_.make_read_only(true));
  start_at_sea();
  EXPECT_TRUE(until_journal_says("inputs are not kept: "));
  ASSERT_TRUE(until_advice());
}

TEST_F(Disk, GoneUnderWayAdviceGoesOn) {
  const auto folder = folder_.path() / "there";
  std::filesystem::create_directories(folder);
  start({"--state", (folder / "state.log").string()});
  send_sea(kBadSea_m);
  ASSERT_TRUE(until_advice());
  std::filesystem::remove_all(folder);
  send_sea(kBadSea_m);
  ASSERT_TRUE(until_journal_says("inputs are not kept: "));
  ASSERT_TRUE(until_advice());
}

}  // namespace
}  // namespace quickstrip::faults
