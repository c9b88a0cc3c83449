#include "firmware/advisor/triple_buffer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <thread>

namespace quickstrip {
namespace {

TEST(TripleBuffer, NothingIsTakenBeforeSomethingIsPublished) {
  TripleBuffer<int> buffer;
  EXPECT_FALSE(buffer.take());
  EXPECT_EQ(buffer.front(), 0);
}

TEST(TripleBuffer, TheNewestWinsAndTheOvertakenAreCounted) {
  TripleBuffer<int> buffer;
  for (int i = 1; i <= 5; ++i) {
    buffer.back() = i;
    buffer.publish();
  }
  ASSERT_TRUE(buffer.take());
  EXPECT_EQ(buffer.front(), 5);
  EXPECT_EQ(buffer.overtaken(), 4);
}

TEST(TripleBuffer, OneValueIsTakenOnceAndStaysReadable) {
  TripleBuffer<int> buffer;
  buffer.back() = 7;
  buffer.publish();
  ASSERT_TRUE(buffer.take());
  EXPECT_FALSE(buffer.take());
  EXPECT_EQ(buffer.front(), 7);
}

TEST(TripleBuffer, WhatTheReaderHoldsIsNotOverwrittenByLaterWrites) {
  TripleBuffer<int> buffer;
  buffer.back() = 1;
  buffer.publish();
  ASSERT_TRUE(buffer.take());
  for (int i = 2; i <= 10; ++i) {
    buffer.back() = i;
    EXPECT_EQ(buffer.front(), 1);
    buffer.publish();
  }
  EXPECT_EQ(buffer.front(), 1);
}

// A value whose 64 words are all equal: a torn read shows as two different words.
struct Wide {
  std::array<std::int64_t, 64> word{};
};

TEST(TripleBuffer, UnderTwoThreadsNoReadIsTornNoneGoesBackAndTheLastArrives) {
  constexpr std::int64_t kRounds = 300'000;
  const auto buffer = std::make_unique<TripleBuffer<Wide>>();
  std::thread writer([&buffer] {
    for (std::int64_t i = 1; i <= kRounds; ++i) {
      buffer->back().word.fill(i);
      buffer->publish();
    }
  });
  std::int64_t last = 0;
  std::int64_t taken = 0;
  std::int64_t torn = 0;
  std::int64_t backward = 0;
  while (last < kRounds) {
    if (!buffer->take()) {
      std::this_thread::yield();
      continue;
    }
    ++taken;
    const Wide& wide = buffer->front();
    for (const std::int64_t word : wide.word) {
      torn += word != wide.word[0] ? 1 : 0;
    }
    backward += wide.word[0] <= last ? 1 : 0;
    last = wide.word[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(backward, 0);
  EXPECT_EQ(last, kRounds);
  EXPECT_EQ(taken + buffer->overtaken(), kRounds);  // each one was taken or counted as lost
}

}  // namespace
}  // namespace quickstrip
