#include "msgs/files/voyage_file.hpp"

#include "msgs/convert/units.hpp"
#include "msgs/files/text_file.hpp"
#include "msgs/files/toml_table.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kMaxVoyageFileBytes = 4'000'000;
constexpr std::size_t kMaxLegs = 20'000;

Voyage read_all(const TomlTable& root) {
  root.allow_only({"schema", "name", "end_utc", "leg"});
  root.require_schema_1();
  Voyage voyage;
  voyage.name = root.name("name");
  voyage.end_utime = root.utime("end_utc");
  for (const TomlTable& table : root.tables("leg", kMaxLegs)) {
    table.allow_only({"from_utc", "heading_deg", "speed_kn"});
    VoyageLeg leg;
    leg.from_utime = table.utime("from_utc");
    leg.heading = {radians(table.number("heading_deg", {0.0, 360.0, "degrees, true"}))};
    if (table.number("heading_deg", {0.0, 360.0, ""}) == 360.0) {
      table.refuse("heading_deg", "0 is wanted for north");
    }
    leg.speed = from_knots(table.number("speed_kn", {0.0, 60.0, "kn through the water"}));
    if (!voyage.legs.empty() && leg.from_utime <= voyage.legs.back().from_utime) {
      table.refuse("from_utc", "a time after that of the leg before is wanted");
    }
    if (leg.from_utime >= voyage.end_utime) {
      table.refuse("from_utc", "a time before end_utc is wanted");
    }
    voyage.legs.push_back(leg);
  }
  if (voyage.legs.empty()) {
    root.refuse_list("leg", "none given: at least one table [[leg]] is wanted");
  }
  return voyage;
}

}  // namespace

FileStatus parse_voyage(std::string_view text, std::string_view file, Voyage& out) {
  try {
    out = read_all(TomlTable::parse(text, file));
    return {};
  } catch (const FileError& error) {
    return error;
  }
}

FileStatus read_voyage_file(const std::filesystem::path& path, Voyage& out) {
  try {
    return parse_voyage(read_text_file(path, kMaxVoyageFileBytes), path.string(), out);
  } catch (const FileError& error) {
    return error;
  }
}

const VoyageLeg* leg_at(const Voyage& voyage, std::int64_t utime) {
  if (utime >= voyage.end_utime) {
    return nullptr;
  }
  const VoyageLeg* current = nullptr;
  for (const VoyageLeg& leg : voyage.legs) {
    if (leg.from_utime > utime) {
      break;
    }
    current = &leg;
  }
  return current;
}

}  // namespace quickstrip
