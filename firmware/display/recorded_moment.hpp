// A moment of a log, shown as it was: for the demo's picture, and for looking at a run afterwards.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "firmware/display/display.hpp"
#include "msgs/files/file_status.hpp"

namespace quickstrip {

/// Feeds the log's messages up to the last advice not after `at` ("2019-09-04T12:40Z"; empty: the whole log)
/// and what belongs to its cycle. Trends are those of the log before. Refused without an advice by then.
FileStatus put_recorded_moment(const std::string& log, const std::string& at, const std::string& prefix,
                               Display& display);

/// "2019-09-04T12:40Z", with seconds if wanted; nothing for anything else.
std::optional<std::int64_t> utime_of_text(const std::string& text);

}  // namespace quickstrip
