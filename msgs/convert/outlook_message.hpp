// QS_OUTLOOK from a step: how sure its advice is, what to expect, what each change brings. No heap.
#pragma once

#include <cstdint>

#include "core/advice/criteria.hpp"
#include "core/advice/step.hpp"
#include "quickstrip/outlook_t.hpp"

namespace quickstrip {

inline constexpr double kExpectAhead_s = 1800.0;  // the half hour that a bridge thinks ahead; ours

/// Fills all but the header (utime, seq, source_id, limits_digest). `assumed`: UncertaintyAssumption.
void to_message(const StepOutput& output, const Criteria& criteria, std::uint32_t assumed, outlook_t& out);

}  // namespace quickstrip
