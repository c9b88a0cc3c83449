// QS_LIMITS from the criteria in force. No heap.
#pragma once

#include <string_view>

#include "core/advice/criteria.hpp"
#include "core/hull/hull.hpp"
#include "quickstrip/limits_t.hpp"

namespace quickstrip {

/// Name of the point, station or freeboard point that a quantity is taken at; "G" for the motions, "" for
/// kNowhere or an index that the hull has not.
std::string_view place_name(const Hull& hull, Quantity quantity, std::uint8_t place);

/// Fills all but utime, seq and source_id. The digest covers what the limits are, not when.
void to_message(const Criteria& criteria, const Hull& hull, std::string_view profile_name, limits_t& out);

}  // namespace quickstrip
