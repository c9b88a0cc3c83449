// When a replay runs a cycle: one per change of an input and one per cycle period of log time.
//
// A change: another sea or another loading (by its time of measurement), a course or speed that differs from
// the one of the last cycle by more than a degree or 0.2 kn. Messages that repeat what is known make no cycle
// of their own: ten days of own ship every ten seconds are one cycle per hour of sea, not 86,400.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/base/angles.hpp"
#include "firmware/session/inputs.hpp"
#include "msgs/convert/units.hpp"

namespace quickstrip {

class CycleTimes {
 public:
  explicit CycleTimes(double period_s) : period_s_(period_s) {}

  /// Before the events of `now` are taken: the times at which the period has run out since the last cycle,
  /// one a call; 0 when there is none before `now`.
  [[nodiscard]] std::int64_t due_before(std::int64_t now) const {
    if (last_ == 0) {
      return 0;
    }
    const std::int64_t next = last_ + static_cast<std::int64_t>(period_s_ * kMicrosecondsPerSecond);
    return next < now ? next : 0;
  }

  /// After the events of `now` were taken.
  [[nodiscard]] bool is_due(const Inputs& inputs, std::int64_t now) const {
    constexpr double kSlack_s = 1e-3;
    return last_ == 0 || seconds_between(last_, now) >= period_s_ - kSlack_s || has_changed(inputs);
  }

  void has_run(const Inputs& inputs, std::int64_t now) {
    last_ = now;
    sea_ = newest_sea(inputs);
    loading_ = inputs.used(Input::kLoading).utime;
    ship_ = inputs.ship().ship;
  }

 private:
  static std::int64_t newest_sea(const Inputs& inputs) {
    return std::max(inputs.used(Input::kSeaState).utime, inputs.used(Input::kWaveSpectrum).utime);
  }
  [[nodiscard]] bool has_changed(const Inputs& inputs) const {
    const OwnShip& ship = inputs.ship().ship;
    const double turned = std::abs(wrap_pi(ship.heading.radians - ship_.heading.radians));
    return newest_sea(inputs) != sea_ || inputs.used(Input::kLoading).utime != loading_ ||
           turned > radians(1.0) || std::abs(ship.speed - ship_.speed) > from_knots(0.2);
  }

  double period_s_;
  std::int64_t last_ = 0;
  std::int64_t sea_ = 0;
  std::int64_t loading_ = 0;
  OwnShip ship_;
};

}  // namespace quickstrip
