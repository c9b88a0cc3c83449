#include "firmware/nmea/source.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "msgs/convert/units.hpp"

namespace quickstrip::nmea {
namespace {

constexpr int kMaxDatagramsPerTurn = 512;
constexpr std::size_t kDatagram_bytes = 65'536;
constexpr std::size_t kStream_bytes = 16'384;
constexpr double kMendEvery_s = 2.0;

bool is_hung_up(int fd) {
  pollfd one{fd, POLLIN, 0};
  return poll(&one, 1, 0) > 0 && (one.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
}

}  // namespace

Source::Source(Source&& other) noexcept
    : spec_(std::move(other.spec_)), fd_(std::exchange(other.fd_, -1)), has_ended_(other.has_ended_) {}

Source::~Source() {
  close();
}

void Source::close() {
  if (fd_ >= 0) {
    ::close(fd_);
    fd_ = -1;
  }
}

void Source::read(std::size_t index, std::int64_t arrival, Gateway& gateway) {
  if (fd_ < 0) {
    return;
  }
  if (spec_.kind == SourceKind::kUdp) {
    read_datagrams(index, arrival, gateway);
  } else {
    read_stream(index, arrival, gateway);
  }
}

void Source::read_datagrams(std::size_t index, std::int64_t arrival, Gateway& gateway) {
  static std::array<char, kDatagram_bytes> datagram;  // one thread reads
  for (int i = 0; i < kMaxDatagramsPerTurn; ++i) {
    const ssize_t size = recv(fd_, datagram.data(), datagram.size(), MSG_DONTWAIT);
    if (size < 0) {
      return;  // nothing there; an error of a socket (a port unreachable) passes
    }
    gateway.take_datagram(index, {datagram.data(), static_cast<std::size_t>(size)}, arrival);
  }
}

void Source::read_stream(std::size_t index, std::int64_t arrival, Gateway& gateway) {
  std::array<char, kStream_bytes> bytes{};
  const ssize_t size = ::read(fd_, bytes.data(), bytes.size());
  const auto take = [&](std::string_view line) { gateway.take(index, line, arrival); };
  const auto drop = [&gateway] { gateway.drop_long_line(); };
  if (size > 0) {
    framer_.feed({bytes.data(), static_cast<std::size_t>(size)}, take, drop);
    return;
  }
  const bool is_nothing_there = size < 0 && (errno == EAGAIN || errno == EINTR);
  // A terminal with VMIN 0 reads nothing as 0, and one that is gone too.
  if (is_nothing_there || (size == 0 && spec_.kind == SourceKind::kSerial && !is_hung_up(fd_))) {
    return;
  }
  framer_.finish(take, drop);
  close();
  if (is_file()) {
    has_ended_ = true;
  } else {
    lost_utime_ = arrival;
    std::fprintf(stderr, "--serial %s: gone; opened again when it is back\n", spec_.where.c_str());
  }
}

void Source::mend(std::int64_t now) {
  if (lost_utime_ == 0 || (now >= lost_utime_ && seconds_between(lost_utime_, now) < kMendEvery_s)) {
    return;
  }
  lost_utime_ = now;
  if (open()) {
    lost_utime_ = 0;
    std::fprintf(stderr, "--serial %s: back\n", spec_.where.c_str());
  }
}

}  // namespace quickstrip::nmea
