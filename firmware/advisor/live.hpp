// The live process: inbox, session, outbox, and the clock that drives them.
//
// Threads: the inbox's receives and decodes; this one (run) cycles; the keeper's writes the last inputs to
// disk. They meet in triple buffers only. The cycle's thread allocates nothing of ours after start; what
// liblcm does inside publish, and standard error, are beyond the claim.
#pragma once

#include <atomic>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <string>

#include "firmware/advisor/bus_outbox.hpp"
#include "firmware/advisor/inbox.hpp"
#include "firmware/advisor/journal.hpp"
#include "firmware/advisor/kept_inputs_file.hpp"
#include "firmware/session/session.hpp"

namespace quickstrip {

class Live {
 public:
  /// `session` is configured. `keeper` may be null.
  Live(lcm::LCM& bus, const std::string& prefix, Session& session, const SessionOptions& options,
       InputKeeper* keeper);

  /// Until `stop` is true; false when the bus has failed for good.
  bool run(const std::atomic<bool>& stop);

 private:
  bool run_by_system_clock(const std::atomic<bool>& stop);
  bool run_by_log_time(const std::atomic<bool>& stop);
  void take_inputs(std::int64_t now);
  void cycle(std::int64_t now);
  template <typename Message>
  void count_lost(InboxSlot<Message>& slot, Input input);
  template <typename Message>
  void take(InboxSlot<Message>& slot, Input input, std::int64_t now);

  Session& session_;
  SessionOptions options_;
  InputKeeper* keeper_;
  Inbox inbox_;
  BusOutbox outbox_;
  Journal journal_;
  RunFigures figures_;
  std::array<double, 256> last_cycles_s_{};  // for the mean
  std::int64_t num_cycles_ = 0;
  std::array<std::int64_t, kNumInputs> malformed_seen_{};
};

}  // namespace quickstrip
