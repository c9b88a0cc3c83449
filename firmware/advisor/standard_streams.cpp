#include "firmware/advisor/standard_streams.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

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

}  // namespace quickstrip
