// Bytes fed to a session as a log or the bus would, and lists of {what is wrong, refusal, field}.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "msgs/convert/refusal.hpp"
#include "sim/replay/log_feed.hpp"
#include "tests/bad_input/good_messages.hpp"

namespace quickstrip::test {

class BadMessages : public testing::Test {
 protected:
  /// Bytes on a channel, at kStart.
  Fed feed(const std::string& channel, const std::vector<std::uint8_t>& bytes) {
    return feed_.feed({0, kStart, "QS_" + channel, bytes}, kStart, bridge_->session);
  }
  template <typename Message>
  Fed feed(const std::string& channel, const Message& message) {
    return feed(channel, encoded(message));
  }
  [[nodiscard]] const InputCounters& counters(Input input) const {
    return bridge_->session.inputs().counters(input);
  }
  /// Refused, counted once, with this reason.
  void expect_refusal(const std::string& what, const std::string& channel, Input input,
                      const std::vector<std::uint8_t>& bytes, Refusal refusal, const std::string& field) {
    const std::int64_t before = counters(input).refused;
    EXPECT_EQ(feed(channel, bytes), Fed::kRefused) << what;
    EXPECT_EQ(counters(input).refused, before + 1) << what;
    EXPECT_EQ(counters(input).last_refusal.refusal, refusal)
        << what << ": " << message(counters(input).last_refusal.refusal);
    EXPECT_EQ(counters(input).last_refusal.field, field) << what;
  }

  std::unique_ptr<Bridge> bridge_ = bridge_at_sea();
  LogFeed feed_{"QS_"};
};

template <typename Message>
struct Wrong {
  const char* what;
  std::function<void(Message&)> edit;
  Refusal refusal;
  const char* field;
};

template <typename Message>
void expect_each(const std::vector<Wrong<Message>>& list, const Message& good,
                 const std::function<void(const std::string&, const std::vector<std::uint8_t>&, Refusal,
                                          const std::string&)>& expect) {
  for (const Wrong<Message>& wrong : list) {
    Message message = good;
    wrong.edit(message);
    expect(wrong.what, encoded(message), wrong.refusal, wrong.field);
  }
}

inline constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

/// What every measured message may have wrong in its time.
template <typename Message>
std::vector<Wrong<Message>> wrong_times() {
  return {{"no time", [](Message& m) { m.utime = 0; }, Refusal::kTime, "utime"},
          {"before 1970", [](Message& m) { m.utime = -1; }, Refusal::kTime, "utime"},
          {"the earliest", [](Message& m) { m.utime = -kNever - 1; }, Refusal::kTime, "utime"},
          {"the latest", [](Message& m) { m.utime = kNever; }, Refusal::kTime, "utime"},
          {"seconds for microseconds, later", [](Message& m) { m.utime *= 1000; }, Refusal::kTime, "utime"}};
}

template <typename Message>
std::vector<Wrong<Message>> from_the_future() {
  return {{"6 s ahead", [](Message& m) { m.utime += 6 * kSecond; }, Refusal::kFromTheFuture, "utime"},
          {"a year ahead", [](Message& m) { m.utime += 8760 * kHour; }, Refusal::kFromTheFuture, "utime"}};
}

}  // namespace quickstrip::test
