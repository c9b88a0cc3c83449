// Feeds the advisor: a sea of a wind sea and a swell, and own ship, once a second.
//   sea_publisher [URL [SECONDS]]
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <lcm/lcm-cpp.hpp>
#include <thread>

#include "quickstrip/own_ship_t.hpp"
#include "quickstrip/sea_state_t.hpp"

namespace {

using quickstrip::own_ship_t;
using quickstrip::sea_state_t;

constexpr std::int16_t kSourceId = 7;  // ours; the advisor's allow-source may name it

std::int64_t utime() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

sea_state_t sea() {
  sea_state_t message{};  // what is not given is zero, and not marked valid
  message.utime = utime();
  message.source_id = kSourceId;
  message.source_kind = sea_state_t::SOURCE_RADAR;
  message.num_systems = 2;
  message.hs_m[0] = 2.5;  // wind sea
  message.period_s[0] = 7.5;
  message.period_kind[0] = sea_state_t::PERIOD_TP;
  message.dir_from_deg[0] = 250.0;  // where it comes FROM
  message.system_kind[0] = sea_state_t::SYSTEM_WIND_SEA;
  message.hs_m[1] = 3.0;  // swell
  message.period_s[1] = 12.0;
  message.period_kind[1] = sea_state_t::PERIOD_TP;
  message.dir_from_deg[1] = 310.0;
  message.system_kind[1] = sea_state_t::SYSTEM_SWELL;
  return message;
}

own_ship_t own_ship() {
  own_ship_t message{};
  message.utime = utime();
  message.source_id = kSourceId;
  message.valid = own_ship_t::VALID_HEADING;
  message.valid |= own_ship_t::VALID_SPEED_THROUGH_WATER;
  message.heading_deg = 40.0;
  message.speed_through_water_kn = 16.0;
  return message;
}

}  // namespace

int main(int argc, char** argv) {
  lcm::LCM bus(argc > 1 ? argv[1] : "udpm://239.255.76.67:7667?ttl=0");
  if (!bus.good()) {
    std::fprintf(stderr, "LCM does not open: is there a multicast route?\n");
    return 1;
  }
  sea_state_t measured = sea();  // a sea is measured now and then, and may be repeated with its own time
  for (int i = 0, seconds = argc > 2 ? static_cast<int>(std::strtol(argv[2], nullptr, 10)) : 60; i < seconds;
       ++i) {
    own_ship_t ship = own_ship();
    ship.seq = i;
    bus.publish("QS_SEA_STATE", &measured);
    bus.publish("QS_OWN_SHIP", &ship);
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
  return 0;
}
