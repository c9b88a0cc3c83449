#include "msgs/files/limits_file_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/base/angles.hpp"

namespace quickstrip {
namespace {

enum class Kind { kTranslation, kRotation, kAcceleration, kEvent, kSickness, kInterruptions };

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
    case Quantity::kMotionSickness:
      return Kind::kSickness;
    case Quantity::kMotionInterruptions:
      return Kind::kInterruptions;
    default:
      return Kind::kAcceleration;
  }
}

/// In the order of the wire.
Quantity read_quantity(const TomlTable& table) {
  return static_cast<Quantity>(
      table.choice("quantity", {"surge", "sway", "heave", "roll", "pitch", "yaw", "longitudinal_acceleration",
                                "lateral_acceleration", "vertical_acceleration", "slamming", "deck_wetness",
                                "propeller_emergence", "motion_sickness", "motion_interruptions"}));
}

/// Those that suit the quantity are the ones to choose from: an RMS is never judged as anything else.
Statistic read_statistic(const TomlTable& table, Kind kind) {
  const auto one_of = [&table](std::initializer_list<std::string_view> names, Statistic first) {
    return static_cast<Statistic>(static_cast<std::size_t>(first) + table.choice("statistic", names));
  };
  switch (kind) {
    case Kind::kEvent:
      return one_of({"probability", "per_hour"}, Statistic::kProbability);
    case Kind::kSickness:
      return one_of({"share_of_people"}, Statistic::kShareOfPeople);
    case Kind::kInterruptions:
      return one_of({"per_minute"}, Statistic::kPerMinute);
    default:
      return one_of({"rms", "significant"}, Statistic::kRms);
  }
}

struct LimitKey {
  const char* key;
  const char* by_length;
  NumberRange range;
  double factor;  // to core's unit
};

constexpr std::array kLimitKeys{
    LimitKey{"limit_m", "limit_m_by_length", {1.0e-3, 100.0, "m"}, 1.0},
    LimitKey{"limit_deg", "limit_deg_by_length", {1.0e-3, 90.0, "degrees"}, kPi / 180.0},
    LimitKey{"limit_g", "limit_g_by_length", {1.0e-4, 5.0, "g"}, kStandardGravity},
    LimitKey{"limit_m_s2", "limit_m_s2_by_length", {1.0e-3, 50.0, "m/s2"}, 1.0},
    LimitKey{"limit_probability", "limit_probability_by_length", {1.0e-9, 0.999, "per wave encounter"}, 1.0},
    LimitKey{"limit_per_hour", "limit_per_hour_by_length", {1.0e-6, 1.0e4, "an hour"}, 1.0},
    LimitKey{"limit_percent", "limit_percent_by_length", {0.01, 99.9, "% of people"}, 0.01},
    LimitKey{"limit_per_minute", "limit_per_minute_by_length", {1.0e-6, 100.0, "a minute"}, 1.0},
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
    case Kind::kSickness:
      return key == "limit_percent";
    case Kind::kInterruptions:
      return key == "limit_per_minute";
  }
  return false;
}

/// [[length, limit], ...], linear between lengths and constant beyond the first and the last.
double by_length(const TomlTable& table, const LimitKey& limit, double lpp) {
  constexpr std::size_t kMostPairs = 16;
  const auto pairs = table.pairs(limit.by_length, kMostPairs, {1.0, 1000.0, "m"}, limit.range);
  if (pairs.size() < 2) {
    table.refuse_item(limit.by_length, 0, "two lengths or more are wanted: [[100, 0.275], [330, 0.05]]");
  }
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    if (!(pairs[i][0] > pairs[i - 1][0])) {
      table.refuse_item(limit.by_length, i, "lengths in increasing order are wanted");
    }
  }
  std::size_t i = 0;
  while (i + 2 < pairs.size() && lpp > pairs[i + 1][0]) {
    ++i;
  }
  const auto& [from, low] = pairs[i];
  const auto& [to, high] = pairs[i + 1];
  const double part = std::clamp((lpp - from) / (to - from), 0.0, 1.0);
  return (1.0 - part) * low + part * high;
}

double read_limit(const TomlTable& table, Kind kind, Statistic statistic, double lpp) {
  const LimitKey* given = nullptr;
  std::string wanted;
  for (const LimitKey& limit : kLimitKeys) {
    wanted += suits(limit, kind, statistic) ? (wanted.empty() ? "" : " or ") + std::string(limit.key) : "";
  }
  for (const LimitKey& limit : kLimitKeys) {
    for (const char* key : {limit.key, limit.by_length}) {
      if (!table.has(key)) {
        continue;
      }
      if (given != nullptr || !suits(limit, kind, statistic)) {
        table.refuse(
            key, fmt::format("{}, and only one limit, is wanted for this quantity and statistic", wanted));
      }
      given = &limit;
    }
  }
  if (given == nullptr) {
    table.refuse(wanted, "a limit is wanted");
  }
  const double value =
      table.has(given->key) ? table.number(given->key, given->range) : by_length(table, *given, lpp);
  return value * given->factor;
}

void read_people(const TomlTable& table, Kind kind, Criterion& criterion) {
  if (table.has("exposure_min") && kind != Kind::kSickness) {
    table.refuse("exposure_min", "no time is wanted but for quantity = \"motion_sickness\"");
  }
  for (const char* key : {"stance_height_m", "stance_half_width_ratio"}) {
    if (table.has(key) && kind != Kind::kInterruptions) {
      table.refuse(key, "no stance is wanted but for quantity = \"motion_interruptions\"");
    }
  }
  constexpr double kSecondsPerMinute = 60.0;
  criterion.exposure =
      kSecondsPerMinute * table.number_or("exposure_min", {5.0, 1440.0, "minutes"}, 0.0);  // 0: 1974
  criterion.stance.height = table.number_or("stance_height_m", {0.5, 2.0, "m"}, criterion.stance.height);
  criterion.stance.half_width_ratio =
      table.number_or("stance_half_width_ratio", {0.05, 0.9, ""}, criterion.stance.half_width_ratio);
}

}  // namespace

Criterion read_values(const TomlTable& table, double lpp) {
  table.allow_only({"name",
                    "quantity",
                    "role",
                    "place",
                    "statistic",
                    "limit_m",
                    "limit_deg",
                    "limit_g",
                    "limit_m_s2",
                    "limit_probability",
                    "limit_per_hour",
                    "limit_percent",
                    "limit_per_minute",
                    "limit_m_by_length",
                    "limit_deg_by_length",
                    "limit_g_by_length",
                    "limit_m_s2_by_length",
                    "limit_probability_by_length",
                    "limit_per_hour_by_length",
                    "limit_percent_by_length",
                    "limit_per_minute_by_length",
                    "caution_fraction",
                    "exposure_min",
                    "stance_height_m",
                    "stance_half_width_ratio"});
  Criterion criterion;
  criterion.quantity = read_quantity(table);
  const Kind kind = kind_of(criterion.quantity);
  criterion.statistic = read_statistic(table, kind);
  criterion.limit = read_limit(table, kind, criterion.statistic, lpp);
  criterion.caution_fraction = table.number_or("caution_fraction", {0.01, 1.0, "of the limit"}, 0.75);
  read_people(table, kind, criterion);
  return criterion;
}

}  // namespace quickstrip
