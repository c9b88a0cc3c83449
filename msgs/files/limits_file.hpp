// Reader of the limits file (TOML, *.limits.toml): a profile of criteria for a given hull.
//
//   schema = 1
//   name = "heavy work on deck"
//   [[criterion]]
//   name = "vertical acc."                # of several places: "vertical acc. at NAME"
//   quantity = "vertical_acceleration"    # surge sway heave roll pitch yaw, longitudinal_, lateral_,
//                                         # vertical_acceleration, slamming, deck_wetness
//   role = "deck"                         # accelerations: every point of that role; a role that the hull has
//                                         # not: the criterion is kept, not watched, and no cell is good
//   # place = "crane"                     # or the one point, slamming station or freeboard point of that
//   name statistic = "rms"                     # rms, significant; slamming and deck_wetness: probability,
//   per_hour limit_g = 0.15                        # limit_m, limit_deg, limit_g or limit_m_s2,
//   limit_probability,
//                                         # limit_per_hour: the one that suits quantity and statistic
//   caution_fraction = 0.75               # of the limit, default 0.75
//
// Slamming and deck wetness without `place` are judged at every station or point that the hull has.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/advice/criteria.hpp"
#include "core/hull/hull.hpp"
#include "msgs/files/file_status.hpp"

namespace quickstrip {

struct LimitsProfile {
  Name name;
  Criteria criteria;
};

/// On refusal `out` is as it was.
FileStatus read_limits_file(const std::filesystem::path& path, const Hull& hull, LimitsProfile& out);

/// The same from text; `file` is the name that refusals quote.
FileStatus parse_limits(std::string_view text, std::string_view file, const Hull& hull, LimitsProfile& out);

}  // namespace quickstrip
