// Any bytes as a stream of lines and as datagrams, with wrong checksums mended so that they reach the fields.
#include <memory>
#include <string>

#include "firmware/nmea/gateway.hpp"
#include "firmware/nmea/line_framer.hpp"
#include "msgs/convert/received_checks.hpp"
#include "msgs/convert/ship_message.hpp"
#include "tests/fuzz/targets.hpp"

namespace quickstrip::fuzz {
namespace {

constexpr std::int64_t kStart = 1'600'000'000'000'000;

/// What the gateway sends the advisor takes.
class CheckingSink : public nmea::Sink {
 public:
  void send(nmea::Channel channel, std::int64_t, std::span<const std::uint8_t> bytes) override {
    own_ship_t own_ship{};
    motion_t motion{};
    quickstrip::clock_t time{};
    OwnShipReading reading;
    switch (channel) {
      case nmea::Channel::kOwnShip:
        require(decode(bytes, own_ship) && to_own_ship(own_ship, reading).ok(), "own ship is taken");
        break;
      case nmea::Channel::kMotion:
        require(decode(bytes, motion) && check_motion(motion).ok(), "motion is taken");
        break;
      case nmea::Channel::kTime:
        require(decode(bytes, time) && check_clock(time).ok(), "time is taken");
        break;
    }
  }
};

/// The line with the checksum that belongs to it.
std::string mended(std::string_view line) {
  const std::size_t dollar = line.find('$');
  if (dollar == std::string_view::npos) {
    return std::string(line);
  }
  const std::string_view body = line.substr(dollar + 1, line.find('*', dollar) - dollar - 1);
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  const unsigned sum = nmea::checksum(body);
  std::string text(line.substr(0, dollar + 1));
  text.append(body);
  text.push_back('*');
  text.push_back(kDigits[(sum >> 4U) & 15U]);
  text.push_back(kDigits[sum & 15U]);
  return text;
}

nmea::GatewayOptions gateway_options(bool record_clock) {
  nmea::GatewayOptions options;
  require(options.reader.talkers.set(nmea::kDefaultTalkers), "the default list is one");
  options.reader.allow_missing_checksum = !record_clock;
  options.record_clock = record_clock;
  options.window_s = 60.0;
  options.rate_hz = 10.0;
  return options;
}

}  // namespace

void run_nmea(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  CheckingSink sink;
  for (const bool record_clock : {false, true}) {
    const auto gateway = std::make_unique<nmea::Gateway>(gateway_options(record_clock), 2, sink);
    nmea::LineFramer framer;
    std::int64_t now = kStart;
    std::int64_t num_given = 0;
    const auto take = [&](std::string_view line) {
      gateway->take(0, line, now);
      const std::string good = mended(line);
      gateway->take(1, good, now);
      num_given += 2;
      now += 100'000;
      if (!record_clock) {
        gateway->turn(now);
      }
    };
    const auto drop = [&] {
      gateway->drop_long_line();
      ++num_given;
    };
    framer.feed(text, take, drop);
    framer.finish(take, drop);
    require(gateway->counts().lines.lines() == num_given, "every line is counted");
    gateway->take_datagram(0, text, now);
    gateway->finish();
  }
}

std::vector<Bytes> nmea_seeds() {
  const std::string_view lines[] = {
      "2014-08-01T00:00:00.285000Z "
      "$INGGA,000000.16,2200.110899,S,01756.359432,W,1,12,0.7,-2.76,M,4.67,M,,*6C\r\n"
      "2014-08-01T00:00:00.402000Z $INVTG,215.11,T,239.79,M,9.1,N,16.9,K,A*05\r\n"
      "2014-08-01T00:00:01.522000Z "
      "$INRMC,000000.16,A,2200.110899,S,01756.359432,W,9.1,215.11,010814,24.7,W,A*3B\r\n"
      "$INHDT,218.26,T*1A\r\n$PSXN,20,1,0,0,0*3A\r\n$PSXN,23,0.35,-1.74,218.26,0.58*13\r\n",
      "\\s:GP0001,n:12*00\\$HETHS,77.52,A*00\r\n$HEROT,-12.5,A*00\r\n$VWVHW,045.0,T,047.1,M,12.3,N,22.8,K*"
      "00\r\n"
      "$VDVBW,12.3,-0.4,A,3.0,4.0,A,,V,,V*00\n$SDDPT,20.0,5.5*00\n$SDDBT,65.6,f,20.0,M,10.9,F*00\n"
      "$PASHR,163029.000,158.09,T,-0.30,+0.31,+0.01,0.029,0.029,0.059,1,1*3B\n"
      "$YXXDR,A,5.2,D,PTCH,A,7.4,D,ROLL,D,1.2,M,HEAVE*00\n"};
  std::vector<Bytes> seeds;
  for (const std::string_view text : lines) {
    seeds.emplace_back(text.begin(), text.end());
  }
  return seeds;
}

}  // namespace quickstrip::fuzz
