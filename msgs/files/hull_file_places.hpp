// The parts of a hull file that say what is watched on the ship. Internal to the reader: refusals are thrown.
#pragma once

#include "core/hull/hull.hpp"
#include "msgs/files/toml_table.hpp"

namespace quickstrip {

/// Where things may stand: up to 0.2 lpp beyond the perpendiculars.
NumberRange along_the_ship(const Hull& hull);

/// [[point]], [[slamming]], [[freeboard]] and [propeller], after particulars, stations and loading are in
/// `hull`.
void read_places(const TomlTable& root, Hull& hull);

}  // namespace quickstrip
