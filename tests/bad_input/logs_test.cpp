// Logs cut off anywhere, with bits turned over, strange channels, impossible lengths and impossible times:
// what can be read is read, the rest is passed over and counted, and a replay of it ends and gives advice.
#include <algorithm>
#include <array>
#include <memory>
#include <random>

#include "msgs/files/lcm_log.hpp"
#include "sim/replay/advice_log.hpp"
#include "sim/replay/event_stream.hpp"
#include "sim/replay/inspect.hpp"
#include "sim/replay/replay.hpp"
#include "tests/bad_input/edited_text.hpp"
#include "tests/bad_input/good_messages.hpp"

namespace quickstrip::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Event {
  std::int64_t utime;
  std::string channel;
  Bytes data;
};

Bytes log_of(const std::vector<Event>& events) {
  Bytes log;
  const auto put = [&log](std::uint64_t value, int num_bytes) {
    for (int i = num_bytes - 1; i >= 0; --i) {
      log.push_back(static_cast<std::uint8_t>((value >> (8 * i)) & 0xFFu));
    }
  };
  for (std::size_t i = 0; i < events.size(); ++i) {
    put(0xEDA1DA01u, 4);
    put(i, 8);
    put(static_cast<std::uint64_t>(events[i].utime), 8);
    put(events[i].channel.size(), 4);
    put(events[i].data.size(), 4);
    log.insert(log.end(), events[i].channel.begin(), events[i].channel.end());
    log.insert(log.end(), events[i].data.begin(), events[i].data.end());
  }
  return log;
}

/// A sea and then own ship every ten minutes, six times.
std::vector<Event> an_hour() {
  std::vector<Event> events{{kStart, "QS_SEA_STATE", encoded(swell(kStart, 3.0, 90.0))}};
  for (int i = 0; i < 6; ++i) {
    const std::int64_t now = kStart + i * 10 * kMinute;
    events.push_back({now, "QS_OWN_SHIP", encoded(ship(now, 10.0 * i, 12.0, i))});
  }
  return events;
}

class BadLog : public testing::Test {
 protected:
  std::string put(const Bytes& bytes) {
    return folder_.file("a.log", std::string(bytes.begin(), bytes.end()));
  }
  /// Reads all; every byte is an event's or counted as passed over.
  std::uint64_t events_of(const Bytes& bytes) {
    LcmLogReader log;
    if (!log.open(put(bytes))) {
      return 0;
    }
    LogEvent event;
    std::uint64_t read = 0;
    while (log.next(event)) {
      read += 28 + event.channel.size() + event.data.size();
    }
    EXPECT_EQ(read + log.bytes_passed_over(), bytes.size());
    EXPECT_EQ(log.num_faults() > 0, log.bytes_passed_over() > 0);
    return log.num_events();
  }
  ReplayFigures replay(const std::vector<Event>& events) {
    LcmLogReader log;
    EXPECT_TRUE(log.open(put(log_of(events))).ok());
    ReplayFigures figures;
    last_cycle_ = 0;
    EXPECT_TRUE(
        replay_log(
            log, bridge_->session, {}, nullptr, [this](std::int64_t now) { last_cycle_ = now; }, figures)
            .ok());
    return figures;
  }

  Folder folder_{"logs"};
  std::unique_ptr<Bridge> bridge_ = bridge();
  std::int64_t last_cycle_ = 0;
};

TEST_F(BadLog, CutOffAtAnyByteGivesTheEventsBeforeTheCut) {
  const std::vector<Event> events = an_hour();
  const Bytes whole = log_of(events);
  std::vector<std::size_t> ends{0};
  for (const Event& event : events) {
    ends.push_back(ends.back() + 28 + event.channel.size() + event.data.size());
  }
  for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
    const auto complete = std::upper_bound(ends.begin(), ends.end(), cut) - ends.begin() - 1;
    const Bytes rest(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(cut));
    ASSERT_EQ(events_of(rest), static_cast<std::uint64_t>(complete)) << cut;
  }
}

