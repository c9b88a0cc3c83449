// The folder of a recording: segments named by the UTC time of their start, so that names sort by time, and a
// quota that the oldest make room for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace quickstrip {

/// "quickstrip_2019-09-04T12-40-00.123Z.log"
std::string segment_name(std::int64_t utime);

/// Ours by their names, the oldest first; of a folder that cannot be read none.
std::vector<std::filesystem::path> segments_in(const std::filesystem::path& folder);

/// Deletes the oldest until all together have at most `quota` bytes; never `current`. How many it deleted.
int keep_quota(const std::filesystem::path& folder, std::uint64_t quota,
               const std::filesystem::path& current);

}  // namespace quickstrip
