// The running advisor on a bus within this process: what its own health says of heap, memory and time.
#include "firmware/advisor/live.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/advice/nordforsk.hpp"
#include "firmware/heap_watch/heap_watch.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip::test {
namespace {

using std::chrono::milliseconds;

std::int64_t utime_now() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

own_ship_t own_ship(std::int16_t source_id) {
  own_ship_t m{};
  m.utime = utime_now();
  m.source_id = source_id;
  m.valid = int{own_ship_t::VALID_HEADING} | int{own_ship_t::VALID_SPEED_THROUGH_WATER};
  m.heading_deg = 30.0;
  m.speed_through_water_kn = 12.0;
  return m;
}

sea_state_t sea_state(double hs_m, std::int16_t source_id) {
  sea_state_t m{};
  m.utime = utime_now();
  m.source_id = source_id;
  m.num_systems = 1;
  m.valid = sea_state_t::VALID_SPREADING;
  m.hs_m[0] = hs_m;
  m.period_s[0] = 9.0;
  m.dir_from_deg[0] = 200.0;
  m.spreading_deg[0] = 25.0;
  return m;
}

class LiveTest : public testing::Test {
 protected:
  LiveTest() {
    hull_->grid.heading_step = radians(10.0);
    options_.cycle_period_s = 0.05;
    bus_.subscribeFunction<LiveTest*>(
        "QS_HEALTH",
        [](const lcm::ReceiveBuffer* buffer, const std::string&, LiveTest* test) {
          health_t health{};
          if (health.decode(buffer->data, 0, static_cast<int>(buffer->data_size)) > 0) {
            const std::scoped_lock lock(test->seen_);
            test->health_.push_back(health);
          }
        },
        this);
  }

  void start() {
    const Result<Criteria> criteria = nordforsk_merchant(*hull_);
    ASSERT_TRUE(criteria.ok());
    ASSERT_TRUE(session_->configure(*hull_, *criteria, options_).ok());
    live_ = std::make_unique<Live>(bus_, "QS_", *session_, options_, nullptr);
    runner_ = std::thread([this] {
      std::string why_not;
      is_well_ = live_->run({.real_time = RealTime::kOff}, stop_, why_not);
    });
  }
  void stop() {
    stop_ = true;
    runner_.join();
  }
  std::vector<health_t> health() {
    const std::scoped_lock lock(seen_);
    return health_;
  }
  template <typename Message>
  void publish(const char* channel, const Message& message) {
    bus_.publish(channel, &message);
  }

  std::unique_ptr<Hull> hull_ = std::make_unique<Hull>(s175());
  SessionOptions options_;
  lcm::LCM bus_{"memq://"};
  std::unique_ptr<Session> session_ = std::make_unique<Session>();
  std::unique_ptr<Live> live_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> is_well_{false};
  std::thread runner_;
  std::mutex seen_;
  std::vector<health_t> health_;
};

// 20 Hz, own ship and sea each 50 ms.
TEST_F(LiveTest, TheCyclesThreadAllocatesNothingAndMemoryStaysAsItIs) {
  start();
  for (int i = 0; i < 120; ++i) {
    publish("QS_OWN_SHIP", own_ship(1));
    publish("QS_SEA_STATE", sea_state(3.0 + 0.01 * i, 1));
    std::this_thread::sleep_for(milliseconds(50));
  }
  testing::internal::CaptureStderr();
  stop();
  const std::string totals = testing::internal::GetCapturedStderr();
  ASSERT_TRUE(is_well_);
  const std::vector<health_t> told = health();
  ASSERT_GE(told.size(), 5U);
  EXPECT_EQ(told.front().state, int{health_t::STATE_STARTING});
  EXPECT_EQ(told.back().state, int{health_t::STATE_STOPPING});
  EXPECT_EQ(told.back().heap_calls_in_cycle, 0);
  EXPECT_EQ(told.back().publish_failures, 0);
  EXPECT_GT(told.back().num_cycles, 15);  // of 120, also under a sanitizer and other load
  if (kCountsMalloc) {                    // a sanitizer's own memory grows, and it has locks
    EXPECT_NE(totals.find("within a cycle the processor was given up 0 times"), std::string::npos) << totals;
    // After a second of warming up. The other threads and this test's own messages share the process: 64 kB.
    EXPECT_NEAR(static_cast<double>(told.back().resident_bytes), static_cast<double>(told[2].resident_bytes),
                65536.0);
    EXPECT_LE(told.back().page_faults - told[2].page_faults, 16);
  }
}

TEST_F(LiveTest, ASenderWhoIsNotAllowedIsCountedAndNeverTakesThePlaceOfTheAllowedOne) {
  ASSERT_TRUE(options_.allowed.allow(Input::kSeaState, 3));
  start();
  for (int i = 0; i < 30; ++i) {
    publish("QS_OWN_SHIP", own_ship(1));
    publish("QS_SEA_STATE", sea_state(3.0, 3));
    for (int k = 0; k < 10; ++k) {
      publish("QS_SEA_STATE", sea_state(12.0, 4));  // after it, in the same cycle
    }
    std::this_thread::sleep_for(milliseconds(50));
  }
  std::this_thread::sleep_for(milliseconds(1200));
  stop();
  const auto sea = static_cast<std::size_t>(Input::kSeaState);
  EXPECT_EQ(session_->advice().no_advice, 0);
  EXPECT_EQ(session_->advice().input_source_id[sea], 3);
  EXPECT_NEAR(session_->inputs().sea_state().sea.systems[0].hs, 3.0, 1e-12);
  const std::vector<health_t> told = health();
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back().input_refused[sea], 300);
  EXPECT_EQ(told.back().input_last_refusal[sea], static_cast<int>(Refusal::kForeignSource));
}

TEST_F(LiveTest, AFailedSelfTestGivesNoAdviceAndSaysWhichInEveryCycle) {
  session_->note_self_test(SelfTestItem::kSectionTable);
  start();
  for (int i = 0; i < 10; ++i) {
    publish("QS_OWN_SHIP", own_ship(1));
    publish("QS_SEA_STATE", sea_state(3.0, 1));
    std::this_thread::sleep_for(milliseconds(50));
  }
  stop();
  EXPECT_EQ(session_->advice().no_advice, static_cast<int>(NoAdvice::kSelfTestFailed));
  EXPECT_STREQ(reinterpret_cast<const char*>(session_->advice().no_advice_text),
               "No advice, because the self-test failed: the section table in memory is damaged");
  const std::vector<health_t> told = health();
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.front().state, int{health_t::STATE_FAULT});
  EXPECT_EQ(told.back().state, int{health_t::STATE_FAULT});
}

}  // namespace
}  // namespace quickstrip::test
