// The parts of a hull file that say what is watched on the ship. Internal to the reader: refusals are thrown.
#pragma once

#include "core/hull/hull.hpp"
#include "msgs/files/toml_table.hpp"

namespace quickstrip {

/// Where stations may stand: up to 0.2 lpp beyond the perpendiculars.
NumberRange along_the_ship(const Hull& hull);

/// Where places may be: up to 0.05 lpp beyond the stations and the perpendiculars (a raking stem), 0.1 B
/// beyond the side (a bridge wing), and as high above the base line as the ship is long, at most 150 m.
NumberRange on_the_ship(const Hull& hull);
NumberRange across_the_ship(const Hull& hull);
NumberRange above_the_base(const Hull& hull);

/// [[point]], [[slamming]], [[freeboard]] and [propeller], after particulars, stations and loading are in
/// `hull`.
void read_places(const TomlTable& root, Hull& hull);

}  // namespace quickstrip
