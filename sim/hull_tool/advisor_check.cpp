#include "sim/hull_tool/advisor_check.hpp"

#include <memory>

#include "core/advice/nordforsk.hpp"
#include "core/advisor.hpp"
#include "msgs/cli/run_tool.hpp"

namespace quickstrip::hull_tool {

AdvisorFindings advisor_findings(const FloatingHull& ship) {
  const auto advisor = std::make_unique<Advisor>();
  const Result<Criteria> criteria = nordforsk_merchant(ship.hull);
  const Status configured =
      criteria ? advisor->configure(ship.hull, *criteria, StripMethod{}) : Status(criteria.error());
  if (!configured) {
    throw InputError{explain(configured.error(), ship, {})};
  }
  return {kTwoPi / advisor->loading_summary().roll_natural_frequency, advisor->hull_quality()};
}

double advisor_roll_period(const FloatingHull& ship) {
  return advisor_findings(ship).roll_period;
}

}  // namespace quickstrip::hull_tool
