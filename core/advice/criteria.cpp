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

bool is_sound(const Stance& stance) {
  return stance.height > 0.0 && stance.height < 3.0 && stance.half_width_ratio > 0.0 &&
         stance.half_width_ratio < 1.0;
}

bool is_share(Statistic statistic) {
  return statistic == Statistic::kProbability || statistic == Statistic::kShareOfPeople;
}

// A channel has one stance: two criteria of one place must agree.
bool stances_agree(const Criterion& a, const Criterion& b) {
  return a.quantity != Quantity::kMotionInterruptions || !a.is_watched() || b.quantity != a.quantity ||
         a.place != b.place || a.stance == b.stance;
}

Status check_one(const Criterion& criterion, const Hull& hull) {
  if (!std::isfinite(criterion.limit) || !std::isfinite(criterion.caution_fraction)) {
    return Error::kNotFinite;
  }
  constexpr double kShortestExposure = 300.0;  // s
  constexpr double kLongestExposure = 86'400.0;
  const bool has_exposure = criterion.exposure == 0.0 || (criterion.exposure >= kShortestExposure &&
                                                          criterion.exposure <= kLongestExposure);
  const bool sound = criterion.limit > 0.0 && (!is_share(criterion.statistic) || criterion.limit < 1.0) &&
                     criterion.caution_fraction > 0.0 && criterion.caution_fraction <= 1.0 &&
                     criterion.quantity <= kLastWatched && suits(criterion.statistic, criterion.quantity) &&
                     has_exposure && is_sound(criterion.stance) &&
                     (!criterion.is_watched() || criterion.place < num_places(criterion.quantity, hull));
  return sound ? Status() : Status(Error::kOutOfRange);
}

}  // namespace

bool suits(Statistic statistic, Quantity quantity) {
  switch (statistic) {
    case Statistic::kRms:
    case Statistic::kSignificant:
      return quantity <= Quantity::kVerticalAcceleration;
    case Statistic::kProbability:
    case Statistic::kPerHour:
      return is_event(quantity);
    case Statistic::kShareOfPeople:
      return quantity == Quantity::kMotionSickness;
    case Statistic::kPerMinute:
      return quantity == Quantity::kMotionInterruptions;
  }
  return false;
}

Status check_criteria(const Criteria& criteria, const Hull& hull) {
  for (const Criterion& criterion : criteria) {
    if (const Status status = check_one(criterion, hull); !status) {
      return status;
    }
    for (const Criterion& other : criteria) {
      if (!stances_agree(criterion, other)) {
        return Error::kOutOfRange;
      }
    }
  }
  return {};
}

}  // namespace quickstrip
