#include "firmware/display/entry_form.hpp"

#include <fmt/format.h>

#include <cmath>

#include "firmware/display/form.hpp"
#include "msgs/convert/sea_message.hpp"
#include "msgs/convert/text.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kMaxAuthor = sizeof(logbook_t::author) - 1;
constexpr std::size_t kMaxNote = sizeof(logbook_t::text) - 1;
constexpr std::size_t kMaxSystems = 3;  // wind sea and two swells
constexpr std::size_t kMaxTicket = 64;
constexpr std::int64_t kHour_us = 3'600'000'000;

const char* point_of(double dir_deg) {
  constexpr const char* kPoints[] = {"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                     "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
  return kPoints[std::lround(dir_deg / 22.5) % 16];
}

/// One decimal only where there is one: "8 s", "8.5 s".
std::string plain(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text;
}

std::string period_words(int kind) {
  return kind == sea_state_t::PERIOD_TP     ? "peak period"
         : kind == sea_state_t::PERIOD_TM01 ? "mean period"
                                            : "zero-crossing period";
}

std::int64_t until(Form& form, std::int64_t now, std::int64_t by_default, double max_h) {
  const auto hours = form.optional_number("hours", {0.25, max_h}, "h");
  return now + (hours && *hours <= max_h ? static_cast<std::int64_t>(*hours * static_cast<double>(kHour_us))
                                         : by_default);
}

void read_system(Form& form, int i, sea_state_t& sea) {
  const int kind = form.choice("kind", {"wind_sea", "swell"});
  sea.system_kind[i] =
      kind == 0 ? std::int8_t{sea_state_t::SYSTEM_WIND_SEA} : std::int8_t{sea_state_t::SYSTEM_SWELL};
  const double hs = form.number("hs_m", {0.0, kMaxWaveHeight_m}, "m");
  if (hs == 0.0) {
    form.fault("hs_m", "above 0 m");
  }
  sea.hs_m[i] = hs;
  sea.period_s[i] = form.number("period_s", kWavePeriod_s, "s");
  sea.period_kind[i] = static_cast<std::int8_t>(form.choice("period_kind", {"tp", "tm01", "tm02"}));
  sea.dir_from_deg[i] = form.direction("dir_from_deg");
  const auto spreading = form.optional_number("spreading_deg", kSpreading_deg, "degrees");
  sea.spreading_deg[i] = spreading.value_or(kAssumedSpreading_deg);
}

std::string system_words(const sea_state_t& sea, int i) {
  const bool is_wind_sea = sea.system_kind[i] == sea_state_t::SYSTEM_WIND_SEA;
  return fmt::format("{} {} m, {} {} s, from {:03.0f}° ({})", is_wind_sea ? "wind sea" : "swell",
                     plain(sea.hs_m[i]), period_words(sea.period_kind[i]), plain(sea.period_s[i]),
                     sea.dir_from_deg[i], point_of(sea.dir_from_deg[i]));
}

std::string system_brief(const sea_state_t& sea, int i) {
  constexpr const char* kPeriods[] = {"Tp", "Tm", "Tz"};
  return fmt::format("{} {} m {} {} s from {:03.0f}",
                     sea.system_kind[i] == sea_state_t::SYSTEM_WIND_SEA ? "wind sea" : "swell",
                     plain(sea.hs_m[i]), kPeriods[sea.period_kind[i]], plain(sea.period_s[i]),
                     sea.dir_from_deg[i]);
}

void put_sea_words(std::int64_t now, SeaEntry& entry) {
  const sea_state_t& sea = entry.message;
  for (int i = 0; i < sea.num_systems; ++i) {
    std::string words = system_words(sea, i);
    words += fmt::format(", spreading {}°", plain(sea.spreading_deg[i]));
    words[0] = static_cast<char>(words[0] - 'a' + 'A');
    entry.words += words + ". ";
    entry.brief += (i > 0 ? "; " : "") + system_brief(sea, i);
  }
  entry.words += fmt::format("Seen at {}, holds until {}. Entered by {}.", utc_clock(now),
                             utc_clock(sea.valid_until_utime), entry.author);
}

}  // namespace

