#include "msgs/files/limits_file.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "core/base/angles.hpp"
#include "msgs/files/text_file.hpp"
#include "msgs/files/toml_table.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kMaxLimitsFileBytes = 1'000'000;

enum class Kind { kTranslation, kRotation, kAcceleration, kEvent };

Kind kind_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kSurge:
    case Quantity::kSway:
    case Quantity::kHeave:
      return Kind::kTranslation;
    case Quantity::kRoll:
    case Quantity::kPitch:
    case Quantity::kYaw:
      return Kind::kRotation;
    case Quantity::kSlamming:
    case Quantity::kDeckWetness:
    case Quantity::kPropellerEmergence:
      return Kind::kEvent;
    default:
      return Kind::kAcceleration;
  }
}

Quantity read_quantity(const TomlTable& table) {
  constexpr std::array kQuantities{Quantity::kSurge,
                                   Quantity::kSway,
                                   Quantity::kHeave,
                                   Quantity::kRoll,
                                   Quantity::kPitch,
                                   Quantity::kYaw,
                                   Quantity::kLongitudinalAcceleration,
                                   Quantity::kLateralAcceleration,
                                   Quantity::kVerticalAcceleration,
                                   Quantity::kSlamming,
                                   Quantity::kDeckWetness,
                                   Quantity::kPropellerEmergence};
  return kQuantities[table.choice(
      "quantity",
      {"surge", "sway", "heave", "roll", "pitch", "yaw", "longitudinal_acceleration", "lateral_acceleration",
       "vertical_acceleration", "slamming", "deck_wetness", "propeller_emergence"})];
}

Statistic read_statistic(const TomlTable& table, Kind kind) {
  if (kind == Kind::kEvent) {
    return table.choice("statistic", {"probability", "per_hour"}) == 0 ? Statistic::kProbability
                                                                       : Statistic::kPerHour;
  }
  return table.choice("statistic", {"rms", "significant"}) == 0 ? Statistic::kRms : Statistic::kSignificant;
}

struct LimitKey {
  const char* key;
  NumberRange range;
  double factor;  // to core's unit
};

constexpr std::array kLimitKeys{
    LimitKey{"limit_m", {1.0e-3, 100.0, "m"}, 1.0},
    LimitKey{"limit_deg", {1.0e-3, 90.0, "degrees"}, kPi / 180.0},
    LimitKey{"limit_g", {1.0e-4, 5.0, "g"}, kStandardGravity},
    LimitKey{"limit_m_s2", {1.0e-3, 50.0, "m/s2"}, 1.0},
    LimitKey{"limit_probability", {1.0e-9, 0.999, "per wave encounter"}, 1.0},
    LimitKey{"limit_per_hour", {1.0e-6, 1.0e4, "an hour"}, 1.0},
};

bool suits(const LimitKey& limit, Kind kind, Statistic statistic) {
  const std::string_view key = limit.key;
  switch (kind) {
    case Kind::kTranslation:
      return key == "limit_m";
    case Kind::kRotation:
      return key == "limit_deg";
    case Kind::kAcceleration:
      return key == "limit_g" || key == "limit_m_s2";
    case Kind::kEvent:
      return key == (statistic == Statistic::kProbability ? "limit_probability" : "limit_per_hour");
  }
  return false;
}

double read_limit(const TomlTable& table, Kind kind, Statistic statistic) {
  const LimitKey* given = nullptr;
  std::string wanted;
  for (const LimitKey& limit : kLimitKeys) {
    wanted += suits(limit, kind, statistic) ? (wanted.empty() ? "" : " or ") + std::string(limit.key) : "";
  }
  for (const LimitKey& limit : kLimitKeys) {
    if (!table.has(limit.key)) {
      continue;
    }
    if (given != nullptr || !suits(limit, kind, statistic)) {
      table.refuse(limit.key,
                   fmt::format("{}, and only one limit, is wanted for this quantity and statistic", wanted));
    }
    given = &limit;
  }
  if (given == nullptr) {
    table.refuse(wanted, "a limit is wanted");
  }
  return table.number(given->key, given->range) * given->factor;
}

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

std::vector<Place> places_of_role(const TomlTable& table, const Hull& hull) {
  constexpr std::array kRoles{PointRole::kBridge, PointRole::kForwardPerpendicular, PointRole::kDeck,
                              PointRole::kPassengers, PointRole::kOther};
  const PointRole role = kRoles[table.choice("role", {"bridge", "fp", "deck", "passengers", "other"})];
  std::vector<Place> list;
  for (std::size_t i = 0; i < hull.points.size(); ++i) {
    if (hull.points[i].role == role) {
      list.push_back({static_cast<std::uint8_t>(i), std::string(hull.points[i].name.view())});
    }
  }
  if (list.empty()) {
    list.push_back({kNowhere, table.text("role")});
  }
  return list;
}

/// One at least; kNowhere where the hull has no such place.
std::vector<Place> read_places_of(const TomlTable& table, Quantity quantity, const Hull& hull) {
  const Kind kind = kind_of(quantity);
  const bool is_local = kind == Kind::kAcceleration || kind == Kind::kEvent;
  for (const char* key : {"role", "place"}) {
    if (table.has(key) && !is_local) {
      table.refuse(key, "no place is wanted: this motion is that of the centre of gravity");
    }
  }
  if (!is_local) {
    return {{0, ""}};
  }
  if (kind == Kind::kEvent) {
    if (table.has("role")) {
      table.refuse("role",
                   "place = \"NAME\", or neither, is wanted: stations, freeboard points and the propeller "
                   "have no role");
    }
    const std::vector<Place> all = places_of_events(quantity, hull);
    if (table.has("place")) {
      return named_place(table, all);
    }
    return all.empty() ? std::vector<Place>{{kNowhere, ""}} : all;
  }
  if (table.has("role") && table.has("place")) {
    table.refuse("place", "either role or place is wanted, not both");
  }
  return table.has("place") ? named_place(table, all_places(hull.points)) : places_of_role(table, hull);
}

void read_criterion(const TomlTable& table, const Hull& hull, const TomlTable& root, Criteria& criteria) {
  table.allow_only({"name", "quantity", "role", "place", "statistic", "limit_m", "limit_deg", "limit_g",
                    "limit_m_s2", "limit_probability", "limit_per_hour", "caution_fraction"});
  const std::string name = table.name("name");
  Criterion criterion;
  criterion.quantity = read_quantity(table);
  const Kind kind = kind_of(criterion.quantity);
  criterion.statistic = read_statistic(table, kind);
  criterion.limit = read_limit(table, kind, criterion.statistic);
  criterion.caution_fraction = table.number_or("caution_fraction", {0.01, 1.0, "of the limit"}, 0.75);
  const std::vector<Place> places = read_places_of(table, criterion.quantity, hull);
  for (const Place& place : places) {
    const std::string full = places.size() > 1 ? fmt::format("{} at {}", name, place.name) : name;
    if (full.size() > kMaxNameBytes - 1) {
      table.refuse("name", fmt::format("a shorter name is wanted: \"{}\" has {} bytes, {} fit", full,
                                       full.size(), kMaxNameBytes - 1));
    }
    criterion.name = Name(full);
    criterion.place = place.index;
    for (const Criterion& other : criteria) {
      if (other.name == criterion.name) {
        table.refuse("name", "a name of its own is wanted: one before has the same");
      }
    }
    if (!criteria.push_back(criterion)) {
      root.refuse_list("criterion",
                       fmt::format("more than {}, counted by place: at most that many fit", kMaxCriteria));
    }
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
