// Frames of the serial line: what goes in comes out, and nothing else does.
#include "firmware/cortex-m7/serial/framing.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace quickstrip {
namespace {

class Line final : public ByteSink {
 public:
  void put(std::span<const std::uint8_t> bytes) override {
    all.insert(all.end(), bytes.begin(), bytes.end());
  }
  std::vector<std::uint8_t> all;
};

struct Received {
  std::uint8_t channel;
  std::vector<std::uint8_t> data;
  bool operator==(const Received&) const = default;
};

std::vector<Received> receive(std::span<const std::uint8_t> bytes, FrameDecoder& decoder) {
  std::vector<Received> out;
  for (const std::uint8_t byte : bytes) {
    if (decoder.take(byte) == FrameDecoder::Event::kFrame) {
      const Frame frame = decoder.frame();
      out.push_back({frame.channel, {frame.data.begin(), frame.data.end()}});
    }
  }
  return out;
}

/// Data with runs of zeros and of others around COBS's block of 254.
std::vector<std::uint8_t> data_of(std::size_t size, std::mt19937& random) {
  std::vector<std::uint8_t> data(size);
  for (std::uint8_t& byte : data) {
    byte = random() % 4 == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(random());
  }
  return data;
}

TEST(Framing, ChecksumIsThatOfTheStandard) {
  Crc32 crc;
  for (const char c : std::string_view("123456789")) {
    crc.add(static_cast<std::uint8_t>(c));
  }
  EXPECT_EQ(crc.value(), 0xCBF43926u);  // the check value of CRC-32/ISO-HDLC
}

TEST(Framing, AFrameIsWrittenAsTheDocumentShowsIt) {
  Line line;
  ASSERT_TRUE(send_frame(4, std::vector<std::uint8_t>{0x11, 0x00, 0x22}, line));
  ASSERT_EQ(line.all.size(), 11U);
  EXPECT_EQ(line.all.front(), 0);
  EXPECT_EQ(line.all[1], 3);  // two bytes and a zero
  EXPECT_EQ(line.all[2], 4);
  EXPECT_EQ(line.all[3], 0x11);
  EXPECT_EQ(line.all[5], 0x22);
  EXPECT_EQ(line.all.back(), 0);
}

TEST(Framing, EveryLengthComesBackAsItWentIn) {
  std::mt19937 random(1);
  FrameDecoder decoder;
  for (std::size_t size = 0; size <= kMaxFrameData; size += size < 600 ? 1 : 97) {
    for (const bool has_zeros : {false, true}) {
      std::vector<std::uint8_t> data(size, 0x55);
      data = has_zeros ? data_of(size, random) : data;
      Line line;
      ASSERT_TRUE(send_frame(7, data, line));
      EXPECT_EQ(receive(line.all, decoder), (std::vector<Received>{{7, data}})) << size;
    }
  }
  EXPECT_EQ(decoder.counters().corrupted, 0U);
}

TEST(Framing, OneMoreThanTheMostIsNotSent) {
  Line line;
  EXPECT_FALSE(send_frame(1, std::vector<std::uint8_t>(kMaxFrameData + 1), line));
  EXPECT_TRUE(line.all.empty());
}

TEST(Framing, AnyChangedByteIsNoticedAndTheNextFrameComes) {
  std::mt19937 random(2);
  const auto data = data_of(300, random);
  Line one;
  ASSERT_TRUE(send_frame(2, data, one));
  for (std::size_t at = 1; at + 1 < one.all.size(); ++at) {
    FrameDecoder decoder;
    auto bytes = one.all;
    bytes[at] ^= static_cast<std::uint8_t>(1u << (random() % 8));
    bytes.insert(bytes.end(), one.all.begin(), one.all.end());
    EXPECT_EQ(receive(bytes, decoder), (std::vector<Received>{{2, data}})) << at;
    EXPECT_GE(decoder.counters().corrupted, 1U);
  }
}

TEST(Framing, AFrameCutShortIsCountedAndTheNextFrameComes) {
  const std::vector<std::uint8_t> data(20, 9);
  Line one;
  ASSERT_TRUE(send_frame(2, data, one));
  for (std::size_t length = 2; length + 1 < one.all.size(); ++length) {
    FrameDecoder decoder;
    std::vector<std::uint8_t> bytes(one.all.begin(), one.all.begin() + static_cast<std::ptrdiff_t>(length));
    bytes.insert(bytes.end(), one.all.begin(), one.all.end());
    EXPECT_EQ(receive(bytes, decoder), (std::vector<Received>{{2, data}})) << length;
    EXPECT_EQ(decoder.counters().corrupted, 1U) << length;
  }
}

TEST(Framing, ALineThatNeverStopsIsCountedAsTooLong) {
  FrameDecoder decoder;
  std::vector<std::uint8_t> bytes(3 * kMaxFrameData, 0x41);
  bytes.push_back(0);
  EXPECT_TRUE(receive(bytes, decoder).empty());
  EXPECT_EQ(decoder.counters().too_long, 1U);
}

TEST(Framing, NoiseGivesNoFrames) {
  std::mt19937 random(3);
  FrameDecoder decoder;
  std::vector<std::uint8_t> noise(1'000'000);
  for (std::uint8_t& byte : noise) {
    byte = static_cast<std::uint8_t>(random());
  }
  EXPECT_TRUE(receive(noise, decoder).empty());  // one in four thousand million would be by chance
  EXPECT_GT(decoder.counters().corrupted, 1000U);
}

}  // namespace
}  // namespace quickstrip
