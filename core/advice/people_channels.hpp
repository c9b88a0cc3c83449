// The channels that exist only where criteria ask for them: motion sickness and interruptions at a point.
// Every other channel follows from the hull alone (response/watch.hpp).
#pragma once

#include <cstddef>

#include "core/advice/criteria.hpp"
#include "core/base/result.hpp"
#include "core/response/watch.hpp"

namespace quickstrip {

/// That a criterion is judged by: to port and to starboard for interruptions, which stand side by side.
constexpr std::size_t num_channels(const Criterion& criterion) {
  return criterion.quantity == Quantity::kMotionInterruptions ? 2 : 1;
}

/// Appends, once a point and quantity, what the watched criteria need to a watch that list_channels filled.
/// Errors: kTooMany (more than kMaxPeopleChannels), kOutOfRange (a place without accelerations).
Status list_people_channels(const Criteria& criteria, Watch& watch);

}  // namespace quickstrip
