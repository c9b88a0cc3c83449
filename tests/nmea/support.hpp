// Sentences with their checksums, and a sink that keeps what is sent.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "firmware/nmea/gateway.hpp"
#include "quickstrip/clock_t.hpp"

namespace quickstrip::nmea::test {

/// "$" + body + "*hh"
inline std::string sealed(std::string_view body) {
  unsigned sum = 0;  // not our checksum(): by hand
  for (const char c : body) {
    sum ^= static_cast<unsigned char>(c);
  }
  char digits[4] = {};
  std::snprintf(digits, sizeof(digits), "*%02X", sum);
  return std::string(1, '$').append(body).append(digits);
}

inline ReaderOptions reader_options(std::string_view talkers = kDefaultTalkers) {
  ReaderOptions options;
  if (!options.talkers.set(talkers)) {
    std::abort();
  }
  return options;
}

inline GatewayOptions gateway_options() {
  GatewayOptions options;
  options.reader = reader_options();
  return options;
}

inline constexpr std::int64_t kSecond = 1'000'000;
inline constexpr std::int64_t kNow = 1'600'000'000 * kSecond;

/// Counts what comes and keeps the newest of each kind; no heap.
class KeepingSink : public Sink {
 public:
  void send(Channel channel, std::int64_t utime, std::span<const std::uint8_t> bytes) override {
    ++num[static_cast<std::size_t>(channel)];
    last_utime = utime;
    switch (channel) {
      case Channel::kOwnShip:
        all_decoded = all_decoded && decode(bytes, own_ship);
        break;
      case Channel::kMotion:
        all_decoded = all_decoded && decode(bytes, motion);
        break;
      case Channel::kTime:
        all_decoded = all_decoded && decode(bytes, time);
        break;
    }
  }
  [[nodiscard]] std::int64_t count(Channel channel) const { return num[static_cast<std::size_t>(channel)]; }

  std::array<std::int64_t, kChannelNames.size()> num{};
  std::int64_t last_utime = 0;
  bool all_decoded = true;
  own_ship_t own_ship{};
  motion_t motion{};
  quickstrip::clock_t time{};
};

}  // namespace quickstrip::nmea::test
