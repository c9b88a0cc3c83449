// Deadlines that were missed since the journal was last told, and the one among them that the machine
// explains least: that which had most of the processor.
#pragma once

#include <algorithm>
#include <cstdint>

namespace quickstrip {

struct MissedDeadline {
  std::int64_t utime = 0;
  double period_s = 0.0;     // from when it was due, it had so long
  double late_s = 0.0;       // it began after it was due
  double took_s = 0.0;       // from its beginning to its end
  double processor_s = 0.0;  // its thread's share of that
  std::int64_t num_waits = 0;
};

class MissedDeadlines {
 public:
  void note(const MissedDeadline& missed) {
    if (num_ == 0 || missed.processor_s > worst_.processor_s) {
      worst_ = missed;
    }
    ++num_;
  }

  /// Whether there is something to tell: at once, then at most every kBetween_s.
  [[nodiscard]] bool is_due(double steady_s) const { return num_ > 0 && steady_s >= next_s_; }

  void note_told(double steady_s) {
    num_ = 0;
    next_s_ = steady_s + kBetween_s;
  }

  [[nodiscard]] int num() const { return num_; }
  [[nodiscard]] const MissedDeadline& worst() const { return worst_; }

 private:
  static constexpr double kBetween_s = 10.0;  // a machine that is too slow for its cycle would fill the disk
  MissedDeadline worst_;
  int num_ = 0;
  double next_s_ = 0.0;
};

}  // namespace quickstrip
