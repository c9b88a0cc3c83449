#include "firmware/advisor/publisher.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <vector>

#include "firmware/session/session.hpp"
#include "tests/support/heap_guard.hpp"

namespace quickstrip::test {
namespace {

/// A bus that can be held up, and can refuse.
class SlowBus : public Outbox {
 public:
  bool send(OutChannel channel, std::span<const std::uint8_t> bytes) override {
    const std::scoped_lock lock(stall);
    sent.emplace_back(static_cast<int>(channel), bytes.size());
    return !refuses;
  }
  std::mutex stall;
  std::atomic<bool> refuses{false};
  std::vector<std::pair<int, std::size_t>> sent;
};

TEST(Publisher, GivesEverythingToTheBusInOrderBeforeItStops) {
  SlowBus bus;
  const auto publisher = std::make_unique<Publisher>(bus);
  publisher->start();
  const std::vector<std::uint8_t> bytes(1000);
  for (std::size_t i = 0; i < 200; ++i) {
    ASSERT_TRUE(publisher->send(static_cast<OutChannel>(i % kNumOutChannels), std::span(bytes).first(i)));
  }
  publisher->stop();
  ASSERT_EQ(bus.sent.size(), 200U);
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_EQ(bus.sent[i], (std::pair{static_cast<int>(i % kNumOutChannels), i}));
  }
}

TEST(Publisher, WhileTheBusStallsTheSenderIsToldAndNeverHeldUp) {
  SlowBus bus;
  const auto publisher = std::make_unique<Publisher>(bus);
  const std::vector<std::uint8_t> bytes(60'000);
  int taken = 0;
  {
    const std::scoped_lock stalled(bus.stall);
    publisher->start();
    const HeapGuard guard;
    for (int i = 0; i < 100; ++i) {  // would never end if it waited for the bus
      taken += publisher->send(OutChannel::kGrid, bytes) ? 1 : 0;
    }
    EXPECT_EQ(guard.allocations(), 0U);
    EXPECT_FALSE(publisher->has_room_for_a_cycle());
  }
  EXPECT_GE(taken, 10);
  EXPECT_LT(taken, 100);
  publisher->stop();
  EXPECT_EQ(bus.sent.size(), static_cast<std::size_t>(taken));
  EXPECT_TRUE(publisher->has_room_for_a_cycle());
}

template <typename... Messages>
std::size_t encoded_bytes() {
  return (static_cast<std::size_t>(Messages{}.getEncodedSize()) + ...);
}

TEST(Publisher, HoldsFiveOfTheLargestCycles) {
  const std::size_t each =
      encoded_bytes<advice_t, grid_t, outlook_t, response_t, comparison_t, health_t, limits_t, logbook_t>();
  const std::size_t largest = each + 8 * encoded_bytes<response_t>() + 3 * encoded_bytes<alert_t>();
  std::printf("a cycle sends at most %zu bytes, with eight answers and three alerts more %zu\n", each,
              largest);
  EXPECT_LE(5 * largest, Publisher::kBytes);
}

TEST(Publisher, CountsWhatTheBusRefuses) {
  SlowBus bus;
  bus.refuses = true;
  const auto publisher = std::make_unique<Publisher>(bus);
  publisher->start();
  ASSERT_TRUE(publisher->send(OutChannel::kAdvice, {}));
  ASSERT_TRUE(publisher->send(OutChannel::kHealth, {}));
  publisher->stop();
  EXPECT_EQ(publisher->num_refused_by_bus(), 2);
}

}  // namespace
}  // namespace quickstrip::test
