// The criterion that comes next: the one nearest to its limit after the governing one, at any course and
// speed. A change that cures one criterion and leaves another at its limit is no good advice; the grid keeps
// the governing margin only.
//
// Cost: that of response_moments, once a change: tests/ranking prints it.
#pragma once

#include <cstdint>

#include "core/advice/advice.hpp"
#include "core/advice/grid.hpp"
#include "core/base/angles.hpp"
#include "core/base/result.hpp"

namespace quickstrip {

struct NextCriterion {
  std::uint8_t criterion = kNoCriterion;
  float margin = kNotComputed;  // factor on wave height
};

/// Ranked as the governing one is (verdict.hpp): cause for caution first, then the smallest margin. Any
/// heading; speed within the solved speeds. Errors: kSpeedOutOfGrid, kNotFinite, kTooMany.
Result<NextCriterion> next_criterion(const GridInputs& inputs, Heading heading, double speed,
                                     std::uint8_t governing);

}  // namespace quickstrip
