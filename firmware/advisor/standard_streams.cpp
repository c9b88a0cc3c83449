#include "firmware/advisor/standard_streams.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <csignal>
#include <cstring>

namespace quickstrip {

void hold_standard_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  int lowest = open("/dev/null", O_RDWR);  // the lowest that is free
  while (lowest >= 0 && lowest <= STDERR_FILENO) {
    lowest = open("/dev/null", O_RDWR);
  }
  if (lowest > STDERR_FILENO) {
    close(lowest);
  }
  struct stat what {};
  if (fstat(STDERR_FILENO, &what) == 0 && (S_ISFIFO(what.st_mode) || S_ISSOCK(what.st_mode))) {
    fcntl(STDERR_FILENO, F_SETFL, fcntl(STDERR_FILENO, F_GETFL) | O_NONBLOCK);
  }
}

bool write_line(std::string_view line) {
  constexpr int kPatience_ms = 100;
  std::array<char, PIPE_BUF> text{};
  const std::size_t size = std::min(line.size(), text.size() - 1);
  std::memcpy(text.data(), line.data(), size);
  text[size] = '\n';
  pollfd ready{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
  // A pipe is ready when PIPE_BUF bytes fit: what follows does not wait then.
  if (poll(&ready, 1, kPatience_ms) != 1 || (ready.revents & POLLOUT) == 0) {
    return false;
  }
  return write(STDERR_FILENO, text.data(), size + 1) == static_cast<ssize_t>(size + 1);
}

}  // namespace quickstrip
