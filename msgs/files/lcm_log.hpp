// Reader and writer of the LCM log format, without the LCM library: per event the sync word 0xEDA1DA01, then
// big-endian event number u64, time of reception u64 [microseconds since the epoch], channel length u32, data
// length u32, channel, data. Events are not checksummed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "msgs/files/file_status.hpp"

namespace quickstrip {

struct LogEvent {
  std::uint64_t number = 0;
  std::int64_t utime = 0;  // of reception, not of measurement
  std::string channel;
  std::vector<std::uint8_t> data;
};

/// Reads events in the order of the file. What is damaged is passed over up to the next sync word; each such
/// place is counted, and the first hundred are worded with their offset.
class LcmLogReader {
 public:
  FileStatus open(const std::filesystem::path& path);
  /// Several, one after the other, as if they were one: the segments of a recorder. At least one.
  FileStatus open(const std::vector<std::filesystem::path>& paths);
  /// False at the end of the (last) file.
  bool next(LogEvent& event);

  [[nodiscard]] std::uint64_t num_events() const { return num_events_; }
  [[nodiscard]] std::uint64_t num_faults() const { return num_faults_; }
  [[nodiscard]] std::uint64_t bytes_passed_over() const { return bytes_passed_over_; }
  /// "FILE: offset 1234: what is wrong there"
  [[nodiscard]] const std::vector<FileError>& faults() const { return faults_; }

 private:
  enum class Outcome { kEvent, kDamaged, kEnd };
  FileStatus open_one(const std::filesystem::path& path);
  bool open_following();
  Outcome read_event(LogEvent& event);
  Outcome fault(std::uint64_t offset, const std::string& what);
  bool find_sync();
  bool read(std::span<std::uint8_t> bytes);
  void go_to(std::uint64_t offset);

  std::string name_;
  std::vector<std::filesystem::path> following_;  // the last first
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  std::uint64_t offset_ = 0;  // of the next event
  std::uint64_t num_events_ = 0;
  std::uint64_t num_faults_ = 0;
  std::uint64_t bytes_passed_over_ = 0;
  std::vector<FileError> faults_;
};

inline constexpr std::size_t kLogHeaderBytes = 28;

/// What stands before channel and data of an event.
std::array<std::uint8_t, kLogHeaderBytes> log_header(std::uint64_t number, std::int64_t utime,
                                                     std::size_t channel_bytes, std::size_t data_bytes);

/// Whether LCM and the reader take an event of these lengths.
bool is_log_event(std::size_t channel_bytes, std::size_t data_bytes);

/// Writes beside the target, and puts the file in its place only by finish(): a failed run leaves nothing.
class LcmLogWriter {
 public:
  LcmLogWriter() = default;
  ~LcmLogWriter();
  LcmLogWriter(const LcmLogWriter&) = delete;
  LcmLogWriter& operator=(const LcmLogWriter&) = delete;

  FileStatus open(const std::filesystem::path& path);
  /// Numbers events from 0. The channel has 1 ... 63 bytes.
  FileStatus append(std::int64_t utime, std::string_view channel, std::span<const std::uint8_t> data);
  FileStatus finish();

 private:
  [[nodiscard]] FileError error(std::string_view what) const;
  std::filesystem::path path_;
  std::filesystem::path beside_;
  std::ofstream stream_;
  std::uint64_t number_ = 0;
};

}  // namespace quickstrip
