// A live advisor's log, as lcm-logger would have heard it, followed and compared: what it took and when is
// known here, for the live process is played by the test.
#include "sim/replay/recorded_run.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tests/session/session_fixture.hpp"

namespace quickstrip {
namespace {

using test::kMinute;
using test::kSecond;
using test::kStart;

constexpr std::int64_t kLatency = 20'000;  // between a cycle's time and what it sends

struct Event {
  std::int64_t utime;
  std::string channel;
  std::vector<std::uint8_t> data;
};

/// Plays sender, advisor and logger.
class Live {
 public:
  Live() : bridge_(test::bridge(options())) {}

  static SessionOptions options() {
    SessionOptions out;
    out.cycle_period_s = 0.7;  // not a whole number of anything
    out.source_id = 7;
    return out;
  }

  /// The logger hears it at `heard`.
  template <typename Message>
  void hear(std::string_view channel, const Message& message, std::int64_t heard) {
    std::vector<std::uint8_t> bytes(kMaxMessageBytes);
    bytes.resize(encode(message, bytes).size());
    events.push_back({heard, "QS_" + std::string(channel), bytes});
  }
  /// Heard, and taken by the next cycle.
  template <typename Message>
  void send(std::string_view channel, const Message& message, std::int64_t heard) {
    hear(channel, message, heard);
    static_cast<void>(bridge_->session.accept(message, heard));
  }
  template <typename Message>
  void take(const Message& message, std::int64_t now) {
    static_cast<void>(bridge_->session.accept(message, now));
  }
  void cycle(std::int64_t now) {
    bridge_->cycle(now);
    for (const OutChannel channel : {OutChannel::kAdvice, OutChannel::kGrid}) {
      const auto c = static_cast<std::size_t>(channel);
      const auto& last = bridge_->outbox.last[c];
      events.push_back({now + kLatency,
                        "QS_" + std::string(kOutChannelNames[c]),
                        {last.begin(), last.begin() + static_cast<std::ptrdiff_t>(bridge_->outbox.size[c])}});
    }
  }
  void restart() { bridge_ = test::bridge(options()); }

  std::vector<Event> events;

 private:
  std::unique_ptr<test::Bridge> bridge_;
};

class RecordedRunTest : public testing::Test {
 protected:
  RecordedRunTest()
      : path_(std::filesystem::path(testing::TempDir()) /
              ("quickstrip_recorded_" + std::to_string(getpid()) + ".log")) {}
  ~RecordedRunTest() override { std::filesystem::remove(path_); }

  RecordedFigures follow(const std::vector<Event>& events) {
    LcmLogWriter writer;
    EXPECT_TRUE(writer.open(path_).ok());
    for (const Event& event : events) {
      EXPECT_TRUE(writer.append(event.utime, event.channel, event.data).ok());
    }
    EXPECT_TRUE(writer.finish().ok());
    RecordedAdvisor advisor;
    EXPECT_TRUE(find_recorded_advisor({path_}, "QS_", advisor).ok());
    EXPECT_TRUE(advisor.has_advice);
    SessionOptions options;
    options.cycle_period_s = advisor.cycle_period_s;
    options.source_id = advisor.source_id;
    const auto bridge = test::bridge(options);
    const Result<Criteria> criteria = nordforsk_merchant(bridge->hull);
    LcmLogReader log;
    EXPECT_TRUE(log.open(path_).ok());
    ReplayFigures figures;
    RecordedFigures recorded;
    const FileStatus status = replay_recorded_run(
        log, bridge->session, {}, [&] { return bridge->session.configure(bridge->hull, *criteria, options); },
        nullptr, [](std::int64_t) {}, figures, recorded);
    EXPECT_TRUE(status.ok());
    return recorded;
  }

  static void expect_all_same(const RecordedFigures& recorded, std::uint64_t num_advice) {
    EXPECT_EQ(recorded.num_advice, num_advice);
    EXPECT_EQ(recorded.num_same_advice, num_advice);
    EXPECT_EQ(recorded.num_same_grids, num_advice);
    EXPECT_EQ(recorded.num_beyond_log, 0u);
    EXPECT_EQ(recorded.first_difference, "");
  }

