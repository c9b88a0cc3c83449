#include "tests/faults/running_advisor.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

namespace quickstrip::faults {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void nap() {
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> list;
  list.reserve(words.size() + 1);
  for (const std::string& word : words) {
    list.push_back(const_cast<char*>(word.c_str()));  // execve takes them so and leaves them alone
  }
  list.push_back(nullptr);
  return list;
}

/// In the child, between fork and exec.
[[noreturn]] void become(const std::vector<char*>& words, const std::vector<char*>& environment,
                         int journal_fd) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (journal_fd == Start::kClosed) {
    close(STDERR_FILENO);
  } else {
    dup2(journal_fd, STDERR_FILENO);
  }
  ::signal(SIGPIPE, SIG_DFL);  // as a shell and systemd leave it
  execve(words[0], words.data(), environment.data());
  _exit(127);
}

}  // namespace

RunningAdvisor::~RunningAdvisor() {
  if (is_running()) {
    kill_hard();
  }
}

bool RunningAdvisor::start(const Start& how) {
  std::vector<std::string> words{QUICKSTRIP_ADVISOR_PROGRAM};
  words.insert(words.end(), how.options.begin(), how.options.end());
  std::vector<std::string> environment;
  for (char** name = environ; *name != nullptr; ++name) {
    environment.emplace_back(*name);
  }
  environment.insert(environment.end(), how.environment.begin(), how.environment.end());
  const auto word_list = pointers(words);
  const auto environment_list = pointers(environment);
  const bool has_file = how.journal_fd == Start::kJournalFile;
  const int fd =
      has_file ? open(journal_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600) : how.journal_fd;
  ended_.reset();
  pid_ = fork();
  if (pid_ == 0) {
    become(word_list, environment_list, fd);
  }
  if (!has_file) {
    return true;
  }
  close(fd);
  while (is_running()) {
    if (journal().find("a cycle every") != std::string::npos) {
      return true;
    }
    nap();
  }
  return false;
}

void RunningAdvisor::signal(int number) const {
  kill(pid_, number);
}

void RunningAdvisor::kill_hard() {
  signal(SIGKILL);
  wait_for_end(60.0);
}

std::optional<int> RunningAdvisor::look() {
  if (pid_ > 0 && !ended_.has_value()) {
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_) {
      ended_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
  }
  return ended_;
}

std::optional<int> RunningAdvisor::wait_for_end(double patience_s) {
  const auto start = Clock::now();
  while (!look().has_value() && seconds_since(start) < patience_s) {
    nap();
  }
  return ended_;
}

bool RunningAdvisor::is_running() {
  return pid_ > 0 && !look().has_value();
}

std::string RunningAdvisor::journal() const {
  std::ifstream file(journal_, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace quickstrip::faults
