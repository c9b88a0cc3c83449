// Reader of the hull file (TOML, *.hull.toml): the ship, its default loading and what is watched on it, into
// SI units. Every number is finite and in its physical range; unknown keys are refused with the nearest known
// one named; stations may come in any order. What the file leaves out:
//   [[slamming]]   one station "bow" at 0.9 lpp, threshold velocity of [Ochi1964]
//   [[freeboard]]  "bow": the deck edge of the foremost station with offsets; none for a hull of minimal form
//   [[point]]      of role "fp": the forward perpendicular at that deck edge's height; none likewise
//   [handling]     min_steerage_kn = 3, turn_rate_deg_min = 30, slow_down_kn_min = 1, speed_up_kn_min = 0.5:
//   ours [resistance]   not known: no involuntary speed loss [grid]         0 ... 24 kn by 1 kn, every 5
//   degrees free_surface_correction_m, gm_m, measured_roll_period_s: not known (said on every output)
// Whether the ship floats upright at its draughts is core's to say (immerse, hydrostatics).
#pragma once

#include <filesystem>
#include <string_view>

#include "core/hull/hull.hpp"
#include "msgs/files/file_status.hpp"

namespace quickstrip {

/// On refusal `out` is as it was.
FileStatus read_hull_file(const std::filesystem::path& path, Hull& out);

/// The same from text; `file` is the name that refusals quote.
FileStatus parse_hull(std::string_view text, std::string_view file, Hull& out);

}  // namespace quickstrip
