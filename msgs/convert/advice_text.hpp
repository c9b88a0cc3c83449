// The sentences of the advice, in English for the bridge. No heap: written in place, cut between characters
// where a field ends. A figure never stands without its limit.
#pragma once

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "msgs/convert/change_text.hpp"
#include "msgs/convert/refusal.hpp"
#include "msgs/convert/text.hpp"
#include "msgs/convert/why_text.hpp"

namespace quickstrip {

/// What a "no advice" sentence may need besides its reason.
struct NoAdviceDetail {
  double age_s = 0.0;                // stale: of the input
  double limit_s = 0.0;              // stale: the limit of its age
  Refusal refusal = Refusal::kNone;  // implausible: why
  const char* field = "";            // implausible: which field
  double speed = 0.0;                // outside the grid [m/s]
  double grid_from = 0.0;            // m/s
  double grid_to = 0.0;              // m/s
  const char* self_test = "";        // self-test: what failed
};

/// "No advice, because the sea state is 2 h 10 min old (limit 90 min)"
void add_no_advice(NoAdvice reason, const NoAdviceDetail& detail, Sentence& out);

/// "12 s", "90 min", "2 h 10 min", "3 d 4 h"
void add_duration(double seconds, Sentence& out);

/// "slamming at bow 4.1 % of encounters (38/h), limit 2.2 %"
void add_criterion(const Criterion& criterion, double value, const Cell& cell, Sentence& out);

/// "slamming at bow 1.1 %, limit 2.2 %"
void add_value_and_limit(const Criterion& criterion, double value, Sentence& out);

/// "12 kn", "12.4 kn"
void add_speed(double metres_per_second, Sentence& out);

/// 0 ... 359: 360 after rounding is north.
double whole_degrees(double heading);

/// "Slamming at bow 4.1 % of encounters (38/h), limit 2.2 %; waves would have to fall by 20 %; swell of 12 s
/// from 240°: reduce to 12 kn, or come 20° to port". Of the cycle's own verdict; while the steady one waits,
/// that is said.
void add_reasons(const Advice& advice, const Criteria& criteria, WaveSystems systems, Sentence& out);

}  // namespace quickstrip
