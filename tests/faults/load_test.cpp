// A busy machine, a process that is stopped for a while, consumers that do not consume: cycles that come late
// are counted and told, what is advised stays right, and all of it passes.
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "tests/faults/fault_test.hpp"

namespace quickstrip::faults {
namespace {

constexpr std::int32_t kLateAlert = 4;

/// Busy loops at ordinary priority, two a processor.
class Load {
 public:
  Load() {
    const unsigned int processors = std::max(1U, std::thread::hardware_concurrency());
    for (unsigned int i = 0; i < 2 * processors; ++i) {
      const pid_t child = fork();
      if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        while (true) {
          asm volatile("");  // not optimised away
        }
      }
      children_.push_back(child);
    }
  }
  ~Load() {
    for (const pid_t child : children_) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
  }
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

 private:
  std::vector<pid_t> children_;
};

class BusyMachine : public FaultTest {
 public:
  void ignore(const lcm::ReceiveBuffer* /*buffer*/, const std::string& /*channel*/) {}

 protected:
  bool until_health_after_now() {
    const int before = num_healths_;
    return until([this, before] { return num_healths_ > before + 1; });
  }
};

TEST_F(BusyMachine, UnderFullLoadAdviceComesAndIsRight) {
  start();
  send_sea(kBadSea_m);
  ASSERT_TRUE(until_advice());
  {
    const Load load;
    const int before = num_advices_;
    send_loading(9.0);  // and the hull is rebuilt meanwhile
    listen(3.0);
    EXPECT_GE(num_advices_ - before, 6) << "of 30 cycles";
    EXPECT_EQ(advice_.input_use[advice_t::INPUT_LOADING], int{advice_t::USE_LIVE});
    EXPECT_EQ(advice_.verdict, int{advice_t::VERDICT_EXCEEDED});
  }
  ASSERT_TRUE(until_health_after_now());
  std::printf("under load: %d cycles late, the longest %.0f ms\n",
              static_cast<int>(health_.num_deadline_misses), 1e3 * health_.cycle_max_s);
}

// The whole grid each 10 ms on a machine that is busy: cycles are late, surely.
TEST_F(BusyMachine, CyclesThatComeLateAreCountedAndToldAndStillRight) {
  hull_file_ = std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/s175.hull.toml";
  oracle_ = std::make_unique<Oracle>(hull_file_);
  promises_.cycle_s = 0.01;
  start();
  send_sea(kBadSea_m);
  ASSERT_TRUE(until_advice());
  const Load load;
  ASSERT_TRUE(until([this] { return health_.num_deadline_misses > 0; }));
  ASSERT_TRUE(until([this] { return alerts_[kLateAlert].state == alert_t::STATE_ACTIVE; }));
  EXPECT_EQ(alerts_[kLateAlert].priority, int{alert_t::PRIORITY_CAUTION});
  ASSERT_TRUE(until_advice());
}

TEST_F(BusyMachine, StoppedForHalfASecondItCountsTellsAndRecovers) {
  start({}, clock_environment());
  send_sea(kBadSea_m);
  ASSERT_TRUE(until_advice());
  ASSERT_TRUE(until_health_after_now());
  const std::int64_t misses = health_.num_deadline_misses;
  advisor_.signal(SIGSTOP);
  listen(0.6);
  const int before = num_advices_;
  advisor_.signal(SIGCONT);
  ASSERT_TRUE(until([&] { return health_.num_deadline_misses > misses; })) << "not counted";
  EXPECT_GT(num_advices_, before);
  ASSERT_TRUE(
      until([this] { return advisor_.journal().find("ms, had the processor for ") != std::string::npos; }));
  ASSERT_TRUE(until([this] { return alerts_[kLateAlert].state == alert_t::STATE_ACTIVE; })) << "not told";
  step_clock(61.0);  // told for a minute after the last late cycle
  ASSERT_TRUE(until([this] { return alerts_[kLateAlert].state == alert_t::STATE_NORMAL; })) << "not over";
  ASSERT_TRUE(until_advice());
}

// A subscriber with a full receive buffer, and a display that is stopped: the kernel drops their copies.
TEST_F(BusyMachine, AConsumerThatNeverReadsHoldsUpNothing) {
  lcm::LCM deaf(url_);
  ASSERT_TRUE(deaf.good());
  deaf.subscribe("QS_.*", &BusyMachine::ignore, static_cast<BusyMachine*>(this));
  const pid_t display = fork();
  if (display == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    execl(QUICKSTRIP_DISPLAY_PROGRAM, QUICKSTRIP_DISPLAY_PROGRAM, "--url", url_.c_str(), "--port", "0",
          nullptr);
    _exit(127);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  kill(display, SIGSTOP);
  start();
  send_sea(kBadSea_m);
  ASSERT_TRUE(until_advice());
  const int before = num_advices_;
  listen(3.0);
  EXPECT_GE(num_advices_ - before, 20) << "of 30 cycles";
  ASSERT_TRUE(until_health_after_now());
  EXPECT_EQ(health_.publish_failures, 0);
  kill(display, SIGKILL);
  waitpid(display, nullptr, 0);
}

}  // namespace
}  // namespace quickstrip::faults
