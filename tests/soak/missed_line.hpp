// The line in which the advisor's journal tells of deadlines that were missed (firmware/advisor/journal.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace quickstrip::soak {

struct MissedLine {
  std::int64_t second = 0;  // of the worst, since the epoch
  int num = 1;
  double period_ms = 0.0, processor_ms = 0.0;  // of the worst
  int num_waits = 0;
};

/// Empty for any other line.
std::optional<MissedLine> read_missed_line(const std::string& line);

}  // namespace quickstrip::soak
