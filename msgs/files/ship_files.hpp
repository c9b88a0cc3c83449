// What an advisor is configured from, out of files: the hull, and the limits for it.
#pragma once

#include <string>

#include "core/advice/criteria.hpp"
#include "core/base/result.hpp"
#include "core/hull/hull.hpp"
#include "msgs/files/file_status.hpp"

namespace quickstrip {

/// 0.2 MB: not on the stack.
struct ShipFiles {
  Hull hull;
  Criteria criteria;
  Name profile;
};

/// `limits`: a limits file; empty: NORDFORSK 1987 for merchant ships.
FileStatus read_ship_files(const std::string& hull, const std::string& limits, ShipFiles& out);

/// The line for a hull file that reads well and that core refuses all the same; points to the tool that
/// explains it.
std::string refused_by_core(const std::string& hull, Error error);

}  // namespace quickstrip
