#include "sim/replay/event_stream.hpp"

#include <utility>

#include "msgs/convert/units.hpp"

namespace quickstrip {
namespace {

constexpr double kLeap_s = 600.0;  // no sender's clock and no queue is so far out

bool is_leap(std::int64_t from, std::int64_t to) {
  return seconds_between(from, to) > kLeap_s;
}

}  // namespace

EventStream::EventStream(LcmLogReader& log) : log_(log), has_ahead_(read_ahead()) {}

bool EventStream::read_ahead() {
  while (log_.next(ahead_)) {  // each turn goes forward in the file
    if (is_time(ahead_.utime)) {
      return true;
    }
    ++num_out_of_time_;
  }
  return false;
}

bool EventStream::next(LogEvent& event) {
  while (has_ahead_) {  // each turn goes forward in the file
    std::swap(event, ahead_);
    has_ahead_ = read_ahead();
    const bool leaps = last_ == 0 || is_leap(last_, event.utime);
    if (leaps && has_ahead_ && is_leap(ahead_.utime, event.utime)) {  // and what follows falls back
      ++num_out_of_time_;
      continue;
    }
    if (event.utime < last_) {
      ++num_out_of_order_;
      event.utime = last_;
    }
    last_ = event.utime;
    return true;
  }
  return false;
}

}  // namespace quickstrip
