// The serial line of a board: bytes as they come. A frame that is taken for good is one that somebody could
// have sent; the session behind it answers each QS_TIME with frames of its own, and nothing else with any.
#include <algorithm>
#include <memory>

#include "core/advice/nordforsk.hpp"
#include "firmware/cortex-m7/serial/serial_session.hpp"
#include "msgs/convert/encode.hpp"
#include "tests/bad_input/good_messages.hpp"
#include "tests/fuzz/good_bytes.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/tiny_ship.hpp"

namespace quickstrip::fuzz {
namespace {

constexpr int kMaxCycles = 8;

class Line final : public Board {
 public:
  void put(std::span<const std::uint8_t> bytes) override {
    sent.insert(sent.end(), bytes.begin(), bytes.end());
  }
  std::uint64_t timer_us() override { return 0; }
  Bytes sent;
};

class Taken final : public ByteSink {
 public:
  void put(std::span<const std::uint8_t> bytes) override {
    all.insert(all.end(), bytes.begin(), bytes.end());
  }
  Bytes all;
};

/// Encoded again and taken again it is the same frame.
void require_round_trip(const Frame& frame) {
  require(frame.data.size() <= kMaxFrameData, "a frame is no longer than the longest");
  Taken line;
  require(send_frame(frame.channel, frame.data, line), "a frame that came can be sent");
  static FrameDecoder decoder;
  for (const std::uint8_t byte : line.all) {
    if (decoder.take(byte) == FrameDecoder::Event::kFrame) {
      const Frame again = decoder.frame();
      require(again.channel == frame.channel &&
                  std::equal(again.data.begin(), again.data.end(), frame.data.begin(), frame.data.end()),
              "a frame comes as it was sent");
      return;
    }
  }
  require(false, "a frame that was sent comes");
}

void add_frame(SerialChannel channel, std::span<const std::uint8_t> data, Bytes& out) {
  Taken line;
  require(send_frame(static_cast<std::uint8_t>(channel), data, line), "the seed fits a frame");
  out.insert(out.end(), line.all.begin(), line.all.end());
}

/// What frames there are in the bytes, checked; those of time beyond the first few are left out, a cycle
/// each.
Bytes frames_of(std::span<const std::uint8_t> bytes) {
  FrameDecoder decoder;
  int num_times = 0;
  Bytes kept(bytes.begin(), bytes.end());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (decoder.take(bytes[i]) != FrameDecoder::Event::kFrame) {
      continue;
    }
    require_round_trip(decoder.frame());
    if (SerialChannel{decoder.frame().channel} == SerialChannel::kTime && ++num_times == kMaxCycles) {
      kept.resize(i + 1);
      break;
    }
  }
  return kept;
}

}  // namespace

void run_frames(std::span<const std::uint8_t> bytes) {
  static Line line;
  static const auto session = [] {
    auto made = std::make_unique<SerialSession>(line);
    SessionOptions options;
    options.log_clock = true;
    require(made->configure(tiny_ship(), *nordforsk_merchant(tiny_ship()), options).ok(), "the ship is good");
    return made;
  }();
  const LineReport before = session->report();
  line.sent.clear();
  for (const std::uint8_t byte : frames_of(bytes)) {
    session->take(byte);
  }
  session->take(0);  // whatever was begun
  require(session->report().good_frames >= before.good_frames, "counters only grow");
  FrameDecoder decoder;
  for (const std::uint8_t byte : line.sent) {
    require(decoder.take(byte) != FrameDecoder::Event::kBad, "what is sent are good frames");
  }
}

std::vector<Bytes> frames_seeds() {
  Bytes all;
  add_frame(SerialChannel::kOwnShip, good_bytes("OWN_SHIP"), all);
  add_frame(SerialChannel::kSeaState, good_bytes("SEA_STATE"), all);
  add_frame(SerialChannel::kLoading, good_bytes("LOADING"), all);
  quickstrip::clock_t time{};
  time.utime = test::kStart;
  Bytes data(64);
  add_frame(SerialChannel::kTime, encode(time, data), all);
  return {all};
}

}  // namespace quickstrip::fuzz