TEST_F(BadLog, OneBitTurnedOverLosesOneEventAtMost) {
  const std::vector<Event> events = an_hour();
  const Bytes whole = log_of(events);
  std::mt19937 random(20'190'904);
  for (int i = 0; i < 3000; ++i) {
    Bytes bytes = whole;
    const std::size_t bit =
        32 + random() % (8 * whole.size() - 32);  // not the first sync word: no log at all
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
    ASSERT_GE(events_of(bytes) + 1, events.size()) << "bit " << bit;
  }
}

TEST_F(BadLog, BytesThrownInAreSkippedToTheNextSyncWord) {
  const Bytes whole = log_of(an_hour());
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    Bytes bytes = whole;
    const auto at = static_cast<std::ptrdiff_t>(4 + random() % (whole.size() - 4));  // else no log
    Bytes junk(1 + random() % 200);
    std::generate(junk.begin(), junk.end(), [&] { return static_cast<std::uint8_t>(random() & 0xFFu); });
    bytes.insert(bytes.begin() + at, junk.begin(), junk.end());
    ASSERT_GE(events_of(bytes) + 2, 7U) << "at " << at;
  }
}

TEST_F(BadLog, ImpossibleLengthsAreSaidWithTheirOffset) {
  const Bytes whole = log_of(an_hour());
  for (const auto& [offset, bytes, words] :
       std::vector<std::tuple<std::size_t, Bytes, std::vector<std::string>>>{
           {20, {0x7F, 0xFF, 0xFF, 0xFF}, {"offset 0", "channel of 2147483647 bytes", "1 to 63"}},
           {20, {0xFF, 0xFF, 0xFF, 0xFF}, {"channel of 4294967295 bytes"}},
           {20, {0, 0, 0, 0}, {"channel of 0 bytes"}},
           {24, {0x7F, 0xFF, 0xFF, 0xFF}, {"data of 2147483647 bytes", "at most 16777216"}},
           {24, {0xFF, 0xFF, 0xFF, 0xFE}, {"data of 4294967294 bytes"}},
           {24, {0x00, 0xFF, 0xFF, 0xFF}, {"truncated", "the file only"}}}) {
    Bytes wrong = whole;
    std::copy(bytes.begin(), bytes.end(), wrong.begin() + static_cast<std::ptrdiff_t>(offset));
    LcmLogReader log;
    ASSERT_TRUE(log.open(put(wrong)).ok());
    LogEvent event;
    std::uint64_t count = 0;
    while (log.next(event)) {
      ++count;
    }
    EXPECT_EQ(count, 6U);
    ASSERT_EQ(log.num_faults(), 1U);
    expect_line("length", log.faults()[0].line, words);
  }
}

TEST_F(BadLog, WhatIsNoLogIsRefusedInALine) {
  LcmLogReader log;
  expect_line("text", log.open(folder_.file("text", "schema = 1\n")).line(), {"text", "EDA1DA01"});
  LcmLogReader other;
  expect_line("folder", other.open(folder_.path()).line(), {"cannot be read"});
  LcmLogReader none;
  expect_line("none", none.open(folder_.file("none")).line(), {"no such file"});
}

TEST_F(BadLog, UnknownChannelsArePassedOverCountedAndNamed) {
  std::vector<Event> events = an_hour();
  for (int i = 0; i < 3; ++i) {
    events.insert(events.begin() + 2 * i, {kStart, "RADAR\x1B[2J", {1, 2, 3}});
  }
  events.push_back({kStart + kHour, "GPS", {}});
  const ReplayFigures figures = replay(events);
  EXPECT_EQ(figures.num_unknown, 4U);
  EXPECT_EQ(figures.num_refused, 0U);
  EXPECT_NE(remarks(figures).find("4 events on 2 channels not ours: GPS (1) RADAR?[2J (3)"),
            std::string::npos)
      << remarks(figures);
  EXPECT_EQ(remarks(replay(an_hour())), "");
}

