#include "msgs/files/lcm_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace quickstrip {
namespace {

constexpr std::array<std::uint8_t, 4> kSync{0xED, 0xA1, 0xDA, 0x01};
constexpr std::size_t kHeaderBytes = kLogHeaderBytes;
constexpr std::uint32_t kMaxChannelBytes = 63;       // LCM_MAX_CHANNEL_NAME_LENGTH of lcm.h
constexpr std::uint32_t kMaxDataBytes = 16'777'216;  // the longest message that LCM puts together again
constexpr std::size_t kMaxWordedFaults = 100;

std::uint64_t big_endian(std::span<const std::uint8_t> bytes) {
  std::uint64_t value = 0;
  for (const std::uint8_t byte : bytes) {
    value = (value << 8) | byte;
  }
  return value;
}

void put_big_endian(std::uint64_t value, std::span<std::uint8_t> bytes) {
  for (std::size_t i = bytes.size(); i > 0; --i) {
    bytes[i - 1] = static_cast<std::uint8_t>(value & 0xFFu);
    value >>= 8;
  }
}

bool holds_sync(std::span<const std::uint8_t> bytes) {
  return std::search(bytes.begin(), bytes.end(), kSync.begin(), kSync.end()) != bytes.end();
}

char* as_chars(std::uint8_t* bytes) {
  return reinterpret_cast<char*>(bytes);
}

/// A power cut after this loses nothing of a file, or of the names in a folder.
bool reach_the_disk(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_there = file >= 0 && fsync(file) == 0;
  if (file >= 0) {
    ::close(file);
  }
  return is_there;
}

}  // namespace

FileStatus LcmLogReader::open(const std::filesystem::path& path) {
  return open(std::vector<std::filesystem::path>{path});
}

FileStatus LcmLogReader::open(const std::vector<std::filesystem::path>& paths) {
  following_.assign(paths.rbegin(), paths.rend());
  const std::filesystem::path first = following_.back();
  following_.pop_back();
  return open_one(first);
}

/// What cannot be opened is a fault, and passed over.
bool LcmLogReader::open_following() {
  while (!following_.empty()) {  // each turn takes one off
    const std::filesystem::path path = following_.back();
    following_.pop_back();
    const FileStatus status = open_one(path);
    if (status) {
      return true;
    }
    ++num_faults_;
    faults_.push_back({status.line()});
  }
  return false;
}

FileStatus LcmLogReader::open_one(const std::filesystem::path& path) {
  stream_.close();
  stream_.clear();
  name_ = path.string();
  std::error_code code;
  size_ = std::filesystem::file_size(path, code);
  if (!code) {
    stream_.open(path, std::ios::binary);
  }
  if (code || !stream_) {
    return FileError{fmt::format("{}: no such file, or it cannot be read", name_)};
  }
  std::array<std::uint8_t, 4> first{};
  if (size_ > 0 && !(read(first) && first == kSync)) {
    return FileError{fmt::format("{}: offset 0 = {:02X}{:02X}{:02X}{:02X}: an LCM log begins with EDA1DA01",
                                 name_, first[0], first[1], first[2], first[3])};
  }
  go_to(0);
  return {};
}

bool LcmLogReader::next(LogEvent& event) {
  while (true) {  // each turn goes forward in the file by one byte at least
    switch (read_event(event)) {
      case Outcome::kEvent:
        ++num_events_;
        return true;
      case Outcome::kEnd:
        if (!open_following()) {
          return false;
        }
        break;
      case Outcome::kDamaged:
        if (!find_sync() && !open_following()) {
          return false;
        }
        break;
    }
  }
}

LcmLogReader::Outcome LcmLogReader::read_event(LogEvent& event) {
  const std::uint64_t begin = offset_;
  if (begin >= size_) {
    return Outcome::kEnd;
  }
  std::array<std::uint8_t, kHeaderBytes> header{};
  if (size_ - begin < kHeaderBytes || !read(header)) {
    return fault(begin, fmt::format("truncated: {} bytes left, a header has 28", size_ - begin));
  }
  const std::span<const std::uint8_t> bytes(header);
  if (!std::equal(kSync.begin(), kSync.end(), header.begin())) {
    return fault(begin, "no sync word EDA1DA01 where an event should begin");
  }
  const std::uint64_t channel_bytes = big_endian(bytes.subspan(20, 4));
  const std::uint64_t data_bytes = big_endian(bytes.subspan(24, 4));
  if (channel_bytes == 0 || channel_bytes > kMaxChannelBytes || data_bytes > kMaxDataBytes) {
    return fault(begin,
                 fmt::format("channel of {} bytes and data of {} bytes: 1 to 63 and at most {} are right",
                             channel_bytes, data_bytes, kMaxDataBytes));
  }
  if (size_ - begin - kHeaderBytes < channel_bytes + data_bytes) {
    return fault(begin, fmt::format("truncated: the event has {} bytes, the file only {} more",
                                    kHeaderBytes + channel_bytes + data_bytes, size_ - begin));
  }
  event.number = big_endian(bytes.subspan(4, 8));
  event.utime = static_cast<std::int64_t>(big_endian(bytes.subspan(12, 8)));
  event.channel.resize(channel_bytes);
  event.data.resize(data_bytes);
  stream_.read(event.channel.data(), static_cast<std::streamsize>(channel_bytes));
  if (!read(event.data)) {
    return fault(begin, "cannot be read");
  }
  const std::uint64_t end = begin + kHeaderBytes + channel_bytes + data_bytes;
  // A damaged length swallows events: then a sync word lies inside, and none follows.
  if (end < size_ && holds_sync(event.data)) {
    std::array<std::uint8_t, 4> following{};
    const bool is_followed = size_ - end >= 4 && read(following) && following == kSync;
    if (!is_followed) {
      return fault(begin, "its length is wrong: it would hold other events");
    }
    go_to(end);
  }
  offset_ = end;
  return Outcome::kEvent;
}

