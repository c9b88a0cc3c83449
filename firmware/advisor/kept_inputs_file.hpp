// The last inputs on disk, so that a restart has them, aged, and the limits last in force, so that a restart
// sees that they have been changed. The file is an LCM log of one event a kind
// (quickstrip-sim inspect shows it), written beside and renamed. A thread of its own writes: at the first
// cycle, at once when sea or loading are new, own ship every two seconds; the cycle only hands over a copy.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "firmware/advisor/triple_buffer.hpp"
#include "firmware/session/session.hpp"
#include "msgs/files/file_status.hpp"

namespace quickstrip {

/// Whether the file is as it was written: it ends with the digest of its events. True where there is none, or
/// an empty one. The status: it cannot be read, or is no such file at all.
FileStatus look_at_state(const std::filesystem::path& path, const std::string& prefix, bool& is_whole);

FileStatus write_kept_inputs(const std::filesystem::path& path, const std::string& prefix,
                             const KeptInputs& kept, const limits_t& limits);

/// Gives the session what the file holds, as restored at `now`; what is refused is left out. Without a file,
/// or with a damaged one: nothing, and no error. `num_restored` counts the kinds.
FileStatus restore_inputs(const std::filesystem::path& path, const std::string& prefix, std::int64_t now,
                          Session& session, int& num_restored);

/// The limits that the file holds; num_criteria 0 where it holds none, or there is no file.
FileStatus read_kept_limits(const std::filesystem::path& path, const std::string& prefix, limits_t& out);

class InputKeeper {
 public:
  /// `limits`: in force as long as the process runs.
  InputKeeper(std::filesystem::path path, std::string prefix, const limits_t& limits);
  ~InputKeeper();
  InputKeeper(const InputKeeper&) = delete;
  InputKeeper& operator=(const InputKeeper&) = delete;

  /// From the cycle's thread: 40 kB copied, no wait.
  void hand_over(const Inputs& inputs);
  /// The last failure has been worded on standard error; writing goes on being tried.
  void stop();

 private:
  void keep();

  std::filesystem::path path_;
  std::string prefix_;
  limits_t limits_;
  TripleBuffer<KeptInputs> newest_;
  std::atomic<bool> is_running_{true};
  std::thread thread_;
};

}  // namespace quickstrip
