// Makes the log that a voyage through a measured sea would have recorded: a wave spectrum whenever the buoy
// reported one, the ship's heading and speed at a steady period. Gaps in the sea stay gaps.
#pragma once

#include <cstdint>
#include <string>

#include "msgs/files/file_status.hpp"
#include "msgs/files/lcm_log.hpp"
#include "msgs/files/voyage_file.hpp"
#include "sim/sea_files/sea_series.hpp"

namespace quickstrip {

struct VoyageLogOptions {
  std::string prefix = "QS_";
  double own_ship_period_s = 10.0;  // at the advisor's stale-after: ten days are 86,400 messages, 13 MB
};

struct VoyageLogFigures {
  std::uint64_t num_spectra = 0;
  std::uint64_t num_own_ship = 0;
};

/// Events in order of time; at one time the ship's comes first. Refused when the sea has no record during the
/// voyage.
FileStatus write_voyage_log(const SeaSeries& sea, const Voyage& voyage, const VoyageLogOptions& options,
                            LcmLogWriter& log, VoyageLogFigures& figures);

}  // namespace quickstrip
