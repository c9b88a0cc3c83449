// Reads a log that holds advice: each advice with the grid, the limits and the sea that belong to it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "msgs/files/file_status.hpp"
#include "quickstrip/advice_t.hpp"
#include "quickstrip/grid_t.hpp"
#include "quickstrip/limits_t.hpp"
#include "sim/replay/sea_summary.hpp"

namespace quickstrip {

struct RecordedAdvice {
  advice_t advice{};
  grid_t grid{};  // of the same cycle; no speeds when it was not recorded
  limits_t limits{};
  SeaSummary sea;  // the newest before the advice
};

/// Calls `see` for each advice of the log in order. Refused when the log holds none.
FileStatus read_advice_log(const std::string& path, const std::string& prefix,
                           const std::function<void(const RecordedAdvice&)>& see);

/// Of each advice: how bad it is; the worst of a log has the highest. No advice and unknown are lowest.
double badness(const RecordedAdvice& recorded);

}  // namespace quickstrip