// One wrong bit in a time of reception: all later events came "at once", or a cycle was run for every hour of
// thirty years.
TEST_F(BadLog, AWrongTimeOfReceptionCostsOneEventAndNotTheRestOfTheLog) {
  const auto fresh = std::make_unique<Session>(bridge_->session);  // to configure anew takes 85 ms
  for (const std::size_t which : {0U, 1U, 3U, 6U}) {
    for (int bit = 20; bit < 64; ++bit) {  // from a second on
      std::vector<Event> events = an_hour();
      events[which].utime ^= static_cast<std::int64_t>(std::uint64_t{1} << bit);
      bridge_->session = *fresh;
      const ReplayFigures figures = replay(events);
      ASSERT_LT(figures.num_cycles, 60U) << which << " " << bit;
      ASSERT_GE(figures.num_events + 1, events.size());
      if (which < 6) {
        ASSERT_LT(last_cycle_, kStart + 2 * kHour) << which << " " << bit;
      }
    }
  }
}

TEST_F(BadLog, TwoLogsInOneWithAGapOfYearsOrInTheWrongOrderEnd) {
  std::vector<Event> later = an_hour();
  for (Event& event : later) {
    event.utime += 20 * 365 * 24 * kHour;
  }
  std::vector<Event> events = an_hour();
  events.insert(events.end(), later.begin(), later.end());
  const ReplayFigures gap = replay(events);
  EXPECT_EQ(gap.num_gaps, 1U);
  EXPECT_LT(gap.num_cycles, 100U);
  EXPECT_NE(remarks(gap).find("1 gaps of more than two days"), std::string::npos) << remarks(gap);
  std::rotate(events.begin(), events.begin() + 7, events.end());  // the later first
  const ReplayFigures order = replay(events);
  EXPECT_EQ(order.num_out_of_order, 7U);
  EXPECT_NE(remarks(order).find("7 events lie before"), std::string::npos) << remarks(order);
}

TEST_F(BadLog, InspectionOfImpossibleTimesNamesThem) {
  std::vector<Event> events = an_hour();
  events[1].utime = std::numeric_limits<std::int64_t>::min();
  events[2].utime = std::numeric_limits<std::int64_t>::max();
  events[3].utime = 0;
  LogFigures figures;
  ASSERT_TRUE(inspect_log(put(log_of(events)), "QS_", figures).ok());
  EXPECT_EQ(figures.num_out_of_time, 3U);
  EXPECT_NE(inspection_text(figures).find("3 with a time not between 1970 and 2200"), std::string::npos);
  EXPECT_EQ(figures.channels["QS_OWN_SHIP"].first_utime, kStart + 30 * kMinute);
}

// A count of speeds beyond its array crashed the story and the picture.
TEST_F(BadLog, AdviceAndGridWithImpossibleCountsAreNotReadBack) {
  static_cast<void>(bridge_->session.accept(swell(kStart, 3.0, 90.0), kStart));
  static_cast<void>(bridge_->session.accept(ship(kStart, 0.0, 15.0), kStart));
  ASSERT_EQ(bridge_->cycle(kStart).no_advice, 0);
  const auto grid = std::make_unique<grid_t>(bridge_->session.grid());
  grid->num_speeds = 30'000;
  advice_t advice = bridge_->session.advice();
  advice.num_changes = -5;
  const Bytes log = log_of({{kStart, "QS_ADVICE", encoded(bridge_->session.advice())},
                            {kStart, "QS_GRID", encoded(*grid)},
                            {kStart, "QS_ADVICE", encoded(advice)}});
  int num = 0;
  const FileStatus status = read_advice_log(put(log), "QS_", [&](const RecordedAdvice& recorded) {
    ++num;
    EXPECT_EQ(recorded.grid.num_speeds, 0);
    EXPECT_LE(badness(recorded), 3.0);
  });
  EXPECT_TRUE(status.ok()) << status.line();
  EXPECT_EQ(num, 1);
}

}  // namespace
}  // namespace quickstrip::test
