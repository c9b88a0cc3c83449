// Sends the inputs of a log to a running advisor (`--clock log`), with the log's time on QS_TIME, and records
// what it answers.
//
// In lockstep (speed 0): the same cycle times as a replay in one process; after each QS_TIME it waits for the
// QS_RESPONSE of that time, the last message of a cycle, so that nothing is lost and the result is the same
// on a fast and on a slow machine. Paced (speed > 0): does not wait.
#pragma once

#include <cstdint>
#include <string>

#include "msgs/files/file_status.hpp"
#include "msgs/files/lcm_log.hpp"

namespace quickstrip {

struct PublishOptions {
  std::string url = "udpm://239.255.76.67:7667?ttl=0";
  std::string prefix = "QS_";
  double cycle_period_s = 3600.0;
  double speed = 0.0;      // log seconds a second; 0: in lockstep
  double answer_s = 60.0;  // lockstep: how long the first answer may take; later ones a tenth of it
};

struct PublishFigures {
  std::uint64_t num_sent = 0;
  std::uint64_t num_cycles = 0;
  std::uint64_t num_answers = 0;  // messages received
};

/// `record`, when not null, gets the inputs and the answers at log time.
FileStatus publish_log(LcmLogReader& log, const PublishOptions& options, LcmLogWriter* record,
                       PublishFigures& figures);

}  // namespace quickstrip
