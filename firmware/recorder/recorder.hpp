// Everything that is heard, into rotating segments from which any moment can be replayed.
//
// Each segment begins with the last message of every channel, of inputs with the last two, for the last may
// have come while the advisor was still computing with the one before (same bytes, so with their original
// utime; the log's time of reception is that of the segment's start): it holds all inputs that the advice in
// it rests on. Not repeated are messages that ask for something to be done, once: queries, acknowledgements,
// entries in the logbook, and QS_TIME, which calls for a cycle. What the advisor remembers of the time before
// (a better verdict that waits, a recommendation that stands: steadiness.hpp) is in no message: for advice to
// the bit the replay is given the segments before too, back to the advisor's start.
//
// Nothing here waits for anything but the disk, and nothing ends it: without room it says so once, keeps the
// newest 16 MB in memory, counts what is lost, tries again with every flush, and says when it goes on. Times
// are arguments, microseconds since the epoch.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/recorder/segment.hpp"

namespace quickstrip {

struct RecorderOptions {
  std::filesystem::path folder;
  std::string prefix = "QS_";
  double segment_s = 3600.0;
  std::uint64_t segment_bytes = 256U << 20U;
  std::uint64_t quota_bytes = 8ULL << 30U;
  double flush_s = 2.0;
};

struct RecorderCounts {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
  std::uint64_t lost = 0;  // of the messages
  std::uint64_t segments = 0;
  std::uint64_t deleted = 0;  // segments, for the quota
};

class Recorder {
 public:
  explicit Recorder(RecorderOptions options) : options_(std::move(options)) {}

  void take(std::int64_t now, std::string_view channel, std::span<const std::uint8_t> data);
  /// Several times a second: flushes, rotates and keeps the quota when due.
  void turn(std::int64_t now);
  void finish() { static_cast<void>(segment_.close()); }

  [[nodiscard]] const RecorderCounts& counts() const { return counts_; }
  /// The last trouble with the disk; empty when all is well.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  [[nodiscard]] const std::filesystem::path& current() const { return segment_.path(); }

 private:
  static constexpr std::size_t kMaxRepeated = 64;  // channels; ours are some twenty
  struct LastTwo {
    std::vector<std::uint8_t> last;
    std::vector<std::uint8_t> before;  // of an input; empty: none
  };
  [[nodiscard]] std::string_view name_of(std::string_view channel) const;
  void remember(std::string_view channel, std::span<const std::uint8_t> data);
  void repeat(std::int64_t now);
  void begin_segment(std::int64_t now);
  void note(const FileStatus& status);

  RecorderOptions options_;
  Segment segment_;
  std::int64_t begun_ = 0;
  std::int64_t flushed_ = 0;
  std::map<std::string, LastTwo, std::less<>> last_;
  RecorderCounts counts_;
  std::string trouble_;
};

}  // namespace quickstrip
