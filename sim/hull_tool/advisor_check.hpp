// Will the advisor load this ship? Asked of the advisor itself, with its default criteria.
#pragma once

#include <cstdint>

#include "sim/hull_tool/floating_hull.hpp"

namespace quickstrip::hull_tool {

struct AdvisorFindings {
  double roll_period = 0.0;   // natural [s]
  std::uint32_t quality = 0;  // of the hull and its loading
};

/// Throws InputError with what the advisor refuses.
AdvisorFindings advisor_findings(const FloatingHull& ship);

/// The natural roll period that the advisor finds [s]. Throws InputError with what it refuses.
double advisor_roll_period(const FloatingHull& ship);

}  // namespace quickstrip::hull_tool
