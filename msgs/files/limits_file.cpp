#include "msgs/files/limits_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/advice/people_channels.hpp"
#include "msgs/files/limits_file_values.hpp"
#include "msgs/files/text_file.hpp"
#include "msgs/files/toml_table.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kMaxLimitsFileBytes = 1'000'000;

struct Place {
  std::uint8_t index;
  std::string name;
};

template <typename Places>
std::vector<Place> all_places(const Places& places) {
  std::vector<Place> list;
  for (std::size_t i = 0; i < places.size(); ++i) {
    list.push_back({static_cast<std::uint8_t>(i), std::string(places[i].name.view())});
  }
  return list;
}

std::vector<Place> places_of_events(Quantity quantity, const Hull& hull) {
  if (quantity == Quantity::kPropellerEmergence) {
    return hull.propeller ? std::vector<Place>{{0, "propeller"}} : std::vector<Place>{};
  }
  return quantity == Quantity::kSlamming ? all_places(hull.slamming) : all_places(hull.freeboard);
}

std::vector<Place> named_place(const TomlTable& table, const std::vector<Place>& there_are) {
  const std::string name = table.name("place");
  std::string known;
  for (const Place& place : there_are) {
    if (place.name == name) {
      return {place};
    }
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", place.name);
  }
  table.refuse("place",
               fmt::format("one of the hull file's places is wanted: {}", known.empty() ? "none" : known));
}

/// Of a point without role or place: people are sick where passengers are, and work on deck.
const char* default_role(Quantity quantity) {
  return quantity == Quantity::kMotionSickness        ? "passengers"
         : quantity == Quantity::kMotionInterruptions ? "deck"
                                                      : nullptr;
}

std::vector<Place> places_of_role(const TomlTable& table, Quantity quantity, const Hull& hull) {
  constexpr std::array kRoles{PointRole::kBridge, PointRole::kForwardPerpendicular, PointRole::kDeck,
                              PointRole::kPassengers, PointRole::kOther};
  constexpr std::array kNames{"bridge", "fp", "deck", "passengers", "other"};
  std::size_t chosen = 0;
  if (!table.has("role") && default_role(quantity) != nullptr) {
    chosen = static_cast<std::size_t>(
        std::find(kNames.begin(), kNames.end(), std::string_view(default_role(quantity))) - kNames.begin());
  } else {
    chosen = table.choice("role", {kNames[0], kNames[1], kNames[2], kNames[3], kNames[4]});
  }
  std::vector<Place> list;
  for (std::size_t i = 0; i < hull.points.size(); ++i) {
    if (hull.points[i].role == kRoles[chosen]) {
      list.push_back({static_cast<std::uint8_t>(i), std::string(hull.points[i].name.view())});
    }
  }
  if (list.empty()) {
    list.push_back({kNowhere, kNames[chosen]});
  }
  return list;
}

/// One at least; kNowhere where the hull has no such place.
std::vector<Place> read_places_of(const TomlTable& table, Quantity quantity, const Hull& hull) {
  const bool is_local = is_at_point(quantity) || is_event(quantity);
  for (const char* key : {"role", "place"}) {
    if (table.has(key) && !is_local) {
      table.refuse(key, "no place is wanted: this motion is that of the centre of gravity");
    }
  }
  if (!is_local) {
    return {{0, "G"}};
  }
  if (is_event(quantity)) {
    if (table.has("role")) {
      table.refuse("role",
                   "place = \"NAME\", or neither, is wanted: stations, freeboard points and the propeller "
                   "have no role");
    }
    const std::vector<Place> all = places_of_events(quantity, hull);
    if (table.has("place")) {
      return named_place(table, all);
    }
    const char* const nowhere = quantity == Quantity::kPropellerEmergence ? "propeller" : "bow";
    return all.empty() ? std::vector<Place>{{kNowhere, nowhere}} : all;
  }
  if (table.has("role") && table.has("place")) {
    table.refuse("place", "either role or place is wanted, not both");
  }
  return table.has("place") ? named_place(table, all_places(hull.points))
                            : places_of_role(table, quantity, hull);
}

constexpr std::string_view kPlaceMark = "{place}";

/// Cut between two characters of UTF-8.
std::string cut(std::string text) {
  std::size_t end = std::min(text.size(), kMaxNameBytes - 1);
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) {
    --end;
  }
  text.resize(end);
  return text;
}