  std::filesystem::path path_;
};

/// No advice at first, then sea, ship, another loading with its rebuild, another course, a stale ship.
Live voyage() {
  Live live;
  live.cycle(kStart);
  live.send("SEA_STATE", test::swell(kStart, 4.0, 90.0), kStart + 1 * kSecond);
  live.send("OWN_SHIP", test::ship(kStart, 0.0, 15.0), kStart + 1 * kSecond);
  live.cycle(kStart + 2 * kSecond);
  live.send("LOADING", test::loaded(kStart + 2 * kSecond, 9.2), kStart + 3 * kSecond);
  live.cycle(kStart + 4 * kSecond);  // "the loading has changed"
  live.cycle(kStart + 5 * kSecond);
  live.send("OWN_SHIP", test::ship(kStart + 5 * kSecond, 60.0, 12.0, 2), kStart + 6 * kSecond);
  live.send("WAVE_SPECTRUM", test::spectrum(kStart + 5 * kSecond, 0.02, 2), kStart + 6 * kSecond);
  live.cycle(kStart + 7 * kSecond);
  live.cycle(kStart + 30 * kSecond);  // own ship is stale
  return live;
}

TEST_F(RecordedRunTest, EveryRecordedCycleIsRepeatedBitForBit) {
  expect_all_same(follow(voyage().events), 6);
}

TEST_F(RecordedRunTest, AMessageThatCameTooLateForACycleIsLeftForTheNext) {
  Live live;
  live.send("SEA_STATE", test::swell(kStart, 4.0, 90.0), kStart);
  live.send("OWN_SHIP", test::ship(kStart, 0.0, 15.0), kStart);
  // Heard before the advice, while the cycle ran.
  live.hear("OWN_SHIP", test::ship(kStart + kSecond, 90.0, 5.0, 2), kStart + kSecond + kLatency / 2);
  live.cycle(kStart + kSecond);
  live.take(test::ship(kStart + kSecond, 90.0, 5.0, 2), kStart + 2 * kSecond);
  live.cycle(kStart + 2 * kSecond);
  expect_all_same(follow(live.events), 2);
}

TEST_F(RecordedRunTest, OfTwoMessagesWithinACycleTheOneThatTheAdviceNamesIsTaken) {
  Live live;
  live.send("SEA_STATE", test::swell(kStart, 4.0, 90.0), kStart);
  live.send("OWN_SHIP", test::ship(kStart, 0.0, 15.0), kStart);
  live.cycle(kStart + kSecond);
  // The second overtakes the first in the inbox although it was measured before: latest heard wins.
  live.hear("OWN_SHIP", test::ship(kStart + 2 * kSecond, 10.0, 15.0, 3), kStart + 2 * kSecond);
  live.send("OWN_SHIP", test::ship(kStart + 1 * kSecond, 20.0, 15.0, 2), kStart + 2 * kSecond + 1);
  live.cycle(kStart + 3 * kSecond);
  expect_all_same(follow(live.events), 2);
}

TEST_F(RecordedRunTest, ARefusedMessageGivesTheSameReason) {
  Live live;
  live.send("SEA_STATE", test::swell(kStart, 4.0, 90.0), kStart);
  own_ship_t impossible = test::ship(kStart, 0.0, 15.0);
  impossible.heading_deg = 500.0;
  live.send("OWN_SHIP", impossible, kStart);
  live.cycle(kStart + kSecond);
  live.send("OWN_SHIP", test::ship(kStart + kSecond, 0.0, 15.0, 2), kStart + kSecond + kLatency);
  live.cycle(kStart + 2 * kSecond);
  expect_all_same(follow(live.events), 2);
}

TEST_F(RecordedRunTest, ALogBegunInTheMiddleIsRepeatedFromWhereItsInputsAre) {
  Live live = voyage();
  const std::size_t before = live.events.size();
  live.send("LOADING", test::loaded(kStart + 2 * kSecond, 9.2), kStart + 40 * kSecond);  // as before
  live.send("OWN_SHIP", test::ship(kStart + 40 * kSecond, 60.0, 12.0, 3), kStart + 40 * kSecond);
  live.cycle(kStart + 41 * kSecond);  // on a spectrum from before the log
  live.send("WAVE_SPECTRUM", test::spectrum(kStart + 5 * kSecond, 0.02, 2), kStart + 42 * kSecond);
  live.cycle(kStart + 43 * kSecond);
  live.cycle(kStart + 44 * kSecond);
  live.events.erase(live.events.begin(), live.events.begin() + static_cast<std::ptrdiff_t>(before));
  const RecordedFigures recorded = follow(live.events);
  EXPECT_EQ(recorded.num_advice, 3u);
  EXPECT_EQ(recorded.num_beyond_log, 1u);
  EXPECT_EQ(recorded.num_same_advice, 2u);
  EXPECT_EQ(recorded.num_same_grids, 2u);
  EXPECT_EQ(recorded.first_difference, "");
}

TEST_F(RecordedRunTest, ARestartForgetsTheInputs) {
  Live live = voyage();
  live.restart();
  live.cycle(kStart + 50 * kSecond);
  live.send("OWN_SHIP", test::ship(kStart + 50 * kSecond, 60.0, 12.0, 9), kStart + 51 * kSecond);
  live.send("SEA_STATE", test::swell(kStart + 50 * kSecond, 3.0, 45.0, 2), kStart + 51 * kSecond);
  live.cycle(kStart + 52 * kSecond);
  expect_all_same(follow(live.events), 8);
}

TEST_F(RecordedRunTest, AnInputAlteredInTheLogIsFoundAndNamed) {
  Live live = voyage();
  own_ship_t altered = test::ship(kStart, 5.0, 15.0);  // was 0 degrees, under the same numbers
  std::vector<std::uint8_t> bytes(kMaxMessageBytes);
  bytes.resize(encode(altered, bytes).size());
  for (Event& event : live.events) {
    if (event.channel == "QS_OWN_SHIP") {
      event.data = bytes;
      break;
    }
  }
  const RecordedFigures recorded = follow(live.events);
  EXPECT_EQ(recorded.num_advice, 6u);
  EXPECT_LT(recorded.num_same_advice, 6u);
  EXPECT_NE(recorded.first_difference.find("cycle 2, "), std::string::npos) << recorded.first_difference;
  EXPECT_NE(recorded.first_difference.find("heading_deg recorded 0, replayed 5"), std::string::npos)
      << recorded.first_difference;
}

TEST_F(RecordedRunTest, ACyclePeriodIsReadOffTheAdviceForAnyPeriod) {
  Live live;
  live.cycle(kStart);
  RecordedAdvisor advisor;
  follow(live.events);
  ASSERT_TRUE(find_recorded_advisor({path_}, "QS_", advisor).ok());
  EXPECT_NEAR(advisor.cycle_period_s, 0.7, 1e-6);
  EXPECT_EQ(advisor.source_id, 7);
}

}  // namespace
}  // namespace quickstrip
