#include "msgs/files/lcm_log.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <lcm/lcm-cpp.hpp>
#include <random>

namespace quickstrip {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Tests run side by side: a folder for each process, taken away at its end.
class ScratchFolder {
 public:
  ScratchFolder() { std::filesystem::create_directories(path_); }
  ~ScratchFolder() {
    std::error_code code;
    std::filesystem::remove_all(path_, code);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] std::filesystem::path file(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_ =
      std::filesystem::path(testing::TempDir()) / ("quickstrip_lcm_log_test_" + std::to_string(getpid()));
};

std::filesystem::path scratch(const char* name) {
  static const ScratchFolder folder;
  return folder.file(name);
}

Bytes bytes_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void put_bytes(const std::filesystem::path& path, const Bytes& bytes) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

// Events of 1 ... 300 bytes from a fixed seed, on three channels.
std::vector<LogEvent> some_events(std::size_t count) {
  std::mt19937 random(42);
  std::vector<LogEvent> events;
  for (std::size_t i = 0; i < count; ++i) {
    LogEvent event;
    event.number = i;
    event.utime = 1'567'123'200'000'000 + static_cast<std::int64_t>(i) * 1'000'000;
    event.channel = i % 3 == 0 ? "QS_SEA_STATE" : i % 3 == 1 ? "QS_OWN_SHIP" : "QS_LOADING";
    event.data.resize(1 + random() % 300);
    for (std::uint8_t& byte : event.data) {
      byte = static_cast<std::uint8_t>(random() & 0xFFu);
    }
    events.push_back(event);
  }
  return events;
}

void write_log(const std::filesystem::path& path, const std::vector<LogEvent>& events) {
  LcmLogWriter writer;
  ASSERT_TRUE(writer.open(path).ok());
  for (const LogEvent& event : events) {
    ASSERT_TRUE(writer.append(event.utime, event.channel, event.data).ok());
  }
  ASSERT_TRUE(writer.finish().ok());
}

std::vector<LogEvent> read_log(LcmLogReader& reader, const std::filesystem::path& path) {
  std::vector<LogEvent> events;
  EXPECT_TRUE(reader.open(path).ok());
  LogEvent event;
  while (reader.next(event)) {
    events.push_back(event);
  }
  return events;
}

TEST(LcmLog, OneEventIsTheseBytes) {
  const auto path = scratch("one.lcm");
  const Bytes data{0xAA, 0xBB};
  LcmLogWriter writer;
  ASSERT_TRUE(writer.open(path).ok());
  ASSERT_TRUE(writer.append(0x0102030405060708, "AB", data).ok());
  ASSERT_TRUE(writer.finish().ok());
  EXPECT_EQ(bytes_of(path), (Bytes{0xED, 0xA1, 0xDA, 0x01,              // sync
                                   0,    0,    0,    0,    0, 0, 0, 0,  // number
                                   1,    2,    3,    4,    5, 6, 7, 8,  // time
                                   0,    0,    0,    2,    0, 0, 0, 2,  // lengths
                                   'A',  'B',  0xAA, 0xBB}));
}

TEST(LcmLog, WhatIsReadAndWrittenAgainIsTheSameToTheByte) {
  const auto path = scratch("first.lcm");
  const auto again = scratch("again.lcm");
  write_log(path, some_events(200));
  LcmLogReader reader;
  const auto events = read_log(reader, path);
  EXPECT_EQ(reader.num_faults(), 0u);
  write_log(again, events);
  EXPECT_EQ(bytes_of(path), bytes_of(again));
}

TEST(LcmLog, TheLcmLibraryReadsWhatWeWrite) {
  const auto path = scratch("ours.lcm");
  const auto events = some_events(50);
  write_log(path, events);
  lcm::LogFile log(path.string(), "r");
  ASSERT_TRUE(log.good());
  for (const LogEvent& event : events) {
    const lcm::LogEvent* theirs = log.readNextEvent();
    ASSERT_NE(theirs, nullptr);
    EXPECT_EQ(theirs->timestamp, event.utime);
    EXPECT_EQ(theirs->channel, event.channel);
    const auto* data = static_cast<const std::uint8_t*>(theirs->data);
    EXPECT_EQ(Bytes(data, data + theirs->datalen), event.data);
  }
  EXPECT_EQ(log.readNextEvent(), nullptr);
}

TEST(LcmLog, WeReadWhatTheLcmLibraryWrites) {
  const auto path = scratch("theirs.lcm");
  auto events = some_events(50);
  {
    lcm::LogFile log(path.string(), "w");
    for (LogEvent& event : events) {
      lcm::LogEvent out;
      out.channel = event.channel;
      out.timestamp = event.utime;
      out.eventnum = static_cast<std::int64_t>(event.number);
      out.datalen = static_cast<std::int32_t>(event.data.size());
      out.data = event.data.data();
      ASSERT_EQ(log.writeEvent(&out), 0);
    }
  }
  LcmLogReader reader;
  const auto read = read_log(reader, path);
  ASSERT_EQ(read.size(), events.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].number, i);
    EXPECT_EQ(read[i].utime, events[i].utime);
    EXPECT_EQ(read[i].channel, events[i].channel);
    EXPECT_EQ(read[i].data, events[i].data);
  }
}

