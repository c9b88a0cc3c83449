#include "sim/hull_tool/limits_option.hpp"

#include "core/advice/nordforsk.hpp"
#include "msgs/cli/run_tool.hpp"

namespace quickstrip::hull_tool {

void add_limits_option(CLI::App& command, std::string& limits) {
  command.add_option("--limits", limits,
                     "Limits file (firmware/profiles); default NORDFORSK 1987 for merchant ships");
}

LimitsProfile limits_of(const std::string& limits, const FloatingHull& ship) {
  LimitsProfile profile;
  if (!limits.empty()) {
    require(read_limits_file(limits, ship.hull, profile));
    return profile;
  }
  const Result<Criteria> criteria = nordforsk_merchant(ship.hull);
  if (!criteria) {
    throw InputError{ship.file + ": " + message(criteria.error())};
  }
  profile.name = Name("NORDFORSK 1987, merchant ships");
  profile.criteria = *criteria;
  return profile;
}

}  // namespace quickstrip::hull_tool
