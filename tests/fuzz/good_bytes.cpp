#include "tests/fuzz/good_bytes.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <string>

#include "tests/bad_input/good_messages.hpp"
#include "tests/fuzz/tiny_ship.hpp"

namespace quickstrip::fuzz {
namespace {

constexpr std::size_t kFingerprintBytes = 8;

std::map<std::string, Bytes, std::less<>> all_good_bytes() {
  std::map<std::string, Bytes, std::less<>> all;
  for (const test::GoodMessage& good : test::good_messages()) {
    all[good.channel] = good.bytes;
  }
  quickstrip::clock_t time{};
  time.utime = test::kStart;
  all["TIME"] = test::encoded(time);
  return all;
}

}  // namespace

const Bytes& good_bytes(std::string_view channel) {
  static const auto kAll = all_good_bytes();
  const auto found = kAll.find(channel);
  require(found != kAll.end(), channel);
  return found->second;
}

OwnMessages own_messages() {
  const auto session = std::make_unique<Session>();
  configure(*session);
  CheckingOutbox outbox;
  static_cast<void>(session->accept(test::swell(test::kStart, 6.0, 100.0), test::kStart));
  static_cast<void>(session->accept(test::ship(test::kStart, 10.0, 10.0), test::kStart));
  session->cycle(test::kStart, outbox);
  require(session->advice().no_advice == 0, "a sea of 6 m gives advice");
  return {test::encoded(session->advice()), test::encoded(session->grid()), test::encoded(session->limits())};
}

Bytes laid_over(const Bytes& good, std::span<const std::uint8_t> over) {
  Bytes bytes = good;
  const std::size_t room = bytes.size() - kFingerprintBytes;
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(kFingerprintBytes);
  std::copy_n(over.begin(), std::min(room, over.size()), begin);
  return bytes;
}

}  // namespace quickstrip::fuzz
