#include "msgs/files/ship_files.hpp"

#include "core/advice/nordforsk.hpp"
#include "msgs/files/hull_file.hpp"
#include "msgs/files/hull_table_file.hpp"
#include "msgs/files/limits_file.hpp"

namespace quickstrip {

FileStatus read_ship_files(const std::string& hull, const std::string& limits, ShipFiles& out) {
  if (FileStatus status = read_hull_file(hull, out.hull); !status) {
    return status;
  }
  if (!limits.empty()) {
    LimitsProfile profile;
    if (FileStatus status = read_limits_file(limits, out.hull, profile); !status) {
      return status;
    }
    out.criteria = profile.criteria;
    out.profile = profile.name;
    return {};
  }
  const Result<Criteria> criteria = nordforsk_merchant(out.hull);
  if (!criteria) {
    return FileError{hull + ": limits of NORDFORSK 1987: " + message(criteria.error())};
  }
  out.criteria = *criteria;
  out.profile = Name("NORDFORSK 1987, merchant ships");
  return {};
}

std::string refused_by_core(const std::string& hull, Error error) {
  if (error == Error::kHullTableNeeded) {
    return kHullTableWanted;
  }
  return hull + ": " + message(error) + "; `quickstrip-hull check " + hull +
         "` names the field and says what would be right";
}

}  // namespace quickstrip
