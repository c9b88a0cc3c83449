// What has been changed between two sets of limits, in one sentence for the logbook. No heap.
#pragma once

#include "msgs/convert/text.hpp"
#include "quickstrip/limits_t.hpp"

namespace quickstrip {

/// "NORDFORSK 1987, merchant ships" -> "ours": roll 6 -> 4; without slamming at bow; new: pitch. Criteria are
/// told apart by their names; units are those of limits_t. num_criteria of both are within the arrays.
void add_limits_difference(const limits_t& before, const limits_t& now, Sentence& out);

}  // namespace quickstrip
