#include "core/advice/criteria.hpp"

#include <algorithm>
#include <cmath>

namespace quickstrip {
namespace {

std::size_t num_places(Quantity quantity, const Hull& hull) {
  if (quantity <= Quantity::kYaw) {
    return 1;  // of G
  }
  if (quantity == Quantity::kSlamming) {
    return hull.slamming.size();
  }
  if (quantity == Quantity::kPropellerEmergence) {
    return hull.propeller ? 1 : 0;
  }
  return quantity == Quantity::kDeckWetness ? hull.freeboard.size() : hull.points.size();
}

bool statistic_suits(const Criterion& criterion) {
  const bool counts_events =
      criterion.statistic == Statistic::kProbability || criterion.statistic == Statistic::kPerHour;
  return counts_events == is_event(criterion.quantity);
}

Status check_one(const Criterion& criterion, const Hull& hull) {
  if (!std::isfinite(criterion.limit) || !std::isfinite(criterion.caution_fraction)) {
    return Error::kNotFinite;
  }
  const bool sound = criterion.limit > 0.0 &&
                     (criterion.statistic != Statistic::kProbability || criterion.limit < 1.0) &&
                     criterion.caution_fraction > 0.0 && criterion.caution_fraction <= 1.0 &&
                     criterion.quantity <= kLastWatched && statistic_suits(criterion) &&
                     (!criterion.is_watched() || criterion.place < num_places(criterion.quantity, hull));
  return sound ? Status() : Status(Error::kOutOfRange);
}

}  // namespace

Status check_criteria(const Criteria& criteria, const Hull& hull) {
  for (const Criterion& criterion : criteria) {
    if (const Status status = check_one(criterion, hull); !status) {
      return status;
    }
  }
  return {};
}

}  // namespace quickstrip