LcmLogReader::Outcome LcmLogReader::fault(std::uint64_t offset, const std::string& what) {
  ++num_faults_;
  if (faults_.size() < kMaxWordedFaults) {
    faults_.push_back({fmt::format("{}: offset {}: {}", name_, offset, what)});
  }
  return Outcome::kDamaged;
}

// From the byte after the damaged event's first on, by blocks that overlap by a sync word less one byte.
bool LcmLogReader::find_sync() {
  const std::uint64_t from = offset_;
  std::array<std::uint8_t, 4096> block{};
  std::uint64_t at = from + 1;
  while (at < size_) {
    go_to(at);
    const std::size_t wanted = std::min<std::uint64_t>(block.size(), size_ - at);
    if (!read(std::span(block).first(wanted))) {
      break;
    }
    const auto* const end = block.data() + wanted;
    const auto* const found =
        std::search(static_cast<const std::uint8_t*>(block.data()), end, kSync.begin(), kSync.end());
    if (found != end) {
      go_to(at + static_cast<std::uint64_t>(found - block.data()));
      bytes_passed_over_ += offset_ - from;
      return true;
    }
    at += wanted < block.size() ? wanted : wanted - (kSync.size() - 1);
  }
  bytes_passed_over_ += size_ - from;
  offset_ = size_;
  return false;
}

bool LcmLogReader::read(std::span<std::uint8_t> bytes) {
  stream_.read(as_chars(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return static_cast<bool>(stream_);
}

void LcmLogReader::go_to(std::uint64_t offset) {
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(offset));
  offset_ = offset;
}

std::array<std::uint8_t, kLogHeaderBytes> log_header(std::uint64_t number, std::int64_t utime,
                                                     std::size_t channel_bytes, std::size_t data_bytes) {
  std::array<std::uint8_t, kLogHeaderBytes> header{};
  const std::span<std::uint8_t> bytes(header);
  std::copy(kSync.begin(), kSync.end(), header.begin());
  put_big_endian(number, bytes.subspan(4, 8));
  put_big_endian(static_cast<std::uint64_t>(utime), bytes.subspan(12, 8));
  put_big_endian(channel_bytes, bytes.subspan(20, 4));
  put_big_endian(data_bytes, bytes.subspan(24, 4));
  return header;
}

bool is_log_event(std::size_t channel_bytes, std::size_t data_bytes) {
  return channel_bytes > 0 && channel_bytes <= kMaxChannelBytes && data_bytes <= kMaxDataBytes;
}

LcmLogWriter::~LcmLogWriter() {
  if (stream_.is_open()) {  // not finished: leave nothing
    stream_.close();
    std::error_code code;
    std::filesystem::remove(beside_, code);
  }
}

FileStatus LcmLogWriter::open(const std::filesystem::path& path) {
  path_ = path;
  beside_ = path;
  beside_ += ".part";
  number_ = 0;
  stream_.open(beside_, std::ios::binary | std::ios::trunc);
  return stream_ ? FileStatus() : FileStatus(error("cannot be written"));
}

FileStatus LcmLogWriter::append(std::int64_t utime, std::string_view channel,
                                std::span<const std::uint8_t> data) {
  if (!is_log_event(channel.size(), data.size())) {
    return error(fmt::format("channel \"{}\" with {} bytes of data: 1 to 63 and at most {} are right",
                             channel, data.size(), kMaxDataBytes));
  }
  auto header = log_header(number_, utime, channel.size(), data.size());
  stream_.write(as_chars(header.data()), static_cast<std::streamsize>(header.size()));
  stream_.write(channel.data(), static_cast<std::streamsize>(channel.size()));
  stream_.write(reinterpret_cast<const char*>(data.data()), static_cast<std::streamsize>(data.size()));
  ++number_;
  return stream_ ? FileStatus() : FileStatus(error("cannot be written"));
}

FileStatus LcmLogWriter::finish() {
  stream_.close();
  std::error_code code;
  if (stream_ && !reach_the_disk(beside_)) {
    stream_.setstate(std::ios::failbit);
  }
  if (stream_) {
    std::filesystem::rename(beside_, path_, code);
  }
  if (!stream_ || code) {
    std::error_code ignored;
    std::filesystem::remove(beside_, ignored);
    return error("cannot be written");
  }
  const std::filesystem::path folder = path_.parent_path();
  static_cast<void>(reach_the_disk(folder.empty() ? "." : folder));  // the name: some file systems cannot
  return {};
}

FileError LcmLogWriter::error(std::string_view what) const {
  return {fmt::format("{}: {}", path_.string(), what)};
}

}  // namespace quickstrip
