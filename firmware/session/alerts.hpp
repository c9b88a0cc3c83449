// The alerts of the advisor, after the bridge alert management of IMO MSC.302(87).
//
// Of the ship's response:
//   alert 1  the present course and speed exceed a limit or lie in a zone whose warning holds: warning,
//            category A (the polar is needed to judge); near a limit or in a zone: caution, category A
//   alert 3  measured motion has differed from the predicted one for an hour or more: caution, category A
// Of the system:
//   alert 2  no advice, with the reason: warning, category B
//   alert 4  cycles take longer than their period: caution, category B
// Never alarm or emergency: advice is no safety function. A warning is active until it is acknowledged; if
// its cause ends before, it stays as rectified until then. A caution needs no acknowledgement. One cycle
// without advice while the hull is rebuilt for a new loading raises nothing, nor do the cycles in which
// inputs have not come yet after a start. `revision` counts every change; an acknowledgement of an older
// revision is ignored. Alert 1 follows the steady verdict
// (core/advice/steadiness.hpp), so it does not chatter. Not done: escalation of a warning that nobody
// acknowledges; that is the alert system's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "msgs/convert/refusal.hpp"
#include "quickstrip/advice_t.hpp"
#include "quickstrip/alert_t.hpp"
#include "quickstrip/comparison_t.hpp"

namespace quickstrip {

enum class AlertId : std::int32_t { kLimit = 1, kNoAdvice = 2, kMotionGap = 3, kLate = 4 };

class Alerts {
 public:
  static constexpr std::size_t kNumAlerts = 4;

  void configure(std::int16_t source_id, double grace_s);

  /// Sets the state of each alert from the advice of this cycle.
  void follow(const advice_t& advice);
  void follow(const comparison_t& comparison, std::int64_t now);
  /// `num_deadline_misses`: since the start.
  void follow_misses(std::int64_t num_deadline_misses, std::int64_t now);

  /// Acknowledged or silenced from the bridge. Not an error when the revision is old: ignored.
  Conversion accept(const alert_t& acknowledgement, std::int64_t now);

  /// The next alert to send at `now`: changed, or active and 10 s after it was sent last; nullptr: none left.
  const alert_t* next_to_send(std::int64_t now);

 private:
  static void raise(alert_t& alert, std::int8_t priority, std::int64_t now);
  static void clear(alert_t& alert, std::int64_t now);
  static void change(alert_t& alert, std::int8_t state, std::int64_t now);

  std::array<alert_t, kNumAlerts> alerts_{};
  std::array<std::int64_t, kNumAlerts> sent_utime_{};
  std::array<std::int32_t, kNumAlerts> sent_revision_{};
  std::int64_t first_utime_ = 0;  // of the first cycle
  std::int64_t num_misses_ = 0;
  std::int64_t last_miss_utime_ = 0;
  double grace_s_ = 0.0;
  std::int32_t seq_ = 0;
};

}  // namespace quickstrip
