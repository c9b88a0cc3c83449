// The advisor as a process of its own: started, signalled, its journal read. Ends with this object, and with
// the test if that dies.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quickstrip::faults {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr double kPatience = 10.0;  // factor on every wait: sanitizers are slow
#else
inline constexpr double kPatience = 2.0;  // a machine that is busy with other tests
#endif

struct Start {
  std::vector<std::string> options;
  std::vector<std::string> environment;  // NAME=VALUE, beside this process's own
  int journal_fd = kJournalFile;         // what standard error is

  static constexpr int kJournalFile = -1;  // a file, which journal() reads
  static constexpr int kClosed = -2;
};

class RunningAdvisor {
 public:
  explicit RunningAdvisor(const std::filesystem::path& folder) : journal_(folder / "journal") {}
  ~RunningAdvisor();
  RunningAdvisor(const RunningAdvisor&) = delete;
  RunningAdvisor& operator=(const RunningAdvisor&) = delete;

  /// Returns when it is on the bus, if its journal is a file; at once otherwise. False: it ended before.
  bool start(const Start& how);
  void signal(int number) const;
  /// -9, and waits for the end.
  void kill_hard();
  /// As the shell would say it: 128 + N after a signal. Empty: still running after `patience_s`.
  std::optional<int> wait_for_end(double patience_s);
  [[nodiscard]] bool is_running();
  [[nodiscard]] std::string journal() const;
  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  [[nodiscard]] std::optional<int> look();

  std::filesystem::path journal_;
  pid_t pid_ = -1;
  std::optional<int> ended_;
};

}  // namespace quickstrip::faults
