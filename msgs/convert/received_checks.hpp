// Messages that are received, checked and counted, and that give core nothing (yet): measured motions, the
// replay's clock, acknowledgements of alerts. No heap, below a microsecond each.
#pragma once

#include "msgs/convert/refusal.hpp"
#include "quickstrip/alert_t.hpp"
#include "quickstrip/clock_t.hpp"
#include "quickstrip/motion_t.hpp"

namespace quickstrip {

Conversion check_motion(const motion_t& message);

/// A time between 1970 and 2200 and a rate of -1 (as fast as possible), 0 (halted) or more.
Conversion check_clock(const clock_t& message);

/// What it asks for is for Alerts to judge.
Conversion check_acknowledgement(const alert_t& message);

}  // namespace quickstrip
