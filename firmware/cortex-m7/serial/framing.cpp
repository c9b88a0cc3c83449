#include "firmware/cortex-m7/serial/framing.hpp"

namespace quickstrip {
namespace {

constexpr std::uint8_t kDelimiter = 0;
constexpr std::uint8_t kFullBlock = 0xFF;  // 254 bytes without a zero behind them

std::array<std::uint8_t, 4> low_byte_first(std::uint32_t number) {
  std::array<std::uint8_t, 4> bytes{};
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(number & 0xFFu);
    number >>= 8u;
  }
  return bytes;
}

/// COBS in one pass: a block is kept until its length is known.
class BlockEncoder {
 public:
  explicit BlockEncoder(ByteSink& sink) : sink_(sink) {}

  void add(std::uint8_t byte) {
    if (byte != 0) {
      block_[size_++] = byte;
    }
    if (byte == 0 || size_ == kFullBlock) {
      flush();
    }
  }
  /// The last block, which may be empty, ends with the frame.
  void finish() { flush(); }

 private:
  void flush() {
    block_[0] = static_cast<std::uint8_t>(size_);
    sink_.put(std::span(block_).first(size_));
    size_ = 1;
  }

  ByteSink& sink_;
  std::array<std::uint8_t, kFullBlock> block_{};
  std::size_t size_ = 1;  // the code byte's room is at the front
};

}  // namespace

void Crc32::add(std::uint8_t byte) {
  state_ ^= byte;
  for (int bit = 0; bit < 8; ++bit) {
    state_ = (state_ >> 1u) ^ ((state_ & 1u) != 0 ? 0xEDB88320u : 0u);
  }
}

bool send_frame(std::uint8_t channel, std::span<const std::uint8_t> data, ByteSink& sink) {
  if (data.size() > kMaxFrameData) {
    return false;
  }
  const std::array<std::uint8_t, 1> delimiter{kDelimiter};
  Crc32 crc;
  BlockEncoder blocks(sink);
  sink.put(delimiter);
  crc.add(channel);
  blocks.add(channel);
  for (const std::uint8_t byte : data) {
    crc.add(byte);
    blocks.add(byte);
  }
  for (const std::uint8_t byte : low_byte_first(crc.value())) {
    blocks.add(byte);
  }
  blocks.finish();
  sink.put(delimiter);
  return true;
}

void FrameDecoder::begin() {
  size_ = 0;
  left_ = 0;
  is_zero_due_ = false;
  has_begun_ = false;
  is_too_long_ = false;
}

void FrameDecoder::store(std::uint8_t byte) {
  if (size_ < bytes_.size()) {
    bytes_[size_++] = byte;
  } else {
    is_too_long_ = true;
  }
}

FrameDecoder::Event FrameDecoder::take(std::uint8_t byte) {
  if (byte == kDelimiter) {
    return finish();
  }
  if (left_ > 0) {
    --left_;
    store(byte);
    return Event::kNone;
  }
  if (is_zero_due_) {
    store(0);
  }
  has_begun_ = true;
  left_ = static_cast<std::uint8_t>(byte - 1);
  is_zero_due_ = byte != kFullBlock;
  return Event::kNone;
}

FrameDecoder::Event FrameDecoder::finish() {
  const bool is_between = !has_begun_;  // of two delimiters: nothing is lost
  const bool is_cut = left_ > 0 || size_ < kOverhead;
  const bool is_too_long = is_too_long_;
  const std::size_t size = size_;
  begin();
  if (is_between) {
    return Event::kNone;
  }
  if (is_too_long) {
    ++counters_.too_long;
    return Event::kBad;
  }
  Crc32 crc;
  for (std::size_t i = 0; i + 4 < size; ++i) {
    crc.add(bytes_[i]);
  }
  const auto expected = low_byte_first(crc.value());
  bool is_same = !is_cut;
  for (std::size_t i = 0; is_same && i < expected.size(); ++i) {
    is_same = bytes_[size - expected.size() + i] == expected[i];
  }
  if (!is_same) {
    ++counters_.corrupted;
    return Event::kBad;
  }
  ++counters_.good;
  frame_ = {bytes_[0], std::span(bytes_).subspan(1, size - kOverhead)};
  return Event::kFrame;
}

}  // namespace quickstrip
