// Lines in, messages out: the gateway without its sockets. The live process, the replay of a file and the
// tests run this same code.
//
// One Reader a source; what they read goes into ShipState and, from the believed sender alone, into
// MotionWindow. turn(now) sends what is due: QS_OWN_SHIP at most `rate_hz` times a second and only with news,
// QS_MOTION every `motion_every_s`, QS_TIME every second of a record. No heap after construction, no clock of
// its own, no I/O but through the sink.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "firmware/nmea/motion_window.hpp"
#include "firmware/nmea/reader.hpp"
#include "firmware/nmea/ship_state.hpp"
#include "msgs/convert/encode.hpp"

namespace quickstrip::nmea {

inline constexpr std::size_t kMaxSources = 16;

enum class Channel : std::uint8_t { kOwnShip = 0, kMotion = 1, kTime = 2 };
inline constexpr std::array<std::string_view, 3> kChannelNames{"OWN_SHIP", "MOTION", "TIME"};

/// Where messages go: a bus, a log, a test.
class Sink {
 public:
  Sink() = default;
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;
  virtual ~Sink() = default;
  virtual void send(Channel channel, std::int64_t utime, std::span<const std::uint8_t> bytes) = 0;
};

struct GatewayOptions {
  ReaderOptions reader;
  double stale_after_s = 5.0;
  double rate_hz = 1.0;
  double window_s = 1200.0;
  double motion_every_s = 60.0;
  bool record_clock = false;   // times are those before the lines, and QS_TIME is sent
  double record_speed = -1.0;  // told in QS_TIME; -1: as fast as possible
  std::int16_t source_id = 0;
};

struct GatewayCounts {
  FateCounts lines;
  std::int64_t own_ships = 0;
  std::int64_t own_ships_over_ground = 0;  // of these, for want of speed through the water
  std::int64_t motions = 0;
};

class Gateway {
 public:
  Gateway(const GatewayOptions& options, std::size_t num_sources, Sink& sink);

  /// A line of source `source`, without its end, that arrived at `arrival`. With the record's clock the time
  /// before the line counts instead, and messages fall due by it.
  void take(std::size_t source, std::string_view line, std::int64_t arrival);
  /// A line that was too long for the framer.
  void drop_long_line() { counts_.lines.count(Fate::kTooLong); }
  /// A whole datagram: header, one line or several.
  void take_datagram(std::size_t source, std::string_view datagram, std::int64_t arrival);
  /// Sends what is due at `now`.
  void turn(std::int64_t now);
  /// The end of a record: its last motion.
  void finish();

  [[nodiscard]] const GatewayCounts& counts() const { return counts_; }
  [[nodiscard]] std::int64_t num_disagreements() const { return state_.num_disagreements(); }
  /// The record's time of the last line; 0 before the first.
  [[nodiscard]] std::int64_t record_time() const { return record_time_; }

 private:
  Fate read(std::size_t source, std::string_view line, std::int64_t arrival);
  void keep(const Readings& readings, Rank rank, std::int64_t utime);
  void send_own_ship(std::int64_t now);
  void send_motion(std::int64_t now);
  void send_time(std::int64_t now);
  template <typename Message>
  void send(Channel channel, Message& message);

  GatewayOptions options_;
  Sink& sink_;
  std::vector<Reader> readers_;
  ShipState state_;
  std::unique_ptr<MotionWindow> window_;
  GatewayCounts counts_;
  bool has_news_ = false;
  bool has_time_ = false;  // the record has begun
  std::int64_t record_time_ = 0;
  std::int64_t own_ship_sent_ = 0;
  std::int64_t motion_sent_ = 0;
  std::int64_t motion_utime_ = 0;
  std::int64_t time_sent_ = 0;
  std::array<std::int32_t, kChannelNames.size()> seq_{};
  std::array<std::uint8_t, 2048> bytes_{};  // of one message
};

}  // namespace quickstrip::nmea
