// Inputs as this test's sensors publish them, and a record of each: advice may rest on these and no others.
#pragma once

#include <array>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <string>
#include <tuple>

#include "msgs/convert/encode.hpp"
#include "quickstrip/advice_t.hpp"
#include "quickstrip/loading_t.hpp"
#include "quickstrip/own_ship_t.hpp"
#include "quickstrip/sea_state_t.hpp"

namespace quickstrip::faults {

inline constexpr std::int64_t kSecond_us = 1'000'000;
inline constexpr std::int16_t kSeaSource = 20;
inline constexpr std::int16_t kShipSource = 30;
inline constexpr std::int16_t kLoadingSource = 40;

/// Which message of a kind: who sent it, its number, its time.
using Mark = std::tuple<std::int16_t, std::int32_t, std::int64_t>;

template <typename Message>
Mark mark_of(const Message& message) {
  return {message.source_id, message.seq, message.utime};
}

/// What was sent in earnest. Nonsense is published past it, and so is never acceptable.
struct Sent {
  std::map<Mark, sea_state_t> seas;
  std::map<Mark, own_ship_t> ships;
  std::map<Mark, loading_t> loadings;
};

/// A beam sea for a ship on course 0: of 0.5 m good, of 9 m far beyond the limits (oracle in the tests).
inline sea_state_t beam_sea(std::int64_t utime, double hs_m, std::int32_t seq) {
  sea_state_t sea{};
  sea.utime = utime;
  sea.seq = seq;
  sea.source_id = kSeaSource;
  sea.num_systems = 1;
  sea.hs_m[0] = hs_m;
  sea.period_s[0] = 11.0;
  sea.dir_from_deg[0] = 90.0;
  return sea;
}

inline own_ship_t ship_at(std::int64_t utime, double heading_deg, std::int32_t seq) {
  own_ship_t ship{};
  ship.utime = utime;
  ship.seq = seq;
  ship.source_id = kShipSource;
  ship.valid = 1 + 2;  // heading and speed through the water
  ship.heading_deg = heading_deg;
  ship.speed_through_water_kn = 12.0;
  return ship;
}

inline loading_t loading_of_kg(std::int64_t utime, double kg_m, std::int32_t seq) {
  loading_t loading{};
  loading.utime = utime;
  loading.seq = seq;
  loading.source_id = kLoadingSource;
  loading.valid = 2 + 4;  // KG and free-surface correction
  loading.kg_m = kg_m;
  return loading;
}

}  // namespace quickstrip::faults
