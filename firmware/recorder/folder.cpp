#include "firmware/recorder/folder.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace quickstrip {
namespace {

constexpr std::string_view kBegin = "quickstrip_";
constexpr std::string_view kEnd = "Z.log";

bool is_segment_name(const std::string& name) {
  return name.size() == segment_name(0).size() && name.starts_with(kBegin) && name.ends_with(kEnd);
}

std::uint64_t size_of(const std::filesystem::path& path) {
  std::error_code code;
  const std::uint64_t size = std::filesystem::file_size(path, code);
  return code ? 0 : size;
}

}  // namespace

std::string segment_name(std::int64_t utime) {
  const std::int64_t milliseconds = utime / 1000;
  return fmt::format("{}{:%Y-%m-%dT%H-%M-%S}.{:03}{}", kBegin,
                     fmt::gmtime(static_cast<std::time_t>(milliseconds / 1000)), milliseconds % 1000, kEnd);
}

std::vector<std::filesystem::path> segments_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  std::error_code code;
  for (std::filesystem::directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
    if (is_segment_name(at->path().filename().string())) {
      paths.push_back(at->path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

int keep_quota(const std::filesystem::path& folder, std::uint64_t quota,
               const std::filesystem::path& current) {
  const std::vector<std::filesystem::path> paths = segments_in(folder);
  std::uint64_t sum = 0;
  for (const auto& path : paths) {
    sum += size_of(path);
  }
  int num_deleted = 0;
  for (const auto& path : paths) {
    if (sum <= quota) {
      break;
    }
    const std::uint64_t size = size_of(path);
    std::error_code code;
    if (path != current && std::filesystem::remove(path, code)) {
      sum -= std::min(sum, size);
      ++num_deleted;
    }
  }
  return num_deleted;
}

}  // namespace quickstrip
