#include "core/hazard/roll_period_band.hpp"

#include <cmath>

#include "core/base/constants.hpp"
#include "core/hazard/zone_parameters.hpp"
#include "core/hull/imo_roll_period.hpp"

namespace quickstrip {

RollPeriodBand roll_period_band(const Hull& hull, const Loading& loading, const LoadedHull& loaded) {
  RollPeriodBand band;
  const double draught = 0.5 * (loading.draught_aft + loading.draught_fwd);
  const auto estimate = imo_roll_period(hull.lpp, hull.breadth, draught, loaded.hydrostatics.gm);
  band.is_code = estimate ? *estimate : 0.0;
  const double measured = loading.measured_roll_period.value_or(0.0);
  if (measured > 0.0 && std::isfinite(measured)) {
    band.source = RollPeriodSource::kMeasured;
    band.shortest = measured;
    band.longest = measured;
    return band;
  }
  const double computed = kTwoPi / loaded.roll_natural_frequency;
  if (!(computed > 0.0) || !std::isfinite(computed)) {
    return band;
  }
  band.source = RollPeriodSource::kComputed;
  band.shortest = (1.0 - zone::kRollPeriodError) * computed;
  band.longest = (1.0 + zone::kRollPeriodError) * computed;
  return band;
}

bool contradicts_is_code(const RollPeriodBand& band) {
  const double middle = 0.5 * (band.shortest + band.longest);
  return band.is_known() && band.is_code > 0.0 &&
         std::fabs(band.is_code - middle) > 2.0 * zone::kRollPeriodError * middle;
}

}  // namespace quickstrip
