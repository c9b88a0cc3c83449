// A short voyage through a made-up sea, written as a log and replayed.
#include "sim/replay/replay.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "core/advice/nordforsk.hpp"
#include "msgs/convert/encode.hpp"
#include "msgs/convert/units.hpp"
#include "sim/replay/advice_log.hpp"
#include "sim/replay/advice_table.hpp"
#include "sim/replay/inspect.hpp"
#include "sim/replay/voyage_log.hpp"
#include "tests/support/hulls.hpp"

namespace quickstrip {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kHour = 3600 * kSecond;
constexpr std::int64_t kStart = 1'567'600'800 * kSecond;

/// Hours 0, 1, 2 and then, after a gap, 6: a single direction of 45 degrees, growing.
SeaSeries growing_sea() {
  SeaSeries sea;
  sea.source = "made up";
  for (const int hour : {0, 1, 2, 6}) {
    SeaRecord record;
    record.utime_us = kStart + hour * kHour;
    for (int f = 0; f < 12; ++f) {
      QS_CHECK(record.spectrum.frequencies.push_back(0.35 + 0.06 * f));
    }
    for (int d = 0; d < 72; ++d) {
      QS_CHECK(record.spectrum.directions.push_back(radians(5.0 * d)));
    }
    for (std::size_t f = 3; f < 9; ++f) {
      record.spectrum.density[f][9] = 2.0 * (hour + 1);
    }
    sea.records.push_back(record);
  }
  return sea;
}

Voyage northward() {
  Voyage voyage;
  voyage.legs = {{kStart, Heading{0.0}, from_knots(15.0)},
                 {kStart + 90 * 60 * kSecond, Heading{1.0}, from_knots(12.0)}};
  voyage.end_utime = kStart + 7 * kHour;
  return voyage;
}

class ReplayTest : public testing::Test {
 protected:
  ReplayTest() {
    folder_ = std::filesystem::path(testing::TempDir()) / ("quickstrip_replay_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    hull_ = test::s175();
    hull_.grid = {.speed_from = 0.0,
                  .speed_to = from_knots(24.0),
                  .speed_step = from_knots(6.0),
                  .heading_step = radians(30.0)};
    LcmLogWriter log;
    VoyageLogFigures figures;
    QS_CHECK(log.open(path("voyage.log")).ok());
    QS_CHECK(write_voyage_log(growing_sea(), northward(), {}, log, figures).ok());
    QS_CHECK(log.finish().ok());
    QS_CHECK(figures.num_spectra == 4 && figures.num_own_ship == 7 * 360);
  }
  ~ReplayTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }

  /// The advice of every cycle.
  std::vector<advice_t> replay(const std::string& log_name, const std::string& out = "") {
    const auto session = std::make_unique<Session>();
    SessionOptions options;
    options.cycle_period_s = 3600.0;
    const Result<Criteria> criteria = nordforsk_merchant(hull_);
    QS_CHECK(session->configure(hull_, *criteria, options).ok());
    LcmLogReader log;
    QS_CHECK(log.open(path(log_name)).ok());
    LcmLogWriter writer;
    if (!out.empty()) {
      QS_CHECK(writer.open(path(out)).ok());
    }
    std::vector<advice_t> advice;
    const FileStatus status = replay_log(
        log, *session, {}, out.empty() ? nullptr : &writer,
        [&](std::int64_t) { advice.push_back(session->advice()); }, figures_);
    QS_CHECK(status.ok());
    if (!out.empty()) {
      QS_CHECK(writer.finish().ok());
    }
    return advice;
  }

  std::filesystem::path folder_;
  Hull hull_;
  ReplayFigures figures_;
};

TEST_F(ReplayTest, OneCyclePerChangeOfSeaOrCourseAndPerPeriodOfLogTime) {
  const std::vector<advice_t> advice = replay("voyage.log");
  std::vector<double> hours;
  for (const advice_t& a : advice) {
    hours.push_back(static_cast<double>(a.utime - kStart) / static_cast<double>(kHour));
  }
  // Sea at 0, 1, 2, 6; another course at 1.5; between 2 and 6 the period alone.
  EXPECT_EQ(hours, (std::vector<double>{0.0, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0}));
}

TEST_F(ReplayTest, AgeIsJudgedByTheLogsTimeAndAGapInTheSeaIsNoAdvice) {
  const std::vector<advice_t> advice = replay("voyage.log");
  std::vector<int> reasons;
  for (const advice_t& a : advice) {
    reasons.push_back(a.no_advice);
  }
  const int stale = static_cast<int>(NoAdvice::kSeaStale);  // 90 min after hour 2
  EXPECT_EQ(reasons, (std::vector<int>{0, 0, 0, 0, 0, stale, stale, 0}));
}

TEST_F(ReplayTest, TwiceTheSameLogGivesTheSameDigestsAndAnotherCourseOthers) {
  const std::vector<advice_t> first = replay("voyage.log");
  const std::vector<advice_t> second = replay("voyage.log");
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].digest, second[i].digest);
  }
  EXPECT_NE(first[0].digest, first[1].digest);
}

