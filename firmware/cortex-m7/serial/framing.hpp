// Frames on a serial line: FRAMING.md. Encoder and decoder; no heap, no I/O, bounded by the byte.
//
// frame = 0x00, COBS(channel, data, CRC-32 of both, low byte first), 0x00. A zero byte stands nowhere else,
// so that a reader who lost its place is back in step with the next frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace quickstrip {

/// Of channel byte and data; reflected polynomial 0xEDB88320 (that of Ethernet and zip).
class Crc32 {
 public:
  void add(std::uint8_t byte);
  [[nodiscard]] std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = 0xFFFFFFFFu;
};

inline constexpr std::size_t kMaxFrameData = 4096;

/// Where encoded bytes go, a few hundred at a time.
class ByteSink {
 public:
  ByteSink() = default;
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;
  virtual ~ByteSink() = default;
  virtual void put(std::span<const std::uint8_t> bytes) = 0;
};

/// False, and nothing sent, above kMaxFrameData.
bool send_frame(std::uint8_t channel, std::span<const std::uint8_t> data, ByteSink& sink);

struct Frame {
  std::uint8_t channel = 0;
  std::span<const std::uint8_t> data;  // valid until the next byte is taken
};

/// Of frames since the start.
struct FrameCounters {
  std::uint32_t good = 0;
  std::uint32_t corrupted = 0;  // wrong CRC, cut short, impossible code
  std::uint32_t too_long = 0;
};

class FrameDecoder {
 public:
  enum class Event : std::uint8_t { kNone, kFrame, kBad };

  /// kFrame: frame() is the one that this byte ends. kBad: it ends one that is to be thrown away.
  Event take(std::uint8_t byte);
  [[nodiscard]] Frame frame() const { return frame_; }
  [[nodiscard]] const FrameCounters& counters() const { return counters_; }

 private:
  Event finish();
  void store(std::uint8_t byte);
  void begin();

  static constexpr std::size_t kOverhead = 1 + 4;  // channel and CRC
  std::array<std::uint8_t, kMaxFrameData + kOverhead> bytes_{};
  std::size_t size_ = 0;
  std::uint8_t left_ = 0;     // bytes of the COBS block that are still to come
  bool is_zero_due_ = false;  // behind this block
  bool has_begun_ = false;    // bytes since the last delimiter
  bool is_too_long_ = false;
  Frame frame_;
  FrameCounters counters_;
};

}  // namespace quickstrip
