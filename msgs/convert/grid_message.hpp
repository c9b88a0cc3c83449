// QS_GRID from the swept grid: quantised, 24 bytes a cell. No heap; some 10 microseconds.
#pragma once

#include <cstdint>

#include "core/advice/advice.hpp"
#include "quickstrip/grid_t.hpp"

namespace quickstrip {

/// Fills all but utime, seq and source_id. Cells beyond the grid's counts are unknown and not computed.
void to_message(const Grid& grid, std::int64_t limits_digest, grid_t& out);

/// -1 for kNoCriterion or kNoSystem.
constexpr std::int16_t index_or_none(std::uint8_t index) {
  return index == kNoCriterion ? std::int16_t{-1} : std::int16_t{index};
}
static_assert(kNoCriterion == kNoSystem);

}  // namespace quickstrip
