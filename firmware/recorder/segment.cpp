#include "firmware/recorder/segment.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "msgs/files/lcm_log.hpp"

namespace quickstrip {
namespace {

FileError failed(const std::filesystem::path& path) {
  return {fmt::format("{}: {}", path.string(), std::strerror(errno))};
}

/// All of it, or false with errno.
bool write_all(int fd, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {  // each turn writes a byte at least
    const ssize_t written = write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written <= 0) {
      return false;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

Segment::~Segment() {
  static_cast<void>(close());
}

FileStatus Segment::open(const std::filesystem::path& path) {
  static_cast<void>(close());
  path_ = path;
  written_ = 0;
  number_ = 0;
  gathered_.clear();
  num_gathered_ = 0;
  fd_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  return fd_ < 0 ? FileStatus(failed(path)) : FileStatus();
}

bool Segment::append(std::int64_t utime, std::string_view channel, std::span<const std::uint8_t> data) {
  if (!is_log_event(channel.size(), data.size()) ||
      gathered_.size() + kLogHeaderBytes + channel.size() + data.size() > kMaxGathered) {
    return false;
  }
  const auto header = log_header(number_, utime, channel.size(), data.size());
  gathered_.insert(gathered_.end(), header.begin(), header.end());
  gathered_.insert(gathered_.end(), channel.begin(), channel.end());
  gathered_.insert(gathered_.end(), data.begin(), data.end());
  ++number_;
  ++num_gathered_;
  return true;
}

FileStatus Segment::flush() {
  if (fd_ < 0 || gathered_.empty()) {
    return {};
  }
  if (!write_all(fd_, gathered_) || fdatasync(fd_) != 0) {
    const FileError error = failed(path_);
    const auto whole = static_cast<off_t>(written_);
    if (ftruncate(fd_, whole) != 0 || lseek(fd_, whole, SEEK_SET) < 0) {
      ::close(fd_);  // what is there can be read; what follows goes into another file
      fd_ = -1;
    }
    return error;
  }
  written_ += gathered_.size();
  gathered_.clear();
  num_gathered_ = 0;
  return {};
}

FileStatus Segment::close() {
  if (fd_ < 0) {
    return {};
  }
  FileStatus status = flush();
  if (fd_ >= 0) {
    ::close(fd_);
    fd_ = -1;
  }
  return status;
}

}  // namespace quickstrip
