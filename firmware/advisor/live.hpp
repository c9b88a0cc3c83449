// The live process: inbox, session, publisher, journal, and the clock that drives them. firmware/BOUNDARY.md
// has the picture.
//
// Threads: the inbox's receives and decodes; the cycle's takes what has come, lets the session cycle and puts
// its messages into the publisher's ring; the publisher's gives them to the bus; the journal's writes; the
// keeper's writes the last inputs to disk; the caller of run() watches: it samples what the process takes and
// tells the service manager. They meet in fixed buffers only. The cycle's thread, once it runs, allocates
// nothing, takes no lock, writes to no file or socket, and waits for nothing but its time.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <semaphore>
#include <string>
#include <thread>

#include "firmware/advisor/bus_outbox.hpp"
#include "firmware/advisor/inbox.hpp"
#include "firmware/advisor/journal.hpp"
#include "firmware/advisor/kept_inputs_file.hpp"
#include "firmware/advisor/missed_deadlines.hpp"
#include "firmware/advisor/process_watch.hpp"
#include "firmware/advisor/publisher.hpp"
#include "firmware/advisor/real_time.hpp"
#include "firmware/advisor/thread_usage.hpp"
#include "firmware/session/session.hpp"

namespace quickstrip {

struct LiveOptions {
  RealTime real_time = RealTime::kAuto;
  int priority =
      50;  // SCHED_FIFO: below the kernel's own threads where they are at 50, above everything else
};

class Live {
 public:
  /// `session` is configured. `keeper` may be null.
  Live(lcm::LCM& bus, const std::string& prefix, Session& session, const SessionOptions& options,
       InputKeeper* keeper);
  ~Live();

  /// Until `stop` is true; false when the bus has failed for good. `why_not` says what kept RealTime::kOn
  /// from starting, and is empty otherwise.
  bool run(const LiveOptions& options, const std::atomic<bool>& stop, std::string& why_not);

 private:
  const RealTimeResult& start_cycle_thread(const LiveOptions& options);
  void run_cycle_thread(const LiveOptions& options);
  void run_by_system_clock();
  void run_by_log_time();
  void take_inputs(std::int64_t now);
  ThreadUsage cycle(std::int64_t now);
  void note_times(double took_s);
  void tell_totals() const;
  template <typename Message>
  void count_lost(InboxSlot<Message>& slot, Input input);
  template <typename Message>
  void take(InboxSlot<Message>& slot, Input input, std::int64_t now);

  Session& session_;
  SessionOptions options_;
  InputKeeper* keeper_;
  Inbox inbox_;
  BusOutbox bus_;
  Publisher publisher_{bus_};
  JournalRing journal_ring_;
  Journal journal_{journal_ring_};
  JournalWriter journal_writer_{journal_ring_};
  ProcessWatch watch_;
  RunFigures figures_;
  std::array<double, 256> last_cycles_s_{};  // for the mean
  std::int64_t num_cycles_ = 0;
  MissedDeadlines missed_;
  ThreadUsage usage_;                   // of the cycle's thread, within cycles
  std::int64_t heap_calls_before_ = 0;  // the cycle's thread's, when its cycles began
  std::array<std::int64_t, kNumInputs> malformed_seen_{};
  std::array<std::int64_t, kNumInputs> foreign_seen_{};
  std::atomic<bool> is_stop_asked_{false};
  RealTimeResult scheduled_;
  std::binary_semaphore is_scheduled_{0};
  std::thread cycle_thread_;
};

}  // namespace quickstrip