/// "slamming at {place}" of a place of the hull; a name without the mark gets " at PLACE" where there are
/// several. With the mark it is cut where it is too long: the profile does not know the hull.
std::string name_at(const TomlTable& table, const Place& place, bool is_one_of_several) {
  std::string name = table.name("name");
  const std::size_t mark = name.find(kPlaceMark);
  if (mark != std::string::npos) {
    return cut(name.replace(mark, kPlaceMark.size(), place.name));
  }
  name += is_one_of_several ? " at " + place.name : "";
  if (name.size() > kMaxNameBytes - 1) {
    table.refuse("name", fmt::format("a shorter name is wanted: \"{}\" has {} bytes, {} fit", name,
                                     name.size(), kMaxNameBytes - 1));
  }
  return name;
}

void refuse_conflict(const TomlTable& table, const Criterion& criterion, const Criteria& before) {
  for (const Criterion& other : before) {
    const bool is_cut = criterion.name.view().size() + 4 > kMaxNameBytes;  // whole names differ further on
    if (other.name == criterion.name && !is_cut) {
      table.refuse("name", "a name of its own is wanted: one before has the same");
    }
    const bool same_people = criterion.quantity == Quantity::kMotionInterruptions &&
                             other.quantity == criterion.quantity && other.place == criterion.place &&
                             criterion.is_watched();
    if (same_people && !(other.stance == criterion.stance)) {
      table.refuse("name", fmt::format("the stance of \"{}\" is wanted: interruptions at one place have one",
                                       other.name.view()));
    }
  }
}

void read_criterion(const TomlTable& table, const Hull& hull, const TomlTable& root, Criteria& criteria) {
  Criterion criterion = read_values(table, hull.lpp);
  const std::vector<Place> places = read_places_of(table, criterion.quantity, hull);
  for (const Place& place : places) {
    criterion.name = Name(name_at(table, place, places.size() > 1));
    criterion.place = place.index;
    refuse_conflict(table, criterion, criteria);
    if (!criteria.push_back(criterion)) {
      root.refuse_list("criterion",
                       fmt::format("more than {}, counted by place: at most that many fit", kMaxCriteria));
    }
  }
}

/// What people_channels.hpp will make of it.
void refuse_too_many_people(const TomlTable& root, const Criteria& criteria) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < criteria.size(); ++i) {
    const Criterion& criterion = criteria[i];
    const bool is_asked = criterion.is_watched() && (criterion.quantity == Quantity::kMotionSickness ||
                                                     criterion.quantity == Quantity::kMotionInterruptions);
    const bool is_new = std::none_of(
        criteria.begin(), criteria.begin() + static_cast<std::ptrdiff_t>(i), [&](const Criterion& other) {
          return other.quantity == criterion.quantity && other.place == criterion.place;
        });
    count += is_asked && is_new ? num_channels(criterion) : 0;
  }
  if (count > kMaxPeopleChannels) {
    root.refuse_list("criterion",
                     fmt::format("motion_sickness (1 a point) and motion_interruptions (2 a point) count {}: "
                                 "at most {} fit",
                                 count, kMaxPeopleChannels));
  }
}

LimitsProfile read_all(const TomlTable& root, const Hull& hull) {
  root.allow_only({"schema", "name", "criterion"});
  root.require_schema_1();
  LimitsProfile profile;
  profile.name = Name(root.name("name"));
  for (const TomlTable& table : root.tables("criterion", kMaxCriteria)) {
    read_criterion(table, hull, root, profile.criteria);
  }
  if (profile.criteria.empty()) {  // a profile without limits would call every sea good
    root.refuse_list("criterion", "none given: at least one table [[criterion]] is wanted");
  }
  refuse_too_many_people(root, profile.criteria);
  return profile;
}

}  // namespace

FileStatus parse_limits(std::string_view text, std::string_view file, const Hull& hull, LimitsProfile& out) {
  try {
    out = read_all(TomlTable::parse(text, file), hull);
    return {};
  } catch (const FileError& error) {
    return error;
  }
}

FileStatus read_limits_file(const std::filesystem::path& path, const Hull& hull, LimitsProfile& out) {
  try {
    return parse_limits(read_text_file(path, kMaxLimitsFileBytes), path.string(), hull, out);
  } catch (const FileError& error) {
    return error;
  }
}

}  // namespace quickstrip
