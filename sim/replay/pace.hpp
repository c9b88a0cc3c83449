// Keeps log time from running ahead of the wall clock.
#pragma once

#include <chrono>
#include <cstdint>
#include <thread>

#include "msgs/convert/units.hpp"

namespace quickstrip {

class Pace {
 public:
  /// Log seconds a second; 0: as fast as possible.
  explicit Pace(double speed) : speed_(speed) {}
  void wait(std::int64_t now) {
    if (!(speed_ > 0.0)) {
      return;
    }
    first_ = first_ == 0 ? now : first_;
    const std::chrono::duration<double> offset(seconds_between(first_, now) / speed_);
    std::this_thread::sleep_until(start_ +
                                  std::chrono::duration_cast<std::chrono::steady_clock::duration>(offset));
  }

 private:
  double speed_;
  std::int64_t first_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace quickstrip
