// A number that tells one hull's geometry from another's: length and every station, not what is loaded or
// watched on it.
#pragma once

#include <cstdint>

#include "core/hull/hull.hpp"

namespace quickstrip {

/// Of lpp, and of each station x and offsets (or breadth, draught, area), exactly as read. Cost: some 10 us.
std::uint64_t geometry_digest(const Hull& hull);

}  // namespace quickstrip
