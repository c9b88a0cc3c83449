// The last inputs on disk, so that a restart has them, aged. The file is an LCM log of one event a kind
// (quickstrip-sim inspect shows it), written beside and renamed. A thread of its own writes: at once when sea
// or loading are new, own ship every ten seconds; the cycle only hands over a copy.
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

FileStatus write_kept_inputs(const std::filesystem::path& path, const std::string& prefix,
                             const KeptInputs& kept);

/// Gives the session what the file holds, as restored at `now`; what is refused is left out. Without a file:
/// nothing, and no error. `num_restored` counts the kinds.
FileStatus restore_inputs(const std::filesystem::path& path, const std::string& prefix, std::int64_t now,
                          Session& session, int& num_restored);

class InputKeeper {
 public:
  InputKeeper(std::filesystem::path path, std::string prefix);
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
  TripleBuffer<KeptInputs> newest_;
  std::atomic<bool> is_running_{true};
  std::thread thread_;
};

}  // namespace quickstrip
