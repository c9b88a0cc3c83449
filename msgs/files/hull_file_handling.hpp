// The tables [handling] and [resistance] of a hull file, read and written: how the ship changes course and
// speed, and what it takes to drive her. Inside msgs/files refusals are thrown (toml_table.hpp).
#pragma once

#include <string>

#include "core/hull/hull.hpp"
#include "msgs/files/toml_table.hpp"

namespace quickstrip {

void read_handling(const TomlTable& root, Hull& hull);

/// Either speed_kn_force_n = [[10, 230000], ...], resistance in calm water, or speed_kn_brake_power_kw with
/// total_efficiency, which give it as R = eta P / V. At least two speeds; both columns increase.
void read_resistance(const TomlTable& root, Hull& hull);

/// Both tables; resistance as forces.
std::string handling_text(const Hull& hull);

}  // namespace quickstrip
