// Reader of the voyage file (TOML, *.voyage.toml): what the ship steers, for logs made ashore.
//
//   schema = 1
//   name = "Off Cape Canaveral"
//   end_utc = 2019-09-09T00:00:00Z          # the last leg's end
//   [[leg]]                                 # in order of time; each holds until the next begins
//   from_utc = 2019-08-30T00:00:00Z
//   heading_deg = 150.0                     # true, [0, 360)
//   speed_kn = 15.0                         # through the water, 0 ... 60
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/angles.hpp"
#include "msgs/files/file_status.hpp"

namespace quickstrip {

struct VoyageLeg {
  std::int64_t from_utime = 0;  // microseconds since the epoch
  Heading heading;
  double speed = 0.0;  // through the water [m/s]
};

struct Voyage {
  std::string name;
  std::vector<VoyageLeg> legs;  // increasing from_utime
  std::int64_t end_utime = 0;
};

/// On refusal `out` is as it was.
FileStatus read_voyage_file(const std::filesystem::path& path, Voyage& out);

/// The same from text; `file` is the name that refusals quote.
FileStatus parse_voyage(std::string_view text, std::string_view file, Voyage& out);

/// The leg at a time; null before the first and from the end on.
const VoyageLeg* leg_at(const Voyage& voyage, std::int64_t utime);

}  // namespace quickstrip
