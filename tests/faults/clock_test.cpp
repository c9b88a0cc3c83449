// The system clock stepped, under a running advisor; and a sea that claims to come from the future.
#include "tests/faults/fault_test.hpp"

namespace quickstrip::faults {
namespace {

constexpr double kHour_s = 3600.0;
constexpr std::size_t kSea = health_t::INPUT_SEA_STATE;

class SteppedClock : public FaultTest {
 protected:
  void start_at_sea(double hs_m) {
    start({}, clock_environment());
    send_sea(hs_m);
    ASSERT_TRUE(until_advice()) << why_not();
  }
};

TEST_F(SteppedClock, BackByHoursThereIsNoAdviceUntilInputsOfTheNewTimeCome) {
  start_at_sea(kGoodSea_m);
  step_clock(-3.0 * kHour_s);
  ASSERT_TRUE(until_no_advice()) << "a sea from the future of the clock was used";
  listen(0.5);
  EXPECT_NE(advice_.no_advice, 0) << "own ship alone is not enough";
  EXPECT_NE(why_not().find("sea"), std::string::npos) << why_not();
  send_sea(kBadSea_m);
  ASSERT_TRUE(until_advice());
  EXPECT_EQ(advice_.verdict, int{advice_t::VERDICT_EXCEEDED});
}

TEST_F(SteppedClock, ForwardByHoursTheSeaIsStale) {
  start_at_sea(kGoodSea_m);
  step_clock(3.0 * kHour_s);
  ASSERT_TRUE(until_no_advice()) << "a sea three hours old was used";
  ASSERT_TRUE(until([this] { return why_not().find("sea") != std::string::npos; })) << why_not();
  send_sea(kGoodSea_m);
  ASSERT_TRUE(until_good());
}

TEST_F(SteppedClock, BackAndForthManyTimesNothingSticks) {
  start_at_sea(kBadSea_m);
  for (const double hours : {5.0, -9.0, 2.0, -0.5, 24.0, -48.0}) {
    step_clock(hours * kHour_s);
    listen(0.25);
    send_sea(kBadSea_m);
    ASSERT_TRUE(until_advice()) << "after " << hours << " h: " << why_not();
    const int before = num_healths_;
    ASSERT_TRUE(until([&] { return num_healths_ > before; }))
        << "health falls silent after " << hours << " h";
  }
}

TEST_F(SteppedClock, ASecondOrTwoDisturbNothing) {
  start_at_sea(kGoodSea_m);
  for (const double seconds : {2.0, -3.0, 1.0}) {
    step_clock(seconds);
    listen(0.5);
    EXPECT_TRUE(is_good(advice_)) << why_not();
  }
}

// A clock battery that is flat: 1970 until the GPS has set it.
TEST_F(SteppedClock, AtTheEpochThereIsNoAdviceAndTheRightTimeHeals) {
  start_at_sea(kGoodSea_m);
  const double to_epoch = static_cast<double>(now()) * 1e-6 - 100.0;
  step_clock(-to_epoch);
  has_sensors_ = false;  // they have the right time
  ASSERT_TRUE(until_no_advice());
  step_clock(to_epoch);
  has_sensors_ = true;
  ASSERT_TRUE(until_good()) << why_not();
}

TEST_F(SteppedClock, ASeaFromTheFutureIsRefusedAndCounted) {
  start_at_sea(kBadSea_m);
  const std::int64_t refused = health_.input_refused[kSea];
  for (const double ahead_s : {6.0, 60.0, kHour_s, 8760.0 * kHour_s}) {
    send_sea(kGoodSea_m, -ahead_s);
  }
  listen(0.5);
  EXPECT_EQ(advice_.verdict, int{advice_t::VERDICT_EXCEEDED}) << "the calm sea of tomorrow was believed";
  ASSERT_TRUE(until([&] { return health_.input_refused[kSea] > refused; }));
  constexpr int kFromTheFuture = 16;  // CHANNELS.md
  EXPECT_EQ(health_.input_last_refusal[kSea], kFromTheFuture);
}

}  // namespace
}  // namespace quickstrip::faults
