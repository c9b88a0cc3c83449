// One file of a recording, in the LCM log format: written so that what is on the disk can always be read.
//
// Events are gathered in memory and written and synced together by flush(): a power cut loses what came since
// the last flush, and at most an event cut in two at the end, which a reader passes over. A failed write
// (disk full) leaves no half event: the file is cut back to the last whole flush, and the caller is told. No
// file beside it that is renamed at the end: there may be no end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "msgs/files/file_status.hpp"

namespace quickstrip {

class Segment {
 public:
  Segment() = default;
  ~Segment();
  Segment(const Segment&) = delete;
  Segment& operator=(const Segment&) = delete;

  /// A new file; one that exists is an error.
  FileStatus open(const std::filesystem::path& path);
  [[nodiscard]] bool is_open() const { return fd_ >= 0; }
  /// Into memory. False, and the event is lost, for lengths that no log takes or when memory is full
  /// (kMaxGathered: the disk has not taken anything for long).
  bool append(std::int64_t utime, std::string_view channel, std::span<const std::uint8_t> data);
  /// To the disk. After a failure the gathered events stay and are tried again with the next flush.
  FileStatus flush();
  /// Flushes what it can and closes.
  FileStatus close();

  /// On disk and in memory.
  [[nodiscard]] std::uint64_t size() const { return written_ + gathered_.size(); }
  /// Events in memory; after a failed close() those that are lost.
  [[nodiscard]] std::uint64_t num_gathered() const { return num_gathered_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  static constexpr std::size_t kMaxGathered = 16U << 20U;  // minutes of all channels

 private:
  std::filesystem::path path_;
  int fd_ = -1;
  std::uint64_t written_ = 0;
  std::uint64_t number_ = 0;
  std::uint64_t num_gathered_ = 0;
  std::vector<std::uint8_t> gathered_;
};

}  // namespace quickstrip
