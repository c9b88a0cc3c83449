#include "tests/cortex_m7/serial_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>

#include "core/base/check.hpp"
#include "firmware/cortex-m7/serial/channels.hpp"

namespace quickstrip::test {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void become(const std::vector<std::string>& command, int in, int out) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // the emulator does not end with its input
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  std::vector<char*> arguments;
  for (const std::string& argument : command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

}  // namespace

SerialProcess::SerialProcess(const std::vector<std::string>& command) {
  std::array<int, 2> in{};
  std::array<int, 2> out{};
  QS_CHECK(pipe2(in.data(), O_CLOEXEC) == 0 && pipe2(out.data(), O_CLOEXEC) == 0);
  signal(SIGPIPE, SIG_IGN);
  pid_ = fork();
  QS_CHECK(pid_ >= 0);
  if (pid_ == 0) {
    become(command, in[0], out[1]);
  }
  close(in[0]);
  close(out[1]);
  to_ = in[1];
  from_ = out[0];
}

SerialProcess::~SerialProcess() {
  close(to_);
  close(from_);
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void SerialProcess::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(to_, bytes.data(), bytes.size());
    if (written <= 0) {
      return;  // it has ended: the answer will be missing
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

Answer SerialProcess::read_answer(double most_s) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(most_s);
  Answer answer;
  for (;;) {
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      if (decoder_.take(waiting_[i]) != FrameDecoder::Event::kFrame) {
        continue;
      }
      const Frame frame = decoder_.frame();
      answer[frame.channel].assign(frame.data.begin(), frame.data.end());
      if (SerialChannel{frame.channel} == SerialChannel::kLineReport) {
        waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(i + 1));
        return answer;
      }
    }
    waiting_.resize(4096);
    pollfd ready{from_, POLLIN, 0};
    const bool has_come = poll(&ready, 1, 100) > 0;
    const ssize_t num = has_come ? read(from_, waiting_.data(), waiting_.size()) : 0;
    waiting_.resize(num > 0 ? static_cast<std::size_t>(num) : 0);
    if ((has_come && num <= 0) || Clock::now() > deadline) {
      return answer;
    }
  }
}

}  // namespace quickstrip::test
