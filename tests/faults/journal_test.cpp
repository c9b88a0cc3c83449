// Standard error closed, broken, blocked, on a full disk: the cycle neither waits for it nor dies of it.
#include <fcntl.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <utility>

#include "tests/faults/fault_test.hpp"

namespace quickstrip::faults {
namespace {

class JournalFault : public FaultTest {
 protected:
  /// The verdict changes each time, so that there is something to write.
  void expect_advice_whatever_is_written() {
    send_sea(kGoodSea_m);
    ASSERT_TRUE(until_good()) << why_not();
    for (int i = 0; i < 4; ++i) {
      send_sea(kBadSea_m);
      ASSERT_TRUE(until([this] { return advice_.verdict == advice_t::VERDICT_EXCEEDED; }));
      send_bytes("QS_SEA_STATE", {1, 2, 3});
      has_sensors_ = false;
      listen(0.3);
      has_sensors_ = true;
    }
    const int before = num_advices_;
    listen(1.0);
    EXPECT_GE(num_advices_ - before, 5) << "cycles wait for the journal";
    EXPECT_TRUE(advisor_.is_running());
  }
  [[nodiscard]] std::string target_of_fd(int fd) const {
    std::error_code none;
    return std::filesystem::read_symlink(
        "/proc/" + std::to_string(advisor_.pid()) + "/fd/" + std::to_string(fd), none);
  }
};

TEST_F(JournalFault, ClosedNothingElseTakesItsPlace) {
  start_with_journal_on(Start::kClosed);
  expect_advice_whatever_is_written();
  const std::string target = target_of_fd(STDERR_FILENO);
  EXPECT_TRUE(target == "/dev/null" || target.empty())
      << target << " is written to by whatever is meant for the journal";
}

TEST_F(JournalFault, OnAFullDiskIsNoFault) {
  const int full = open("/dev/full", O_WRONLY | O_CLOEXEC);
  ASSERT_GE(full, 0);
  start_with_journal_on(full);
  expect_advice_whatever_is_written();
  close(full);
}

class JournalPipe : public JournalFault {
 protected:
  void SetUp() override { ASSERT_EQ(pipe2(ends_.data(), O_CLOEXEC), 0); }
  void TearDown() override {
    close(ends_[0]);
    close(ends_[1]);
  }
  std::array<int, 2> ends_{-1, -1};
};

TEST_F(JournalPipe, WhoseReaderIsGoneDoesNotEndIt) {
  start_with_journal_on(ends_[1]);
  close(std::exchange(ends_[0], -1));
  expect_advice_whatever_is_written();
}

TEST_F(JournalPipe, ThatNobodyReadsAndIsFullStopsNoCycle) {
  start_with_journal_on(ends_[1]);
  // Our own end that does not wait, on the same pipe.
  const int filler = open(("/proc/self/fd/" + std::to_string(ends_[1])).c_str(), O_WRONLY | O_NONBLOCK);
  ASSERT_GE(filler, 0);
  const std::array<char, 1> one{'x'};
  while (write(filler, one.data(), one.size()) > 0) {
  }
  close(filler);
  expect_advice_whatever_is_written();
  // And when somebody asks it to stop, it stops.
  advisor_.signal(SIGTERM);
  EXPECT_EQ(advisor_.wait_for_end(3.0 * kPatience), std::optional<int>(0));
}

}  // namespace
}  // namespace quickstrip::faults
