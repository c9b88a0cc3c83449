// The gateway on the record of a real ship and on datagrams.
#include "firmware/nmea/gateway.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "msgs/convert/received_checks.hpp"
#include "msgs/convert/ship_message.hpp"
#include "tests/nmea/support.hpp"

namespace quickstrip::nmea {
namespace {

using test::kNow;
using test::kSecond;
using test::sealed;

constexpr const char* kRecord = QUICKSTRIP_SOURCE_DIR "/tests/golden/nbp1406_s330_2014-08-01.nmea";

struct RecordRun {
  test::KeepingSink sink;
  std::unique_ptr<Gateway> gateway;
};

void run_record(RecordRun& run, GatewayOptions options) {
  options.record_clock = true;
  run.gateway = std::make_unique<Gateway>(options, 1, run.sink);
  std::ifstream file(kRecord);
  std::string line;
  while (std::getline(file, line)) {
    if (!line.starts_with('#')) {
      run.gateway->take(0, line, kNow);
    }
  }
  run.gateway->finish();
}

TEST(NmeaGateway, TheRealShipsRecordGivesOwnShipBySpeedOverGroundAloneAndThatIsFlagged) {
  RecordRun run;
  run_record(run, test::gateway_options());
  const GatewayCounts& counts = run.gateway->counts();
  EXPECT_EQ(counts.lines.lines(), 1440);
  EXPECT_EQ(counts.lines.refused(), 0);
  EXPECT_EQ(counts.lines.of(Fate::kTaken), 900);    // GGA, VTG, RMC, HDT and PSXN,23 of each second
  EXPECT_EQ(counts.lines.of(Fate::kNotUsed), 540);  // ZDA, PSXN,20 and PSXN,22
  EXPECT_EQ(run.sink.count(Channel::kOwnShip), counts.own_ships);
  EXPECT_GE(counts.own_ships, 177);  // once a second of 180, stamps shake by some ms
  EXPECT_EQ(counts.own_ships_over_ground, counts.own_ships);
  OwnShipReading reading;
  ASSERT_TRUE(to_own_ship(run.sink.own_ship, reading).ok());
  EXPECT_TRUE(reading.ship.speed_over_ground);
  EXPECT_NEAR(run.sink.own_ship.heading_deg, 217.77,
              0.3);  // the record's last; what is sent may be a second older
  EXPECT_NEAR(run.sink.own_ship.lat_deg, -22.0, 0.1);
  EXPECT_NEAR(run.sink.own_ship.lon_deg, -17.94, 0.1);
  EXPECT_GE(run.sink.count(Channel::kTime), 172);
  EXPECT_TRUE(check_clock(run.sink.time).ok());
  EXPECT_TRUE(run.sink.all_decoded);
}

TEST(NmeaGateway, TheRealShipsMotionIsThatOfAnotherProgramOverTheSameLines) {
  RecordRun run;
  GatewayOptions options = test::gateway_options();
  options.window_s = 190.0;  // all of it
  run_record(run, options);
  ASSERT_GE(run.sink.count(Channel::kMotion), 1);
  const motion_t& m = run.sink.motion;
  EXPECT_TRUE(check_motion(m).ok());
  EXPECT_EQ(m.valid, 31);
  // By a dozen lines of Python over the PSXN,23 of the file, by the same definitions; its times, seconds
  // since 1970 as doubles, are good to 2e-7 s.
  EXPECT_NEAR(m.roll_rms_deg, 0.561722382, 1e-8);
  EXPECT_NEAR(m.roll_zero_crossing_s, 13.286313633, 1e-6);
  EXPECT_NEAR(m.pitch_rms_deg, 1.996513600, 1e-8);
  EXPECT_NEAR(m.pitch_zero_crossing_s, 7.859008324, 1e-6);
  EXPECT_NEAR(m.heave_rms_m, 1.124477298, 1e-8);
  EXPECT_NEAR(m.heave_zero_crossing_s, 10.610725388, 1e-6);
  EXPECT_NEAR(m.mean_heel_deg, 0.043277778, 1e-8);
  EXPECT_NEAR(m.mean_trim_deg, -0.223666667, 1e-8);
  EXPECT_NEAR(m.roll_max_deg, 1.603277778, 1e-8);
  EXPECT_NEAR(m.pitch_max_deg, 6.226333333, 1e-8);
}

TEST(NmeaGateway, DatagramsOf61162With450HeaderAndTagOrPlainOnesOfSeveralLinesAreTaken) {
  test::KeepingSink sink;
  Gateway gateway(test::gateway_options(), 1, sink);
  const std::string tag = std::string("\\").append(sealed("s:GP0001,n:12").substr(1)).append("\\");
  gateway.take_datagram(0, std::string("UdPbC\0", 6) + tag + sealed("HEHDT,100.0,T") + "\r\n", kNow);
  gateway.take_datagram(0, sealed("VWVHW,,,,,8.0,N,,") + "\r\n" + sealed("HEROT,5.0,A"), kNow);
  gateway.take_datagram(0, std::string("RrUdP\0\x01\x02", 8), kNow);  // a binary file's: not ours
  gateway.turn(kNow);
  EXPECT_EQ(gateway.counts().lines.of(Fate::kTaken), 3);
  EXPECT_EQ(gateway.counts().lines.of(Fate::kBadCharacter), 1);
  ASSERT_EQ(sink.count(Channel::kOwnShip), 1);
  EXPECT_EQ(sink.own_ship.heading_deg, 100.0);
  EXPECT_EQ(sink.own_ship.speed_through_water_kn, 8.0);
  EXPECT_EQ(sink.own_ship.rate_of_turn_deg_min, 5.0);
  EXPECT_EQ(sink.own_ship.utime, kNow);
}

TEST(NmeaGateway, OwnShipIsSentOnlyWithNewsAndNotMoreOftenThanAsked) {
  test::KeepingSink sink;
  GatewayOptions options = test::gateway_options();
  options.rate_hz = 2.0;
  Gateway gateway(options, 1, sink);
  for (int i = 0; i < 100; ++i) {  // ten a second for ten seconds
    gateway.take(0, sealed("HEHDT,100.0,T"), kNow + i * kSecond / 10);
    gateway.take(0, sealed("VWVHW,,,,,8.0,N,,"), kNow + i * kSecond / 10);
    gateway.turn(kNow + i * kSecond / 10);
  }
  EXPECT_EQ(sink.count(Channel::kOwnShip), 20);
  for (int i = 0; i < 100; ++i) {
    gateway.turn(kNow + (10 + i) * kSecond);
  }
  EXPECT_LE(sink.count(Channel::kOwnShip), 21);  // silence is not repeated
}

TEST(NmeaGateway, TheSourceGivenFirstWinsAndWithinItTheTalkerGivenFirst) {
  test::KeepingSink sink;
  Gateway gateway(test::gateway_options(), 2, sink);
  gateway.take(1, sealed("HEHDT,50.0,T"), kNow);
  gateway.take(0, sealed("GPHDT,20.0,T"), kNow);
  gateway.take(0, sealed("HEHDT,10.0,T"), kNow);
  gateway.take(0, sealed("GPHDT,20.0,T"), kNow);
  gateway.take(1, sealed("HEHDT,50.0,T"), kNow);
  gateway.take(1, sealed("VDVBW,9.0,0.0,A,,,V"), kNow);
  gateway.turn(kNow);
  EXPECT_EQ(sink.own_ship.heading_deg, 10.0);
  EXPECT_EQ(sink.own_ship.speed_through_water_kn, 9.0);
  EXPECT_EQ(gateway.num_disagreements(), 2);
}

TEST(NmeaGateway, WithTheRecordsClockALineBeforeAnyTimeIsRefused) {
  test::KeepingSink sink;
  GatewayOptions options = test::gateway_options();
  options.record_clock = true;
  Gateway gateway(options, 1, sink);
  gateway.take(0, sealed("HEHDT,50.0,T"), kNow);
  EXPECT_EQ(gateway.counts().lines.of(Fate::kBadTime), 1);
  gateway.take(0, "2014-08-01T00:00:00Z " + sealed("HEHDT,50.0,T"), kNow);
  EXPECT_EQ(gateway.counts().lines.of(Fate::kTaken), 1);
}

}  // namespace
}  // namespace quickstrip::nmea
