// QS_MOTION against core's MeasuredMotion. No heap.
#pragma once

#include "core/advice/step.hpp"
#include "msgs/convert/refusal.hpp"
#include "quickstrip/motion_t.hpp"

namespace quickstrip {

/// Checked as received_checks.hpp says. On refusal `out` is as it was.
Conversion to_measured_motion(const motion_t& message, MeasuredMotion& out);

}  // namespace quickstrip