TEST_F(ReplayTest, AReplayOfTheReplaysOwnLogGivesTheSameDigests) {
  const std::vector<advice_t> first = replay("voyage.log", "second.log");
  const std::vector<advice_t> second = replay("second.log");
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].digest, second[i].digest);
  }
}

TEST_F(ReplayTest, AdviceNamesTheMessagesThatItUsed) {
  const std::vector<advice_t> advice = replay("voyage.log");
  EXPECT_EQ(advice[1].input_seq[1], 2);    // the second spectrum
  EXPECT_EQ(advice[1].input_seq[3], 361);  // own ship of one hour, every ten seconds, from 1
  EXPECT_EQ(advice[1].input_source_id[1], 100);
}

TEST_F(ReplayTest, WhatDoesNotDecodeAndWhatIsNotOursIsCountedAndTheReplayGoesOn) {
  LcmLogReader in;
  LcmLogWriter out;
  ASSERT_TRUE(in.open(path("voyage.log")).ok());
  ASSERT_TRUE(out.open(path("dirty.log")).ok());
  LogEvent event;
  const std::vector<std::uint8_t> nonsense(50, 0xA5);
  while (in.next(event)) {
    ASSERT_TRUE(out.append(event.utime, event.channel, event.data).ok());
    if (event.number % 1000 == 0) {
      ASSERT_TRUE(out.append(event.utime, "QS_WAVE_SPECTRUM", nonsense).ok());
      ASSERT_TRUE(out.append(event.utime, "SOMEBODY_ELSE", nonsense).ok());
    }
  }
  ASSERT_TRUE(out.finish().ok());
  const std::vector<advice_t> clean = replay("voyage.log");
  const std::vector<advice_t> dirty = replay("dirty.log");
  EXPECT_EQ(figures_.num_refused, 3u);
  EXPECT_EQ(figures_.num_unknown, 3u);
  ASSERT_EQ(clean.size(), dirty.size());
  EXPECT_EQ(clean.back().digest, dirty.back().digest);
  LogFigures figures;
  ASSERT_TRUE(inspect_log(path("dirty.log"), "QS_", figures).ok());
  EXPECT_EQ(figures.channels.at("QS_WAVE_SPECTRUM").num_malformed, 3u);
  EXPECT_FALSE(figures.channels.at("SOMEBODY_ELSE").is_ours);
  EXPECT_EQ(figures.channels.at("QS_OWN_SHIP").longest_gap_us, 10 * kSecond);
}

TEST_F(ReplayTest, TheAdviceLogPairsEachAdviceWithItsGridAndItsSea) {
  const std::vector<advice_t> advice = replay("voyage.log", "second.log");
  std::size_t num = 0;
  ASSERT_TRUE(read_advice_log(path("second.log"), "QS_", [&](const RecordedAdvice& recorded) {
                EXPECT_EQ(recorded.advice.digest, advice[num].digest);
                EXPECT_EQ(recorded.grid.utime, recorded.advice.utime);
                EXPECT_GT(recorded.grid.num_speeds, 0);
                EXPECT_GT(recorded.limits.num_criteria, 0);
                EXPECT_GT(recorded.sea.hs_m, 0.0);
                ++num;
              }).ok());
  EXPECT_EQ(num, advice.size());
}

TEST_F(ReplayTest, TheTableHasAsManyFieldsInALineAsInItsHeader) {
  const auto num_fields = [](const std::string& line) {
    bool in_text = false;
    int commas = 0;
    for (const char c : line) {
      in_text = c == '"' ? !in_text : in_text;
      commas += c == ',' && !in_text ? 1 : 0;
    }
    return commas;
  };
  for (const advice_t& a : replay("voyage.log")) {
    EXPECT_EQ(num_fields(advice_table_line(a, {})), num_fields(advice_table_header()));
  }
}

TEST_F(ReplayTest, ALogWithoutAdviceIsRefusedWithWhatToDo) {
  const FileStatus status = read_advice_log(path("voyage.log"), "QS_", [](const RecordedAdvice&) {});
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.line().find("quickstrip-sim replay"), std::string::npos);
}

}  // namespace
}  // namespace quickstrip
