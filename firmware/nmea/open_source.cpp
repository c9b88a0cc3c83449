// Opening of sockets, devices and files.
#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>

#include "firmware/nmea/source.hpp"

namespace quickstrip::nmea {
namespace {

constexpr int kReceiveBuffer_bytes = 4 << 20;  // 10,000 lines of 82 characters are 0.8 MB

struct Pair {
  std::string first;
  std::string second;
};

/// "A@B"; B empty without an '@'.
Pair parted(const std::string& text) {
  const std::size_t at = text.find('@');
  return at == std::string::npos ? Pair{text, {}} : Pair{text.substr(0, at), text.substr(at + 1)};
}

std::optional<int> whole_number(const std::string& text) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stopped == end ? std::optional<int>(value) : std::nullopt;
}

std::optional<in_addr> address_of(const std::string& text) {
  in_addr address{};
  return inet_pton(AF_INET, text.c_str(), &address) == 1 ? std::optional<in_addr>(address) : std::nullopt;
}

bool is_multicast(in_addr address) {
  return (ntohl(address.s_addr) >> 28U) == 14U;  // 224.0.0.0/4
}

std::optional<speed_t> speed_of(int baud) {
  switch (baud) {
    case 4800:
      return B4800;
    case 9600:
      return B9600;
    case 19200:
      return B19200;
    case 38400:
      return B38400;
    case 57600:
      return B57600;
    case 115200:
      return B115200;
    default:
      return {};
  }
}

FileError failed(const std::string& what) {
  return {fmt::format("{}: {}", what, std::strerror(errno))};
}

}  // namespace

FileStatus Source::open() {
  switch (spec_.kind) {
    case SourceKind::kUdp:
      return open_udp();
    case SourceKind::kSerial:
      return open_serial();
    case SourceKind::kFile:
      return open_file();
  }
  return {};
}

FileStatus Source::open_udp() {
  const Pair parts = parted(spec_.where);
  const std::optional<int> port = whole_number(parts.first);
  const std::optional<in_addr> address = address_of(parts.second.empty() ? "0.0.0.0" : parts.second);
  const std::optional<in_addr> interface = address_of(spec_.interface.empty() ? "0.0.0.0" : spec_.interface);
  if (!port || *port < 1 || *port > 65'535 || !address || !interface) {
    return FileError{fmt::format(
        "--udp {}: PORT or PORT@ADDRESS is right, a port of 1 to 65535 and an IPv4 address", spec_.where)};
  }
  fd_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const std::string what = "--udp " + spec_.where;
  if (fd_ < 0) {
    return failed(what);
  }
  const int yes = 1;
  static_cast<void>(setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer_bytes, sizeof(int)));
  if (is_multicast(*address)) {  // several programs may hear one group
    static_cast<void>(setsockopt(fd_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(int)));
  }
  sockaddr_in own{};
  own.sin_family = AF_INET;
  own.sin_port = htons(static_cast<std::uint16_t>(*port));
  own.sin_addr = *address;
  if (bind(fd_, reinterpret_cast<const sockaddr*>(&own), sizeof(own)) != 0) {
    return failed(what);
  }
  if (is_multicast(*address)) {
    const ip_mreq group{*address, *interface};
    if (setsockopt(fd_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof(group)) != 0) {
      return failed(what);
    }
  }
  return {};
}

FileStatus Source::open_serial() {
  const Pair parts = parted(spec_.where);
  const std::optional<int> baud = parts.second.empty() ? spec_.baud : whole_number(parts.second);
  const std::optional<speed_t> speed = baud ? speed_of(*baud) : std::nullopt;
  if (!speed) {
    return FileError{fmt::format("--serial {}: a baud of 4800, 9600, 19200, 38400, 57600 or 115200 is right",
                                 spec_.where)};
  }
  fd_ = ::open(parts.first.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  termios line{};
  if (fd_ < 0 || tcgetattr(fd_, &line) != 0) {
    const FileError error = failed("--serial " + parts.first);
    close();
    return error;
  }
  cfmakeraw(&line);  // 8 bits, no parity, no echo, no flow control
  line.c_cflag |= CLOCAL | CREAD;
  line.c_cc[VMIN] = 0;
  line.c_cc[VTIME] = 0;
  if (cfsetispeed(&line, *speed) != 0 || cfsetospeed(&line, *speed) != 0 ||
      tcsetattr(fd_, TCSANOW, &line) != 0) {
    const FileError error = failed("--serial " + parts.first);
    close();
    return error;
  }
  return {};
}

FileStatus Source::open_file() {
  fd_ = spec_.where == "-" ? dup(STDIN_FILENO) : ::open(spec_.where.c_str(), O_RDONLY | O_CLOEXEC);
  return fd_ < 0 ? FileStatus(failed("--file " + spec_.where)) : FileStatus();
}

}  // namespace quickstrip::nmea
