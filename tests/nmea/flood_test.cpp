// Hostile input: ten thousand malformed lines a second. Counts are asserted, never times.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "firmware/nmea/gateway.hpp"
#include "firmware/nmea/line_framer.hpp"
#include "tests/nmea/support.hpp"
#include "tests/support/heap_guard.hpp"

namespace quickstrip::nmea {
namespace {

using test::kNow;
using test::kSecond;
using test::sealed;

/// One of a few dozen ways to be wrong, none of which can pass by chance.
std::string malformed(std::mt19937& random) {
  std::string line = sealed("INVTG,215.11,T,239.79,M,9.1,N,16.9,K,A");
  switch (random() % 10) {
    case 0:
      line[1 + random() % 30] ^= 1;  // checksum
      return line;
    case 1:
      return line.substr(0, random() % (line.size() - 3));  // cut short
    case 2:
      return sealed("INVTG,nan,T,inf,M,1e300,N,16.9,K,A");
    case 3:
      return sealed("XXHDT,100.0,T");  // a talker of nobody's
    case 4:
      return sealed("HEHDT,-100000000.0,T");
    case 5:
      return sealed("YXXDR" + std::string(400, ','));
    case 6:
      return std::string(1, '\\').append(line);  // a TAG block without end
    case 7:
      return std::string(random() % 2000, static_cast<char>('!' + random() % 90));
    case 8:
      return sealed("HEHDT,,");
    default: {
      std::string noise(1 + random() % 200, ' ');
      for (char& c : noise) {
        c = static_cast<char>(128 + random() % 128);
      }
      return noise;
    }
  }
}

constexpr int kSeconds = 3;
constexpr int kBadPerSecond = 10'000;
constexpr int kGoodPerSecond = 20;  // ten headings and ten speeds

/// The bytes of a second: bad lines, and a good pair after every thousandth.
std::string second_of_flood(std::mt19937& random) {
  std::string bytes;
  for (int i = 0; i < kBadPerSecond; ++i) {
    bytes += malformed(random) + "\r\n";
    if (i % 1000 == 999) {
      bytes += sealed("HEHDT,100.0,T") + "\r\n" + sealed("VWVHW,,,,,8.0,N,,") + "\r\n";
    }
  }
  return bytes;
}

TEST(NmeaFlood, TenThousandMalformedLinesASecondStopNoGoodLineAndTakeNoMemory) {
  test::KeepingSink sink;
  GatewayOptions options = test::gateway_options();
  options.rate_hz = 10.0;
  Gateway gateway(options, 1, sink);
  LineFramer framer;
  std::mt19937 random(20'261'122);
  std::vector<std::string> seconds;
  for (int s = 0; s < kSeconds; ++s) {
    seconds.push_back(second_of_flood(random));
  }
  std::size_t allocations = 0;
  {
    const quickstrip::test::HeapGuard guard;
    for (int s = 0; s < kSeconds; ++s) {
      std::int64_t num_lines = 0;
      const auto take = [&](std::string_view line) {
        const std::int64_t now = kNow + s * kSecond + num_lines * kSecond / (kBadPerSecond + kGoodPerSecond);
        gateway.take(0, line, now);
        gateway.turn(now);
        ++num_lines;
      };
      framer.feed(seconds[static_cast<std::size_t>(s)], take, [&gateway] { gateway.drop_long_line(); });
    }
    allocations = guard.allocations();
  }
  EXPECT_EQ(allocations, 0U);
  const FateCounts& lines = gateway.counts().lines;
  EXPECT_EQ(lines.of(Fate::kTaken), kSeconds * kGoodPerSecond);
  // "Cut short" to nothing and noise of no length are no lines at all.
  EXPECT_GT(lines.refused(), kSeconds * kBadPerSecond * 98 / 100);
  EXPECT_LE(lines.refused(), kSeconds * kBadPerSecond);
  EXPECT_GE(sink.count(Channel::kOwnShip), kSeconds * 9);  // ten a second, the first half-pair cannot
  EXPECT_EQ(sink.own_ship.heading_deg, 100.0);
  EXPECT_EQ(sink.own_ship.speed_through_water_kn, 8.0);
}

TEST(NmeaFlood, AWindowOfMotionTakesNoMemoryEither) {
  test::KeepingSink sink;
  Gateway gateway(test::gateway_options(), 1, sink);
  std::array<std::string, 4> lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double roll[] = {1.5, 0.5, -1.5, -0.5};
    char body[64] = {};
    std::snprintf(body, sizeof(body), "PSXN,23,%.2f,0.10,218.26,0.58", roll[i]);
    lines[i] = sealed(body);
  }
  const quickstrip::test::HeapGuard guard;
  for (int i = 0; i < 100'000; ++i) {  // 25 a second, more than an hour
    gateway.take(0, lines[static_cast<std::size_t>(i / 50) % 4], kNow + i * kSecond / 25);
    gateway.turn(kNow + i * kSecond / 25);
  }
  EXPECT_EQ(guard.allocations(), 0U);
  EXPECT_GE(sink.count(Channel::kMotion), 50);
  EXPECT_NEAR(sink.motion.roll_zero_crossing_s, 8.0, 0.01);
}

}  // namespace
}  // namespace quickstrip::nmea
