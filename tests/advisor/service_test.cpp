// What the service manager hears, at a socket of ours in its place; and a journal that nobody reads.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

#include "firmware/advisor/process_watch.hpp"
#include "firmware/advisor/standard_streams.hpp"

namespace quickstrip::test {
namespace {

class Manager {
 public:
  explicit Manager(const char* watchdog_usec) {
    path_ = std::filesystem::temp_directory_path() / ("quickstrip_notify_" + std::to_string(getpid()));
    std::filesystem::remove(path_);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path_.c_str(), sizeof(address.sun_path) - 1);
    socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0);
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    setenv("NOTIFY_SOCKET", path_.c_str(), 1);
    setenv("WATCHDOG_USEC", watchdog_usec, 1);
  }
  ~Manager() {
    unsetenv("NOTIFY_SOCKET");
    unsetenv("WATCHDOG_USEC");
    close(socket_);
    std::filesystem::remove(path_);
  }
  Manager(const Manager&) = delete;
  Manager& operator=(const Manager&) = delete;

  /// What has come since, joined by '|'.
  std::string heard() {
    std::string all;
    char text[256];
    for (ssize_t size = recv(socket_, text, sizeof(text), 0); size > 0;
         size = recv(socket_, text, sizeof(text), 0)) {
      all += (all.empty() ? "" : "|") + std::string(text, static_cast<std::size_t>(size));
    }
    return all;
  }

 private:
  std::filesystem::path path_;
  int socket_ = -1;
};

TEST(ServiceManager, HearsReadyThenAliveAsLongAsTheCyclesThreadGoesOn) {
  Manager manager("3000");  // asks for a sign of life each 3 ms: one a millisecond
  ProcessWatch watch;
  watch.tell();
  EXPECT_EQ(manager.heard(), "");  // the cycle's thread does not run yet
  watch.note_alive();
  watch.tell();
  EXPECT_EQ(manager.heard(), "READY=1\nWATCHDOG=1");
  watch.note_alive();
  watch.note_cycle(0, 2);
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  watch.tell();
  EXPECT_EQ(manager.heard(), "WATCHDOG=1|STATUS=advice: caution");
}

TEST(ServiceManager, HearsNothingOnceTheCyclesThreadStandsStill) {
  Manager manager("3000");
  ProcessWatch watch;
  watch.note_alive();
  watch.tell();
  ASSERT_NE(manager.heard(), "");
  for (int i = 0; i < 5; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    watch.tell();
  }
  EXPECT_EQ(manager.heard(), "");
  watch.tell_stopping();
  EXPECT_EQ(manager.heard(), "STOPPING=1");
}

TEST(ServiceManager, WithoutOneNothingIsSaidAndNothingFails) {
  ProcessWatch watch;
  watch.note_alive();
  watch.tell();
  watch.tell_stopping();
  watch.sample();
  EXPECT_GT(watch.page_faults(), 0);
  EXPECT_GT(watch.resident_bytes(), 1'000'000);
}

/// Standard error is a pipe that is full.
TEST(JournalLine, IsLostAndNotWaitedForWhenNobodyReads) {
  int ends[2] = {-1, -1};
  ASSERT_EQ(pipe2(ends, O_NONBLOCK), 0);
  const std::string block(4096, 'x');
  while (write(ends[1], block.data(), block.size()) > 0) {
  }
  ASSERT_EQ(fcntl(ends[1], F_SETFL, 0), 0);  // from here on a plain write would wait
  const int kept = dup(STDERR_FILENO);
  ASSERT_EQ(dup2(ends[1], STDERR_FILENO), STDERR_FILENO);
  const bool is_written = write_line("a line");
  ASSERT_EQ(dup2(kept, STDERR_FILENO), STDERR_FILENO);
  EXPECT_FALSE(is_written);
  for (const int fd : {ends[0], ends[1], kept}) {
    close(fd);
  }
}

}  // namespace
}  // namespace quickstrip::test