TEST(LcmLog, ATruncatedEndIsAFaultWithItsOffset) {
  const auto path = scratch("truncated.lcm");
  const auto events = some_events(10);
  write_log(path, events);
  Bytes bytes = bytes_of(path);
  const std::size_t last = bytes.size() - (28 + events[9].channel.size() + events[9].data.size());
  bytes.pop_back();
  put_bytes(path, bytes);
  LcmLogReader reader;
  EXPECT_EQ(read_log(reader, path).size(), 9u);
  ASSERT_EQ(reader.num_faults(), 1u);
  EXPECT_NE(reader.faults()[0].line.find("offset " + std::to_string(last) + ": truncated"), std::string::npos)
      << reader.faults()[0].line;
}

class DamagedLog : public testing::Test {
 protected:
  // Replaces the byte at `within` bytes from the beginning of event 4 of 10 and reads what is left.
  std::vector<LogEvent> read_with(std::size_t within, std::uint8_t value) {
    const auto path = scratch("damaged.lcm");
    const auto events = some_events(10);
    write_log(path, events);
    Bytes bytes = bytes_of(path);
    std::size_t at = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      at += 28 + events[i].channel.size() + events[i].data.size();
    }
    bytes[at + within] = value;
    put_bytes(path, bytes);
    return read_log(reader_, path);
  }
  void expect_only_the_fifth_is_lost(const std::vector<LogEvent>& events) {
    ASSERT_EQ(events.size(), 9u);
    EXPECT_EQ(events[3].number, 3u);
    EXPECT_EQ(events[4].number, 5u);
    EXPECT_EQ(reader_.num_faults(), 1u);
    EXPECT_GT(reader_.bytes_passed_over(), 28u);
  }
  LcmLogReader reader_;
};

TEST_F(DamagedLog, ASpoiltSyncWordLosesOneEvent) {
  expect_only_the_fifth_is_lost(read_with(1, 0x00));
}

TEST_F(DamagedLog, AChannelLengthBeyondReasonLosesOneEvent) {
  expect_only_the_fifth_is_lost(read_with(20, 0x7F));
}

TEST_F(DamagedLog, ADataLengthBeyondTheFileLosesOneEvent) {
  expect_only_the_fifth_is_lost(read_with(25, 0x0F));
}

TEST_F(DamagedLog, ADataLengthThatSwallowsOtherEventsLosesOneEvent) {
  // Byte 26 counts 256s: 2 makes the event reach over the next one, and still end within the file.
  expect_only_the_fifth_is_lost(read_with(26, 2));
}

TEST(LcmLog, WhatIsNoLogIsRefused) {
  const auto path = scratch("no_log.txt");
  put_bytes(path, Bytes{'h', 'e', 'l', 'l', 'o'});
  LcmLogReader reader;
  EXPECT_NE(reader.open(path).line().find("an LCM log begins with EDA1DA01"), std::string::npos);
  LcmLogReader other;
  EXPECT_NE(other.open(scratch("not_there")).line().find("no such file"), std::string::npos);
}

TEST(LcmLog, AnEmptyLogHasNoEventsAndNoFaults) {
  const auto path = scratch("empty.lcm");
  put_bytes(path, {});
  LcmLogReader reader;
  EXPECT_TRUE(read_log(reader, path).empty());
  EXPECT_EQ(reader.num_faults(), 0u);
}

TEST(LcmLog, AnUnfinishedLogLeavesNoFile) {
  const auto path = scratch("unfinished.lcm");
  std::filesystem::remove(path);
  {
    LcmLogWriter writer;
    ASSERT_TRUE(writer.open(path).ok());
    ASSERT_TRUE(writer.append(1, "QS_TIME", Bytes{1, 2, 3}).ok());
    EXPECT_FALSE(writer.append(1, "", Bytes{1}).ok());
    EXPECT_FALSE(writer.append(1, std::string(64, 'C'), Bytes{1}).ok());
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
}

}  // namespace
}  // namespace quickstrip
