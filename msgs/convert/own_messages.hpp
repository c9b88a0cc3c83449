// The advisor's own messages, read back by displays, stories and pictures: out of a log that may be damaged,
// or off a bus where anybody sends. Every count and index within its array, every number finite. No heap.
#pragma once

#include "msgs/convert/refusal.hpp"
#include "quickstrip/advice_t.hpp"
#include "quickstrip/grid_t.hpp"
#include "quickstrip/limits_t.hpp"

namespace quickstrip {

Conversion check_advice(const advice_t& message);
Conversion check_grid(const grid_t& message);
Conversion check_limits(const limits_t& message);

}  // namespace quickstrip
