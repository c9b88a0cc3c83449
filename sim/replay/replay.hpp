// Replays a log through the session that the live process runs, at the log's time, never the wall clock's.
// The same log, hull and options give the same bytes and digests.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "firmware/session/session.hpp"
#include "msgs/files/file_status.hpp"
#include "msgs/files/lcm_log.hpp"

namespace quickstrip {

struct ReplayOptions {
  std::string prefix = "QS_";
  double cycle_period_s = 3600.0;  // of log time; besides, every change of an input makes a cycle
  double speed = 0.0;              // log seconds a second; 0: as fast as possible
};

struct ReplayFigures {
  std::uint64_t num_events = 0;
  std::uint64_t num_cycles = 0;
  std::uint64_t num_without_advice = 0;
  std::uint64_t num_refused = 0;
  std::uint64_t num_unknown = 0;
  std::uint64_t num_faults = 0;        // damaged places of the log
  std::string first_fault;             // "FILE: offset ...", empty without one
  std::uint64_t num_out_of_time = 0;   // EventStream
  std::uint64_t num_out_of_order = 0;  // EventStream
  std::uint64_t num_gaps = 0;          // of more than two days: the cycles after those are left out
  std::map<std::string, std::uint64_t> unknown_channels;
  double computing_s = 0.0;  // in cycles
  double slowest_cycle_s = 0.0;
};

/// `session` is configured. `log_out`, when not null, gets the inputs as they were and what the session
/// sends, at log time. `after_cycle` sees each cycle's result.
FileStatus replay_log(LcmLogReader& log, Session& session, const ReplayOptions& options,
                      LcmLogWriter* log_out, const std::function<void(std::int64_t now)>& after_cycle,
                      ReplayFigures& figures);

/// What was passed over or is doubtful in the log, a line each; empty when all is well.
std::string remarks(const ReplayFigures& figures);

}  // namespace quickstrip
