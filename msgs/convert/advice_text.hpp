// The sentences of the advice, in English for the bridge. No heap: written in place, cut between characters
// where a field ends. A figure never stands without its limit.
#pragma once

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "msgs/convert/refusal.hpp"
#include "msgs/convert/text.hpp"

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
};

/// "No advice, because the sea state is 2 h 10 min old (limit 90 min)"
void add_no_advice(NoAdvice reason, const NoAdviceDetail& detail, Sentence& out);

/// "12 s", "90 min", "2 h 10 min", "3 d 4 h"
void add_duration(double seconds, Sentence& out);

/// "slamming at bow 4.1 % of encounters (38/h), limit 2.2 %"
void add_criterion(const Criterion& criterion, double value, const Cell& cell, Sentence& out);

/// "come 20° to port and reduce to 12 kn"
void add_action(const Change& change, Sentence& out);

/// "Come 20° to port (250°): good. Slamming at bow 1.1 % of encounters (9/h), limit 2.2 %"; `cell` of the
/// grid at the change, or null when it is not a cell.
void add_change(const Change& change, const Cell* cell, const Criteria& criteria, Sentence& out);

/// "Slamming at bow 4.1 % of encounters (38/h), limit 2.2 %: reduce to 12 kn, or come 20° to port"
void add_reasons(const Advice& advice, const Criteria& criteria, Sentence& out);

}  // namespace quickstrip
