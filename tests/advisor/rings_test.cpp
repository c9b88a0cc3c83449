#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <numeric>
#include <thread>
#include <vector>

#include "firmware/advisor/message_ring.hpp"
#include "firmware/advisor/record_ring.hpp"
#include "tests/support/heap_guard.hpp"

namespace quickstrip::test {
namespace {

std::vector<std::uint8_t> message_of(std::size_t size, std::uint8_t first) {
  std::vector<std::uint8_t> bytes(size);
  std::iota(bytes.begin(), bytes.end(), first);
  return bytes;
}

TEST(MessageRing, GivesBackWhatWasPutInOrder) {
  MessageRing<256> ring;
  RingMessage message;
  EXPECT_FALSE(ring.front(message));
  ASSERT_TRUE(ring.push(3, message_of(5, 1)));
  ASSERT_TRUE(ring.push(4, message_of(0, 0)));
  ASSERT_TRUE(ring.front(message));
  EXPECT_EQ(message.channel, 3U);
  EXPECT_EQ(std::vector(message.bytes.begin(), message.bytes.end()), message_of(5, 1));
  ring.pop();
  ASSERT_TRUE(ring.front(message));
  EXPECT_EQ(message.channel, 4U);
  EXPECT_TRUE(message.bytes.empty());
  ring.pop();
  EXPECT_FALSE(ring.front(message));
  EXPECT_EQ(ring.free(), 256U);
}

TEST(MessageRing, AMessageLiesInOnePieceWhereverTheRingEnds) {
  MessageRing<256> ring;
  RingMessage message;
  for (std::size_t turn = 0; turn < 1000; ++turn) {
    const std::size_t size = turn * 37 % 100;
    ASSERT_TRUE(ring.push(1, message_of(size, static_cast<std::uint8_t>(turn))));
    ASSERT_TRUE(ring.front(message));
    EXPECT_EQ(std::vector(message.bytes.begin(), message.bytes.end()),
              message_of(size, static_cast<std::uint8_t>(turn)));
    ring.pop();
  }
  EXPECT_FALSE(ring.front(message));
}

TEST(MessageRing, FullItRefusesWholeAndKeepsWhatItHas) {
  MessageRing<256> ring;
  ASSERT_TRUE(ring.push(1, message_of(100, 7)));
  ASSERT_TRUE(ring.push(2, message_of(100, 8)));
  EXPECT_FALSE(ring.push(3, message_of(100, 9)));
  EXPECT_FALSE(ring.push(3, message_of(300, 9)));  // never fits
  RingMessage message;
  ASSERT_TRUE(ring.front(message));
  EXPECT_EQ(message.channel, 1U);
  ring.pop();
  EXPECT_TRUE(ring.push(3, message_of(60, 9)));
}

TEST(MessageRing, AllocatesNothing) {
  const auto ring = std::make_unique<MessageRing<4096>>();
  const std::array<std::uint8_t, 64> bytes{};
  const HeapGuard guard;
  for (int i = 0; i < 100; ++i) {
    ring->push(1, bytes);
    RingMessage message;
    ring->front(message);
    ring->pop();
  }
  EXPECT_EQ(guard.allocations(), 0U);
}

// Each message's bytes all hold its number: one that was torn or overtaken would show.
TEST(MessageRing, BetweenTwoThreadsNothingIsTornLostOrOutOfOrder) {
  constexpr std::uint32_t kMessages = 100'000;
  const auto ring = std::make_unique<MessageRing<8192>>();
  std::thread writer([&ring] {
    std::array<std::uint8_t, 777> bytes{};
    for (std::uint32_t i = 0; i < kMessages;) {
      bytes.fill(static_cast<std::uint8_t>(i));
      i += ring->push(i, std::span(bytes).first(i % bytes.size())) ? 1U : 0U;
    }
  });
  for (std::uint32_t expected = 0; expected < kMessages;) {
    RingMessage message;
    if (!ring->front(message)) {
      continue;
    }
    ASSERT_EQ(message.channel, expected);
    ASSERT_EQ(message.bytes.size(), expected % 777);
    for (const std::uint8_t byte : message.bytes) {
      ASSERT_EQ(byte, static_cast<std::uint8_t>(expected));
    }
    ring->pop();
    ++expected;
  }
  writer.join();
}

TEST(RecordRing, KeepsTheOrderAndCountsWhatIsLost) {
  RecordRing<int, 4> ring;
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(ring.push(i), i < 4);
  }
  EXPECT_EQ(ring.lost(), 2);
  int out = -1;
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(ring.pop(out));
    EXPECT_EQ(out, i);
  }
  EXPECT_FALSE(ring.pop(out));
}

}  // namespace
}  // namespace quickstrip::test
