// Messages with everything wrong, on the way that they take on board and in a replay: bytes, decoded by
// channel, converted, held. Each is a counted refusal that says why, and the session goes on from what is
// valid.
#include <bit>
#include <cmath>

#include "tests/bad_input/bad_messages.hpp"
#include "tests/bad_input/lcm_fields.hpp"

namespace quickstrip::test {
namespace {

/// The big-endian bytes of a double or a float in place.
void put_number(double value, const LcmField& field, std::size_t element, std::vector<std::uint8_t>& bytes) {
  std::uint64_t bits = field.size == 8 ? std::bit_cast<std::uint64_t>(value)
                                       : std::bit_cast<std::uint32_t>(static_cast<float>(value));
  const std::size_t at = field.offset + element * field.stride;
  for (std::size_t i = field.size; i > 0; --i) {
    bytes[at + i - 1] = static_cast<std::uint8_t>(bits & 0xFFu);
    bits >>= 8;
  }
}

TEST_F(BadMessages, TheGoodOnesAreTaken) {
  for (const GoodMessage& good : good_messages()) {
    EXPECT_NE(feed(good.channel, good.bytes), Fed::kRefused)
        << good.channel << ": " << counters(good.input).last_refusal.field << " "
        << message(counters(good.input).last_refusal.refusal);
    const auto fields = lcm_fields(good.type);
    const LcmField& last = fields.back();
    EXPECT_EQ(last.offset + last.num_elements * last.stride, good.bytes.size()) << "lcm_fields is wrong";
  }
}

TEST_F(BadMessages, NotANumberOrInfinityInAnyFieldIsRefusedMarkedValidOrNot) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::size_t num_tried = 0;
  for (const GoodMessage& good : good_messages()) {
    for (const LcmField& field : lcm_fields(good.type)) {
      for (std::size_t i = 0; field.is_number() && i < field.num_elements; ++i) {
        for (const double value : {std::nan(""), kInfinity, -kInfinity}) {
          std::vector<std::uint8_t> bytes = good.bytes;
          put_number(value, field, i, bytes);
          const std::int64_t before = counters(good.input).refused;
          ASSERT_EQ(feed(good.channel, bytes), Fed::kRefused) << good.type << "." << field.name << " " << i;
          ASSERT_EQ(counters(good.input).refused, before + 1);
          ASSERT_EQ(counters(good.input).last_refusal.refusal, Refusal::kNotFinite) << field.name;
          ++num_tried;
        }
      }
    }
  }
  EXPECT_GT(num_tried, 3u * 4608u);  // the spectrum's density alone
  EXPECT_EQ(bridge_->cycle(kStart + kSecond).no_advice, 0) << bridge_->no_advice_text();
}

TEST_F(BadMessages, WrongLengthTypeOrNothingAtAllDoesNotDecode) {
  const auto all = good_messages();
  for (const GoodMessage& good : all) {
    std::vector<std::uint8_t> shorter = good.bytes;
    shorter.pop_back();
    std::vector<std::uint8_t> longer = good.bytes;
    longer.push_back(0);
    std::vector<std::uint8_t> other = good.bytes;
    other[0] ^= 0x01u;
    for (const auto& bytes : {shorter, longer, other, std::vector<std::uint8_t>{},
                              std::vector<std::uint8_t>(7), std::vector<std::uint8_t>(70'000, 0xEDu)}) {
      expect_refusal(good.type, good.channel, good.input, bytes, Refusal::kMalformed, "");
    }
    for (const GoodMessage& another : all) {
      if (another.type != good.type) {
        expect_refusal(good.type + " from " + another.type, good.channel, good.input, another.bytes,
                       Refusal::kMalformed, "");
      }
    }
  }
  EXPECT_EQ(bridge_->cycle(kStart + kSecond).no_advice, 0) << bridge_->no_advice_text();
}

TEST_F(BadMessages, AnUnknownChannelIsNoneOfOurs) {
  for (const char* channel : {"FOO", "", "SEA_STATE2", "sea_state"}) {
    EXPECT_EQ(feed(channel, swell(kStart, 3.0, 90.0)), Fed::kUnknown) << channel;
  }
  EXPECT_EQ(feed_.feed({0, kStart, "SEA_STATE", encoded(swell(kStart, 3.0, 90.0))}, kStart, bridge_->session),
            Fed::kUnknown);
}

TEST_F(BadMessages, WithNothingValidTheSessionSaysWhatWasRefused) {
  const auto empty = bridge();
  static_cast<void>(empty->session.accept(swell(kStart, 40.0, 90.0), kStart));
  static_cast<void>(empty->session.accept(ship(kStart, 0.0, 15.0), kStart));
  EXPECT_EQ(empty->cycle(kStart).no_advice, code(NoAdvice::kSeaImplausible));
  EXPECT_NE(empty->no_advice_text().find("wave height"), std::string::npos) << empty->no_advice_text();
  const auto health = empty->outbox.decoded<health_t>(OutChannel::kHealth);
  EXPECT_EQ(health.input_refused[0], 1);
  EXPECT_EQ(health.input_last_refusal[0], static_cast<int>(Refusal::kHeight));
}

TEST_F(BadMessages, SequenceNumbersAndSendersInDisorderAreTakenByTheirTimes) {
  for (int i = 1; i <= 5; ++i) {  // seq counts down, senders alternate
    sea_state_t sea = swell(kStart + i * kSecond, 2.0, 10.0, -i);
    sea.source_id = static_cast<std::int16_t>(i % 2 == 0 ? -32768 : 32767);
    EXPECT_TRUE(bridge_->session.accept(sea, kStart + 5 * kSecond).ok());
  }
  const advice_t& advice = bridge_->cycle(kStart + 5 * kSecond);
  EXPECT_EQ(advice.no_advice, 0);
  EXPECT_EQ(advice.input_seq[0], -5);
  EXPECT_EQ(advice.input_source_id[0], 32767);
}

TEST_F(BadMessages, EveryByteOfEveryMessageMayBeWrong) {
  std::int64_t now = kStart;
  for (const GoodMessage& good : good_messages()) {
    const std::size_t step = good.bytes.size() > 2000 ? 37 : 1;  // the spectrum has 20,000 bytes
    for (std::size_t i = 8; i < good.bytes.size(); i += step) {
      for (const int value : {0x00, 0x7F, 0x80, 0xFF}) {
        std::vector<std::uint8_t> bytes = good.bytes;
        bytes[i] = static_cast<std::uint8_t>(value);
        static_cast<void>(feed(good.channel, bytes));
      }
    }
    now += kSecond;
    static_cast<void>(bridge_->cycle(now));  // with whatever was taken
  }
  const auto fresh = kStart + kMinute;
  EXPECT_TRUE(bridge_->session.accept(swell(fresh, 3.0, 90.0), fresh).ok());
  EXPECT_TRUE(bridge_->session.accept(ship(fresh, 0.0, 15.0), fresh).ok());
  EXPECT_TRUE(bridge_->session.accept(loaded(fresh, 9.5), fresh).ok());
  static_cast<void>(bridge_->cycle(fresh));  // a new loading
  EXPECT_EQ(bridge_->cycle(fresh + kSecond).no_advice, 0) << bridge_->no_advice_text();
}

}  // namespace
}  // namespace quickstrip::test
