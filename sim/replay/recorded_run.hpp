// Runs the very cycles that a live advisor ran, from a log that holds its advice beside its inputs
// (lcm-logger's, of QS_.*), and compares: each advice and grid byte for byte.
//
// A cycle for each recorded advice, at the advice's own utime, which is the clock that the live cycle saw,
// with the number that it had, and on the inputs that it names by source, seq and utime: a message that the
// logger heard before the advice but the cycle did not take is left for a later one. So it does not matter
// which clock drove the live process, nor when the logger was started: an advice that rests on an input from
// before the log cannot be repeated, and is counted apart. Numbers that go back are a restart.
// The hull file, its table, the limits and the method have to be those of the recorded run; its cycle period
// and its source id are taken from the advice.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "firmware/session/session.hpp"
#include "msgs/files/file_status.hpp"
#include "msgs/files/lcm_log.hpp"
#include "sim/replay/replay.hpp"

namespace quickstrip {

/// What the first advice of a log says of the advisor that gave it.
struct RecordedAdvisor {
  bool has_advice = false;
  double cycle_period_s = 0.0;
  std::int16_t source_id = 0;
};

FileStatus find_recorded_advisor(const std::vector<std::filesystem::path>& paths, const std::string& prefix,
                                 RecordedAdvisor& out);

struct RecordedFigures {
  std::uint64_t num_advice = 0;
  std::uint64_t num_same_advice = 0;
  std::uint64_t num_beyond_log = 0;  // on inputs from before the log: not repeated
  std::uint64_t num_grids = 0;       // of the advice that was repeated
  std::uint64_t num_same_grids = 0;
  std::string first_difference;  // one line; empty: none
};

/// As replay_log(), whose figures it fills too. `configure` brings the session to its start: called once, and
/// after each restart of the recorded advisor.
FileStatus replay_recorded_run(LcmLogReader& log, Session& session, const ReplayOptions& options,
                               const std::function<Status()>& configure, LcmLogWriter* log_out,
                               const std::function<void(std::int64_t now)>& after_cycle,
                               ReplayFigures& figures, RecordedFigures& recorded);

}  // namespace quickstrip
