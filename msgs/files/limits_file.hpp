// Reader of the limits file (TOML, *.limits.toml): a profile of criteria for a given hull.
//
//   schema = 1
//   name = "heavy work on deck"
//   [[criterion]]
//   name = "vertical acc. at {place}"     # {place}: the hull's name of it; without: " at NAME" where there
//                                         # are several
//   quantity = "vertical_acceleration"    # surge sway heave roll pitch yaw, longitudinal_, lateral_,
//                                         # vertical_acceleration, slamming, deck_wetness,
//                                         # propeller_emergence, motion_sickness, motion_interruptions
//   role = "deck"                         # at a point: every one of that role; a role that the hull has not:
//                                         # the criterion is kept, not watched, and no cell is good
//   # place = "crane"                     # or the one point, slamming station or freeboard point of that
//   name statistic = "rms"                     # rms, significant; slamming, deck_wetness,
//   propeller_emergence:
//                                         # probability, per_hour; motion_sickness: share_of_people;
//                                         # motion_interruptions: per_minute
//   limit_g = 0.15                        # limit_m, _deg, _g or _m_s2, _probability, _per_hour, _percent,
//                                         # _per_minute: the one that suits quantity and statistic
//   # limit_g_by_length = [[100, 0.275], [330, 0.05]]   # or by lpp [m]: linear between, constant beyond
//   caution_fraction = 0.75               # of the limit, default 0.75
//   # exposure_min = 240                  # motion_sickness: model of 1976; without: two hours, that of 1974
//   # stance_height_m = 1.2               # motion_interruptions: of the centre of gravity, default 1.2
//   # stance_half_width_ratio = 0.25      # half the distance of the feet by that height, default 0.25
//
// Slamming, deck wetness and propeller emergence without `place` are judged at every place that the hull has;
// motion_sickness without role or place where passengers are, motion_interruptions on deck.
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
