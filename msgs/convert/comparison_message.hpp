// QS_COMPARISON from core's comparison of predicted and measured motion. No heap.
#pragma once

#include "core/advice/comparison.hpp"
#include "core/hull/hull.hpp"
#include "quickstrip/comparison_t.hpp"

namespace quickstrip {

/// Fills lines, texts, confidence and what predictions cover; the header and the window are the caller's.
void to_message(const Comparison& comparison, const Hull& hull, double window_s, comparison_t& out);

}  // namespace quickstrip
