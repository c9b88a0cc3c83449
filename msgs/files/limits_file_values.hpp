// The numbers of one [[criterion]] of a limits file: quantity, statistic, limit, and what goes with them.
// Inside msgs/files; refusals are thrown as FileError.
#pragma once

#include "core/advice/criteria.hpp"
#include "msgs/files/toml_table.hpp"

namespace quickstrip {

/// All of a criterion but its name and its place; lpp [m] for limits that depend on the ship's length.
/// Refuses keys that no criterion has, and those that do not suit the quantity or the statistic.
Criterion read_values(const TomlTable& table, double lpp);

}  // namespace quickstrip
