// The events of a log as a replay can use them: with times that are times and never go backwards. A log that
// was cut, joined or damaged has others: one wrong bit in a time of reception is a leap of years, and all
// that follows would seem to come at once, or a cycle a second be run for each of those years.
#pragma once

#include <cstdint>

#include "msgs/files/lcm_log.hpp"

namespace quickstrip {

class EventStream {
 public:
  explicit EventStream(LcmLogReader& log);

  /// False at the end. The event's time is never before that of the event before.
  bool next(LogEvent& event);

  /// Passed over: not between 1970 and 2200, or more than ten minutes ahead of both its neighbours.
  [[nodiscard]] std::uint64_t num_out_of_time() const { return num_out_of_time_; }
  /// Before the event before it, and taken at that one's time.
  [[nodiscard]] std::uint64_t num_out_of_order() const { return num_out_of_order_; }

 private:
  bool read_ahead();

  LcmLogReader& log_;
  LogEvent ahead_;
  bool has_ahead_ = false;
  std::int64_t last_ = 0;
  std::uint64_t num_out_of_time_ = 0;
  std::uint64_t num_out_of_order_ = 0;
};

}  // namespace quickstrip
