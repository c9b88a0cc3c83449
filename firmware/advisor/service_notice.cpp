#include "firmware/advisor/service_notice.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace quickstrip {
namespace {

/// Of a variable that holds a whole number; none otherwise.
std::optional<std::int64_t> number_in_environment(const char* name) {
  const char* const text = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): before threads start
  if (text == nullptr) {
    return std::nullopt;
  }
  std::int64_t value = 0;
  const char* const end = text + std::strlen(text);
  const auto [stopped, error] = std::from_chars(text, end, value);
  return error == std::errc() && stopped == end ? std::optional(value) : std::nullopt;
}

int connected_to(std::string_view path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() < 2 || path.size() >= sizeof(address.sun_path)) {
    return -1;
  }
  std::memcpy(address.sun_path, path.data(), path.size());
  if (path.front() == '@') {
    address.sun_path[0] = '\0';  // a name that is no file
  }
  const int fd = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size());
  if (fd >= 0 && connect(fd, reinterpret_cast<const sockaddr*>(&address), size) != 0) {
    close(fd);
    return -1;
  }
  return fd;
}

}  // namespace

ServiceNotice::ServiceNotice() {
  const char* const path = std::getenv("NOTIFY_SOCKET");  // NOLINT(concurrency-mt-unsafe)
  if (path == nullptr) {
    return;
  }
  socket_ = connected_to(path);
  const std::optional<std::int64_t> wanted_us = number_in_environment("WATCHDOG_USEC");
  const std::optional<std::int64_t> wanted_of = number_in_environment("WATCHDOG_PID");
  const bool is_ours = !wanted_of || *wanted_of == getpid();
  if (is_ours && wanted_us && *wanted_us > 0) {
    watchdog_period_ = std::chrono::microseconds(*wanted_us / 3);
  }
}

ServiceNotice::~ServiceNotice() {
  if (socket_ >= 0) {
    close(socket_);
  }
}

void ServiceNotice::tell(std::string_view line) const {
  if (socket_ >= 0) {
    static_cast<void>(send(socket_, line.data(), line.size(), MSG_DONTWAIT | MSG_NOSIGNAL));
  }
}

}  // namespace quickstrip
