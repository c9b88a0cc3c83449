// What an architect should know before trusting a hull file that is formally right.
#pragma once

#include <string>
#include <vector>

#include "sim/hull_tool/floating_hull.hpp"

namespace quickstrip::hull_tool {

/// Doubtful figures of form and loading, one sentence each.
std::vector<std::string> warnings_of(const FloatingHull& ship);

/// What the advisor will not watch with this file, and the table that would change it.
std::vector<std::string> unwatched_of(const FloatingHull& ship);

}  // namespace quickstrip::hull_tool
