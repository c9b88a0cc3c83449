// The types as other programs know them. A fingerprint that changes is a type that changed: give it a new
// name.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include "msgs/convert/encode.hpp"
#include "quickstrip/advice_t.hpp"
#include "quickstrip/alert_t.hpp"
#include "quickstrip/clock_t.hpp"
#include "quickstrip/comparison_t.hpp"
#include "quickstrip/grid_t.hpp"
#include "quickstrip/health_t.hpp"
#include "quickstrip/limits_t.hpp"
#include "quickstrip/loading_t.hpp"
#include "quickstrip/logbook_t.hpp"
#include "quickstrip/motion_t.hpp"
#include "quickstrip/outlook_t.hpp"
#include "quickstrip/own_ship_t.hpp"
#include "quickstrip/query_t.hpp"
#include "quickstrip/response_t.hpp"
#include "quickstrip/sea_forecast_t.hpp"
#include "quickstrip/sea_state_t.hpp"
#include "quickstrip/wave_spectrum_t.hpp"

namespace quickstrip {
namespace {

template <typename Message>
void expect_pinned(std::uint64_t fingerprint, int bytes) {
  const auto message = std::make_unique<Message>();
  EXPECT_EQ(static_cast<std::uint64_t>(Message::getHash()), fingerprint)
      << Message::getTypeName() << ": 0x" << std::hex << Message::getHash();
  EXPECT_EQ(message->getEncodedSize(), bytes) << Message::getTypeName();
  EXPECT_LT(message->getEncodedSize(), 64'000) << Message::getTypeName();
  // No vector, no string: lcm-gen trusts a count on the wire.
  static_assert(std::is_trivially_copyable_v<Message>);
}

TEST(MessageTypes, FingerprintsAndSizesArePinned) {
  expect_pinned<advice_t>(0xD20D5E22315527B5u, 3291);
  expect_pinned<alert_t>(0x6AF28614BD9928F0u, 254);
  expect_pinned<clock_t>(0x51069DA63B540650u, 30);
  expect_pinned<comparison_t>(0x007679A6F9195771u, 2612);
  expect_pinned<grid_t>(0xBA4BA06C4998E6E1u, 43334);
  expect_pinned<health_t>(0x236C94D0C07EA629u, 588);
  expect_pinned<limits_t>(0x5061606A0BC61810u, 2816);
  expect_pinned<loading_t>(0xFEBA3CDD56C484ECu, 155);
  expect_pinned<logbook_t>(0x1E27A7318FB0E5E0u, 231);
  expect_pinned<motion_t>(0xF29283C47B1C9EB3u, 339);
  expect_pinned<outlook_t>(0xA2D3CE2741FAA06Au, 4002);
  expect_pinned<own_ship_t>(0x30E8C25E651F0982u, 107);
  expect_pinned<query_t>(0x373CD6BD2423FC04u, 46);
  expect_pinned<response_t>(0xCA2CCE2EB4142B08u, 11411);
  expect_pinned<sea_forecast_t>(0x99B7F8C1A2C1FEC2u, 21464);
  expect_pinned<sea_state_t>(0xD1CF41ACBBA0E4B5u, 454);
  expect_pinned<wave_spectrum_t>(0xEB902033A0A58509u, 19583);
}

TEST(MessageTypes, ACellOfTheGridTakesAtMostTwentyFourBytes) {
  const auto grid = std::make_unique<grid_t>();
  const std::size_t header =
      8 + 8 + 4 + 2 + 8 + 2 + 2 + 25 * 4;  // fingerprint, then the fields before verdict
  EXPECT_LE(static_cast<std::size_t>(grid->getEncodedSize()) - header, std::size_t{24 * 25 * 72});
}

TEST(Encode, ABufferThatIsTooSmallGivesNothing) {
  const query_t query{};
  std::uint8_t bytes[64] = {};
  EXPECT_EQ(encode(query, bytes).size(), static_cast<std::size_t>(query.getEncodedSize()));
  EXPECT_TRUE(encode(query, std::span<std::uint8_t>(bytes, 20)).empty());
}

TEST(Encode, ATruncatedLongerOrForeignMessageIsRefused) {
  query_t query{};
  query.query_id = 7;
  std::uint8_t bytes[64] = {};
  const auto encoded = encode(query, bytes);
  query_t back{};
  EXPECT_TRUE(decode(encoded, back));
  EXPECT_EQ(back.query_id, 7);
  EXPECT_FALSE(decode(encoded.first(encoded.size() - 1), back));
  EXPECT_FALSE(decode(std::span<const std::uint8_t>(bytes, encoded.size() + 1), back));
  EXPECT_FALSE(decode(encoded.first(0), back));
  clock_t clock{};
  EXPECT_FALSE(decode(encoded, clock));
}

}  // namespace
}  // namespace quickstrip
