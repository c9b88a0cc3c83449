// What a network does to packets, and what else may be sent on it.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <limits>
#include <random>

#include "quickstrip/wave_spectrum_t.hpp"
#include "tests/bad_input/good_messages.hpp"
#include "tests/faults/fault_test.hpp"

namespace quickstrip::faults {
namespace {

constexpr std::size_t kSea = health_t::INPUT_SEA_STATE;
constexpr std::size_t kShip = health_t::INPUT_OWN_SHIP;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Bytes = std::vector<std::uint8_t>;

class Packets : public FaultTest {
 protected:
  void SetUp() override {
    start();
    send_sea(kBadSea_m);
    ASSERT_TRUE(until_advice()) << why_not();
  }
  /// Past LCM: any datagram to the group.
  void send_datagram(const Bytes& bytes) {
    static const int kSocket = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(std::stoi(url_.substr(url_.rfind(':') + 1))));
    inet_pton(AF_INET, "239.255.76.67", &to.sin_addr);
    sendto(kSocket, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof(to));
  }
  void expect_unmoved() {
    ASSERT_TRUE(advisor_.is_running()) << advisor_.journal();
    ASSERT_TRUE(until_advice()) << why_not();
    EXPECT_EQ(advice_.verdict, int{advice_t::VERDICT_EXCEEDED});
  }
  std::mt19937 random_{20'261'123};
};

TEST_F(Packets, DuplicatedOnesChangeNothing) {
  has_sensors_ = false;
  const sea_state_t sea = beam_sea(now(), kBadSea_m, 5000);
  const own_ship_t ship = ship_at(now(), 0.0, 5001);
  sent_.seas[mark_of(sea)] = sea;
  sent_.ships[mark_of(ship)] = ship;
  for (int i = 0; i < 200; ++i) {
    send_bytes("QS_SEA_STATE", test::encoded(sea));
    send_bytes("QS_OWN_SHIP", test::encoded(ship));
  }
  ASSERT_TRUE(until([this] { return advice_.input_seq[kShip] == 5001; }));
  expect_unmoved();
}

TEST_F(Packets, ReorderedOnesTheNewestMeasurementStaysInForce) {
  has_sensors_ = false;
  const std::int64_t start = now();
  for (const int step : {3, 1, 2, 0}) {  // the calm seas are older, and come later
    const sea_state_t sea =
        beam_sea(start + step * kSecond_us / 4, step == 3 ? kBadSea_m : kGoodSea_m, 6000 + step);
    const own_ship_t ship = ship_at(start + step * kSecond_us / 4, 0.0, 6100 + step);
    sent_.seas[mark_of(sea)] = sea;
    sent_.ships[mark_of(ship)] = ship;
    send_bytes("QS_SEA_STATE", test::encoded(sea));
    send_bytes("QS_OWN_SHIP", test::encoded(ship));
    listen(0.25);  // a cycle between them: nothing is overtaken unseen
  }
  listen(0.5);
  EXPECT_EQ(advice_.input_seq[kSea], 6003);
  EXPECT_EQ(advice_.input_seq[kShip], 6103);
  EXPECT_EQ(advice_.verdict, int{advice_t::VERDICT_EXCEEDED});
  ASSERT_TRUE(until([this] { return health_.input_dropped[kSea] >= 3; })) << health_.input_dropped[kSea];
}

TEST_F(Packets, LostOnesShowAsAgeAndThenAsNoAdvice) {
  advisor_.kill_hard();
  promises_.own_ship_stale_after_s = 1.5;
  start({"--own-ship-stale-after-s", "1.5"});
  send_sea(kGoodSea_m);
  ASSERT_TRUE(until_good());
  has_sensors_ = false;
  listen(0.7);
  EXPECT_TRUE(is_good(advice_)) << "a gap of half a second is bridged";
  ASSERT_TRUE(until_no_advice());
  EXPECT_NE(why_not().find("the ship's heading and speed are"), std::string::npos) << why_not();
  has_sensors_ = true;
  ASSERT_TRUE(until_good());
}

// A test rig on the ship's network: well-formed, plausible, newer, and nobody's instrument.
TEST_F(Packets, AForeignSenderIsRefusedCountedAndNeverUsed) {
  advisor_.kill_hard();
  start({"--allow-source", "SEA_STATE=" + std::to_string(kSeaSource), "--allow-source",
         "OWN_SHIP=" + std::to_string(kShipSource)});
  send_sea(kBadSea_m);
  ASSERT_TRUE(until([this] { return advice_.verdict == int{advice_t::VERDICT_EXCEEDED}; })) << why_not();
  for (int i = 0; i < 20; ++i) {
    sea_state_t sea = beam_sea(now(), kGoodSea_m, 7000 + i);
    sea.source_id = kSeaSource + 1;
    own_ship_t ship = ship_at(now(), 90.0, 7100 + i);
    ship.source_id = kShipSource + 1;
    send_bytes("QS_SEA_STATE", test::encoded(sea));  // unknown to the checker: advice on it is a fault
    send_bytes("QS_OWN_SHIP", test::encoded(ship));
    listen(0.05);
  }
  ASSERT_TRUE(until([this] {
    return health_.input_refused[kSea] >= 20 && health_.input_refused[kShip] >= 20;
  })) << health_.input_refused[kSea]
      << " " << health_.input_refused[kShip];
  EXPECT_EQ(advice_.input_source_id[kSea], kSeaSource);
  EXPECT_EQ(advice_.input_source_id[kShip], kShipSource);
  expect_unmoved();
}

/// Each with one thing absurd in it, of the right type.
sea_state_t absurd_sea(sea_state_t sea, int which) {
  switch (which % 12) {
    case 0:
      sea.hs_m[0] = kNaN;
      break;
    case 1:
      sea.hs_m[0] = kInfinity;
      break;
    case 2:
      sea.hs_m[0] = -1.0;
      break;
    case 3:
      sea.hs_m[0] = 1e300;
      break;
    case 4:
      sea.period_s[0] = 0.0;
      break;
    case 5:
      sea.period_s[0] = 5e-324;
      break;
    case 6:
      sea.dir_from_deg[0] = 1e9;
      break;
    case 7:
      sea.num_systems = 127;
      break;
    case 8:
      sea.num_systems = -128;
      break;
    case 9:
      sea.utime = std::numeric_limits<std::int64_t>::max();
      break;
    case 10:
      sea.utime = std::numeric_limits<std::int64_t>::min();
      break;
    default:
      sea.period_kind[0] = 99;
      break;
  }
  return sea;
}

own_ship_t absurd_ship(own_ship_t ship, int which) {
  switch (which % 7) {
    case 0:
      ship.heading_deg = kNaN;
      break;
    case 1:
      ship.heading_deg = -1e-9;
      break;
    case 2:
      ship.speed_through_water_kn = 1e6;
      break;
    case 3:
      ship.speed_through_water_kn = -kInfinity;
      break;
    case 4:
      ship.valid = 0;
      break;
    case 5:
      ship.utime = 0;
      break;
    default:
      ship.lat_deg = kNaN;
      break;
  }
  return ship;
}

TEST_F(Packets, ABurstOfTenThousandMalformedOnesIsCountedAndMovesNothing) {
  std::uniform_int_distribution<int> byte(0, 255);
  std::uniform_int_distribution<int> length(0, 400);
  const std::vector<test::GoodMessage> good = test::good_messages();
  for (int i = 0; i < 10'000; ++i) {
    const test::GoodMessage& one = good[static_cast<std::size_t>(i / 4) % good.size()];
    Bytes bytes = one.bytes;
    switch (i % 4) {
      case 0:  // random bytes, of any length
        bytes.resize(static_cast<std::size_t>(length(random_)));
        for (std::uint8_t& b : bytes) {
          b = static_cast<std::uint8_t>(byte(random_));
        }
        send_bytes("QS_" + one.channel, bytes);
        break;
      case 1:  // a wrong fingerprint
        bytes[static_cast<std::size_t>(byte(random_)) % 8] ^= 0x10U;
        send_bytes("QS_" + one.channel, bytes);
        break;
      case 2:
        send_bytes("QS_SEA_STATE", test::encoded(absurd_sea(beam_sea(now(), kGoodSea_m, 9000 + i), i / 4)));
        break;
      default:
        send_bytes("QS_OWN_SHIP", test::encoded(absurd_ship(ship_at(now(), 0.0, 9000 + i), i / 4)));
        break;
    }
    if (i % 50 == 0) {
      listen(0.005);
    }
  }
  expect_unmoved();
  ASSERT_TRUE(
      until([this] { return health_.input_refused[kSea] > 100 && health_.input_refused[kShip] > 100; }));
  EXPECT_NE(advisor_.journal().find("a message was refused"), std::string::npos) << advisor_.journal();
}

TEST_F(Packets, DatagramsThatAreNoLcmAtAllMoveNothing) {
  std::uniform_int_distribution<int> byte(0, 255);
  const auto be32 = [](Bytes& out, std::uint32_t value) {
    for (const unsigned int shift : {24U, 16U, 8U, 0U}) {
      out.push_back(static_cast<std::uint8_t>(value >> shift));
    }
  };
  for (int i = 0; i < 2000; ++i) {
    Bytes bytes;
    if (i % 4 == 0) {  // nonsense
      bytes.resize(static_cast<std::size_t>(byte(random_)));
    } else if (i % 4 == 1) {  // a small message whose channel does not end
      bytes = {'L', 'C', '0', '2', 0, 0, 0, 1};
      bytes.resize(8 + static_cast<std::size_t>(byte(random_)), 'Q');
    } else {  // a fragment of a message that says it is enormous, or that lies about itself
      bytes = {'L', 'C', '0', '3'};
      be32(bytes, static_cast<std::uint32_t>(i));
      be32(bytes, i % 4 == 2 ? (1U << 28U) : static_cast<std::uint32_t>(random_()));
      be32(bytes, i % 4 == 2 ? 0U : static_cast<std::uint32_t>(random_()));
      be32(bytes, i % 4 == 2 ? 1000U : static_cast<std::uint32_t>(random_()));  // number 0 of 1000
      for (const char c : std::string("QS_SEA_STATE")) {
        bytes.push_back(static_cast<std::uint8_t>(c));
      }
      bytes.push_back(0);
    }
    const std::size_t kept = i % 4 == 0 ? 0 : bytes.size();
    bytes.resize(bytes.size() + static_cast<std::size_t>(byte(random_)));
    for (std::size_t b = kept; b < bytes.size(); ++b) {
      bytes[b] = static_cast<std::uint8_t>(byte(random_));
    }
    send_datagram(bytes);
    if (i % 50 == 0) {
      listen(0.005);
    }
  }
  expect_unmoved();
}

}  // namespace
}  // namespace quickstrip::faults
