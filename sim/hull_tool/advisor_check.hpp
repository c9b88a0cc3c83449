// Will the advisor load this ship? Asked of the advisor itself, with its default criteria.
#pragma once

#include "sim/hull_tool/floating_hull.hpp"

namespace quickstrip::hull_tool {

/// The natural roll period that the advisor finds [s]. Throws InputError with what it refuses.
double advisor_roll_period(const FloatingHull& ship);

}  // namespace quickstrip::hull_tool