std::string utc_clock(std::int64_t utime) {
  const std::int64_t minute = utime / 60'000'000 % 1440;
  return fmt::format("{:02d}:{:02d} UTC", minute / 60, minute % 60);
}

FieldErrors read_sea(std::string_view json, std::int64_t now, SeaEntry& out) {
  FieldErrors errors;
  Form form(json, errors);
  if (!form.is_object()) {
    return errors;
  }
  SeaEntry entry;
  sea_state_t& sea = entry.message;
  entry.author = form.text("author", kMaxAuthor, "your name");
  sea.utime = now;
  sea.source_kind = sea_state_t::SOURCE_MANUAL;
  sea.valid = std::int32_t{sea_state_t::VALID_SPREADING} | std::int32_t{sea_state_t::VALID_UNTIL};
  sea.valid_until_utime = until(form, now, kSeaHolds_us, 12.0);
  const nlohmann::json& systems = form.at("systems");
  if (!systems.is_array() || systems.empty() || systems.size() > kMaxSystems) {
    form.fault("systems", "a wind sea, one or two swells");
    return errors;
  }
  for (std::size_t i = 0; i < systems.size(); ++i) {
    Form system(systems[i], fmt::format("systems.{}", i), errors);
    if (system.is_object()) {
      read_system(system, static_cast<int>(i), sea);
    }
  }
  sea.num_systems = static_cast<std::int8_t>(systems.size());
  if (!errors.empty()) {
    return errors;
  }
  SeaState converted;
  std::uint32_t assumed = 0;
  if (const Conversion fit = to_sea_state(sea, converted, assumed); !fit) {  // all systems together
    form.fault(fit.index < 0 ? fit.field : fmt::format("systems.{}.{}", fit.index, fit.field),
               message(fit.refusal));
    return errors;
  }
  put_sea_words(now, entry);
  out = std::move(entry);
  return errors;
}

FieldErrors read_mark(std::string_view json, MarkEntry& out) {
  FieldErrors errors;
  Form form(json, errors);
  if (form.is_object()) {
    out.author = form.text("author", kMaxAuthor, "your name");
    out.text = form.text("text", kMaxNote, "what you saw");
  }
  return errors;
}

FieldErrors read_query(std::string_view json, query_t& out) {
  FieldErrors errors;
  Form form(json, errors);
  if (form.is_object()) {
    out.heading_deg = form.direction("heading_deg");
    out.speed_kn = form.number("speed_kn", kSpeedThroughWater_kn, "kn");
  }
  return errors;
}

FieldErrors read_acknowledge(std::string_view json, AcknowledgeEntry& out) {
  FieldErrors errors;
  Form form(json, errors);
  if (form.is_object()) {
    out.alert_id = form.integer("alert_id");
    out.instance = form.integer("instance");
    out.revision = form.integer("revision");
    out.silence_only = form.choice("what", {"acknowledge", "silence"}) == 1;
  }
  return errors;
}

FieldErrors read_withdraw(std::string_view json, WithdrawEntry& out) {
  FieldErrors errors;
  Form form(json, errors);
  if (form.is_object()) {
    out.kind = form.choice("kind", {"sea", "loading"}) == 1 ? EntryKind::kLoading : EntryKind::kSea;
    out.author = form.text("author", kMaxAuthor, "your name");
  }
  return errors;
}

FieldErrors read_confirm(std::string_view json, std::string& ticket) {
  FieldErrors errors;
  Form form(json, errors);
  if (form.is_object()) {
    ticket = form.text("ticket", kMaxTicket, "what was read back");
  }
  return errors;
}

std::string errors_json(const FieldErrors& errors) {
  nlohmann::json list = nlohmann::json::array();
  for (const FieldError& error : errors) {
    list.push_back({{"field", error.field}, {"text", error.text}});
  }
  return nlohmann::json{{"errors", list}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace quickstrip
