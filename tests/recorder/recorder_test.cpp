#include "firmware/recorder/recorder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "firmware/recorder/folder.hpp"
#include "msgs/files/lcm_log.hpp"

namespace quickstrip {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kStart = 1'600'000'000 * kSecond;

class RecorderTest : public testing::Test {
 protected:
  RecorderTest()
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("quickstrip_recorder_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~RecorderTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] RecorderOptions options(double segment_s = 60.0) const {
    RecorderOptions out;
    out.folder = folder_;
    out.segment_s = segment_s;
    return out;
  }
  static std::vector<std::uint8_t> bytes(std::string_view text, std::size_t size = 0) {
    // Behind the text the first byte of a sync word.
    std::vector<std::uint8_t> data(std::max(size, text.size()), std::uint8_t{0xED});
    for (std::size_t i = 0; i < text.size(); ++i) {
      data[i] = static_cast<std::uint8_t>(text[i]);
    }
    return data;
  }
  static std::vector<LogEvent> events_of(const std::filesystem::path& path) {
    LcmLogReader reader;
    EXPECT_TRUE(reader.open(path));
    std::vector<LogEvent> events;
    for (LogEvent event; reader.next(event);) {
      events.push_back(event);
    }
    return events;
  }
  [[nodiscard]] std::uint64_t sum_of_sizes() const {
    std::uint64_t sum = 0;
    for (const auto& path : segments_in(folder_)) {
      sum += std::filesystem::file_size(path);
    }
    return sum;
  }

  std::filesystem::path folder_;
};

TEST_F(RecorderTest, ASegmentBeginsWithTheLastMessagesOfEveryChannelButThoseThatAskForSomethingOnce) {
  Recorder recorder(options(60.0));
  recorder.take(kStart, "QS_LOADING", bytes("loading"));
  recorder.take(kStart + 1, "QS_SEA_STATE", bytes("sea 1"));
  recorder.take(kStart + 2, "QS_QUERY", bytes("query"));
  recorder.take(kStart + 2, "QS_ALERT_ACK", bytes("acknowledged"));
  recorder.take(kStart + 2, "QS_TIME", bytes("time"));
  recorder.take(kStart + 3, "QS_SEA_STATE", bytes("sea 2"));
  recorder.take(kStart + 4, "QS_ADVICE", bytes("advice before"));
  recorder.take(kStart + 4, "QS_ADVICE", bytes("advice"));
  recorder.take(kStart + 61 * kSecond, "QS_OWN_SHIP", bytes("ship"));
  recorder.finish();
  const auto paths = segments_in(folder_);
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(paths[0].filename(), "quickstrip_2020-09-13T12-26-40.000Z.log");  // date -u -d @1600000000
  EXPECT_EQ(events_of(paths[0]).size(), 8U);
  const auto second = events_of(paths[1]);
  ASSERT_EQ(second.size(), 5U);
  EXPECT_EQ(second[0].channel, "QS_LOADING");
  EXPECT_EQ(second[0].data, bytes("loading"));
  EXPECT_EQ(second[1].data, bytes("sea 1"));  // the last but one too: a cycle may still rest on it
  EXPECT_EQ(second[2].data, bytes("sea 2"));
  EXPECT_EQ(second[3].data, bytes("advice"));  // what rests on the inputs behind them
  EXPECT_EQ(second[4].channel, "QS_OWN_SHIP");
  for (const LogEvent& event : second) {
    EXPECT_EQ(event.utime, kStart + 61 * kSecond);  // the time of reception never goes back
  }
}

TEST_F(RecorderTest, TheQuotaIsKeptTheOldestGoFirstAndTheCurrentOneStays) {
  RecorderOptions small = options();
  small.segment_bytes = 100'000;
  small.quota_bytes = 350'000;
  Recorder recorder(small);
  std::vector<std::string> begun;
  for (int i = 0; i < 1000; ++i) {
    recorder.take(kStart + i * kSecond, "QS_GRID", bytes("grid", 5000));
    recorder.turn(kStart + i * kSecond);
    if (begun.empty() || begun.back() != recorder.current()) {
      begun.push_back(recorder.current());
    }
    EXPECT_LE(sum_of_sizes(), small.quota_bytes);
    EXPECT_TRUE(std::filesystem::exists(recorder.current()));
  }
  recorder.finish();
  const auto left = segments_in(folder_);
  EXPECT_GT(recorder.counts().deleted, 30U);
  EXPECT_EQ(recorder.counts().segments, left.size() + recorder.counts().deleted);
  EXPECT_GE(left.size(), 3U);
  for (std::size_t i = 0; i < left.size(); ++i) {  // the newest
    EXPECT_EQ(left[left.size() - 1 - i], begun[begun.size() - 1 - i]);
  }
  EXPECT_EQ(recorder.counts().lost, 0U);
}

TEST_F(RecorderTest, FilesOfOthersAreNeitherCountedNorDeleted) {
  std::filesystem::path other = folder_ / "voyage.log";
  { std::ofstream(other) << std::string(100'000, 'x'); }
  { std::ofstream(folder_ / segment_name(kStart - 1)) << std::string(1000, 'x'); }
  EXPECT_EQ(keep_quota(folder_, 10, {}), 1);
  EXPECT_TRUE(std::filesystem::exists(other));
}

TEST_F(RecorderTest, WhatWasFlushedCanBeReadWhateverHappensThen) {
  Recorder recorder(options());
  recorder.take(kStart, "QS_OWN_SHIP", bytes("one", 300));
  recorder.turn(kStart + 3 * kSecond);
  recorder.take(kStart + 3 * kSecond, "QS_OWN_SHIP", bytes("two", 300));  // not flushed yet
  const auto events = events_of(recorder.current());
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].data, bytes("one", 300));
  recorder.finish();
  // A power cut in the middle of a flush: a file cut anywhere gives its whole events.
  const auto path = recorder.current();
  const auto whole = events_of(path);
  ASSERT_EQ(whole.size(), 2U);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 100);
  EXPECT_EQ(events_of(path).size(), 1U);
}

