// What a log holds: channels, counts, times, gaps, and what cannot be read.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "msgs/files/file_status.hpp"

namespace quickstrip {

struct ChannelFigures {
  std::uint64_t num_events = 0;
  std::uint64_t num_bytes = 0;
  std::uint64_t num_malformed = 0;  // of the channels that we know: not of their type
  bool is_ours = false;
  std::int64_t first_utime = 0;
  std::int64_t last_utime = 0;
  std::int64_t longest_gap_us = 0;
  std::int64_t longest_gap_from = 0;
};

struct LogFigures {
  std::map<std::string, ChannelFigures> channels;
  std::uint64_t num_events = 0;
  std::uint64_t num_faults = 0;
  std::uint64_t bytes_passed_over = 0;
  std::uint64_t num_out_of_time = 0;  // not between 1970 and 2200; they count in no first, last or gap
  std::string first_fault;
};

FileStatus inspect_log(const std::string& path, const std::string& prefix, LogFigures& out);

/// A table for people.
std::string inspection_text(const LogFigures& figures);

}  // namespace quickstrip
