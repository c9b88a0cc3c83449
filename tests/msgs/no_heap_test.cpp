// Converters run on the cycle's thread: none of them may touch the heap.
#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>

#include "msgs/convert/advice_message.hpp"
#include "msgs/convert/digest.hpp"
#include "msgs/convert/encode.hpp"
#include "msgs/convert/grid_message.hpp"
#include "msgs/convert/limits_message.hpp"
#include "msgs/convert/response_message.hpp"
#include "msgs/convert/sea_message.hpp"
#include "msgs/convert/ship_message.hpp"
#include "msgs/files/hull_file.hpp"
#include "tests/support/heap_guard.hpp"

namespace quickstrip {
namespace {

struct Everything {
  Hull hull;
  Criteria criteria;
  Grid grid;
  Advice advice;
  AdviceContext context;
  CellResponse response;
  SeaState sea;
  DirectionalSpectrum spectrum;
  Loading loading;
  OwnShipReading ship;
  Query query;
  sea_state_t sea_message{};
  wave_spectrum_t spectrum_message{};
  own_ship_t ship_message{};
  loading_t loading_message{};
  query_t query_message{};
  advice_t advice_message{};
  grid_t grid_message{};
  limits_t limits_message{};
  response_t response_message{};
  std::uint8_t bytes[kMaxMessageBytes] = {};
};

void fill(Everything& e) {
  ASSERT_TRUE(read_hull_file(std::string(QUICKSTRIP_SOURCE_DIR) + "/sim/hulls/s175.hull.toml", e.hull).ok());
  ASSERT_TRUE(e.criteria.push_back(
      {Name("slamming at bow"), Quantity::kSlamming, 0, Statistic::kProbability, 0.022, 0.5}));
  e.grid.num_speeds = kMaxSpeeds;
  e.grid.num_headings = kMaxHeadings;
  e.advice.no_advice = NoAdvice::kNone;
  e.advice.change_needed = true;
  e.advice.present.verdict = Verdict::kExceeded;
  e.advice.present.governing = 0;
  e.advice.present.values[0] = 1.0e30F;  // as long as a figure can get
  for (std::size_t i = 0; i < kMaxChanges; ++i) {
    ASSERT_TRUE(e.advice.changes.push_back(
        {.heading = 1.0, .speed = 3.3, .heading_change = 1.0e6, .speed_change = 1.0}));
  }
  while (e.response.quantities.push_back(QuantityResponse{})) {
  }
  e.sea_message.utime = e.spectrum_message.utime = e.ship_message.utime = e.loading_message.utime = 1;
  e.query_message.utime = e.query_message.query_id = 1;
  e.sea_message.num_systems = 1;
  e.sea_message.hs_m[0] = 3.0;
  e.sea_message.period_s[0] = 9.0;
  e.spectrum_message.num_frequencies = 64;
  e.spectrum_message.num_directions = 72;
  for (int f = 0; f < 64; ++f) {
    e.spectrum_message.frequency_hz[f] = 0.03 + 0.01 * f;
    e.spectrum_message.density_m2_hz_deg[f][0] = 1.0F;
  }
  for (int d = 0; d < 72; ++d) {
    e.spectrum_message.dir_from_deg[d] = 5.0 * d;
  }
  e.ship_message.valid = own_ship_t::VALID_HEADING;
  e.ship_message.valid |= own_ship_t::VALID_SPEED_THROUGH_WATER;
  e.loading_message.valid = loading_t::VALID_KG;
  e.loading_message.kg_m = 9.0;
}

bool convert_all(Everything& e) {
  std::uint32_t assumed = 0;
  bool ok = to_sea_state(e.sea_message, e.sea, assumed).ok();
  ok = to_directional_spectrum(e.spectrum_message, e.spectrum).ok() && ok;
  ok = to_own_ship(e.ship_message, e.ship).ok() && ok;
  ok = to_loading(e.loading_message, e.hull, e.loading).ok() && ok;
  ok = to_query(e.query_message, e.query).ok() && ok;
  to_message(e.criteria, e.hull, "ours", e.limits_message);
  to_message(e.grid, e.limits_message.digest, e.grid_message);
  to_message(e.response, e.hull, e.criteria, e.limits_message.digest, e.response_message);
  to_message(e.advice, e.grid, e.criteria, e.context, e.advice_message);
  ok = seal(e.advice_message, e.bytes) && ok;
  ok = !encode(e.grid_message, e.bytes).empty() && ok;
  ok = hull_digest(e.hull, e.loading) != 0 && ok;
  for (int reason = 1; reason <= static_cast<int>(NoAdvice::kSelfTestFailed); ++reason) {
    e.advice.no_advice = static_cast<NoAdvice>(reason);
    to_message(e.advice, e.grid, e.criteria, e.context, e.advice_message);
  }
  e.advice.no_advice = NoAdvice::kNone;
  return ok;
}

TEST(Converters, TouchNoHeap) {
  const auto everything = std::make_unique<Everything>();
  fill(*everything);
  const test::HeapGuard guard;
  const bool ok = convert_all(*everything);
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_TRUE(ok);
}

}  // namespace
}  // namespace quickstrip