TEST_F(RecorderTest, WithoutRoomItKeepsWhatItHearsAndGoesOnWhenThereIsRoom) {
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit fails, as on a full disk
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  Recorder recorder(options(1e6));
  const auto hear = [&](int i) {
    recorder.take(kStart + i * kSecond, "QS_GRID", bytes(std::to_string(i), 1000));
    recorder.turn(kStart + i * kSecond);
  };
  for (int i = 0; i < 10; ++i) {
    hear(i);
  }
  const rlimit full{20'000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
  for (int i = 10; i < 100; ++i) {
    hear(i);
  }
  const bool was_in_trouble = !recorder.trouble().empty();
  const std::size_t num_readable = events_of(recorder.current()).size();
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_TRUE(was_in_trouble);
  EXPECT_GE(num_readable, 9U);
  for (int i = 100; i < 110; ++i) {
    hear(i);
  }
  recorder.finish();
  EXPECT_TRUE(recorder.trouble().empty());
  EXPECT_EQ(recorder.counts().lost, 0U);
  const auto events = events_of(recorder.current());
  ASSERT_EQ(events.size(), 110U);
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].data, bytes(std::to_string(i), 1000)) << i;
  }
}

TEST_F(RecorderTest, AFolderThatGoesAwayEndsNothing) {
  Recorder recorder(options(10.0));
  recorder.take(kStart, "QS_OWN_SHIP", bytes("one"));
  recorder.turn(kStart + 3 * kSecond);
  std::filesystem::remove_all(folder_);
  for (int i = 4; i < 40; ++i) {
    recorder.take(kStart + i * kSecond, "QS_OWN_SHIP", bytes("more"));
    recorder.turn(kStart + i * kSecond);
  }
  EXPECT_FALSE(recorder.trouble().empty());
  EXPECT_GT(recorder.counts().lost, 0U);
  std::filesystem::create_directories(folder_);
  recorder.take(kStart + 43 * kSecond, "QS_OWN_SHIP", bytes("again"));
  recorder.finish();
  EXPECT_TRUE(recorder.trouble().empty());
  EXPECT_EQ(segments_in(folder_).size(), 1U);
}

TEST_F(RecorderTest, SeveralSegmentsAreReadAsOne) {
  Recorder recorder(options(10.0));
  for (int i = 0; i < 35; ++i) {
    recorder.take(kStart + i * kSecond, "QS_QUERY", bytes(std::to_string(i)));  // not repeated
  }
  recorder.finish();
  LcmLogReader reader;
  ASSERT_TRUE(reader.open(segments_in(folder_)));
  int i = 0;
  for (LogEvent event; reader.next(event); ++i) {
    EXPECT_EQ(event.data, bytes(std::to_string(i)));
  }
  EXPECT_EQ(i, 35);
  EXPECT_EQ(reader.num_faults(), 0U);
}

}  // namespace
}  // namespace quickstrip
