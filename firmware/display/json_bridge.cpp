// Sea, ship, inputs, alerts, health and notes of json_parts.hpp.
#include <algorithm>
#include <cmath>

#include "firmware/display/json_parts.hpp"
#include "msgs/convert/refusal.hpp"

namespace quickstrip {
namespace {

using nlohmann::json;

constexpr int kNumShownInputs = 6;  // of advice_t; health's are in the same order
constexpr int kMaxLines = 15;       // of comparison_t

json marked(std::int32_t valid, std::int32_t bit, double value) {
  return (valid & bit) != 0 && std::isfinite(value) ? json(value) : json(nullptr);
}

}  // namespace

json sea_json(const ShownSea& sea) {
  json systems = json::array();
  for (const ShownSystem& system : sea.systems) {
    systems.push_back({{"hs_m", system.hs_m},
                       {"period_s", system.period_s},
                       {"period_kind", system.period_kind},
                       {"dir_from_deg", system.dir_from_deg},
                       {"kind", system.kind}});
  }
  return {{"hs_m", known(sea.hs_m)},
          {"source_kind", sea.source_kind},
          {"utime", sea.utime},
          {"systems", std::move(systems)}};
}

json own_ship_json(const own_ship_t& m) {
  using M = own_ship_t;
  return {{"utime", m.utime},
          {"heading_deg", marked(m.valid, M::VALID_HEADING, m.heading_deg)},
          {"speed_through_water_kn", marked(m.valid, M::VALID_SPEED_THROUGH_WATER, m.speed_through_water_kn)},
          {"speed_over_ground_kn", marked(m.valid, M::VALID_SPEED_OVER_GROUND, m.speed_over_ground_kn)},
          {"wind_speed_kn", marked(m.valid, M::VALID_WIND, m.wind_speed_kn)},
          {"wind_from_deg", marked(m.valid, M::VALID_WIND, m.wind_from_deg)},
          {"depth_m", marked(m.valid, M::VALID_DEPTH, m.depth_m)}};
}

json inputs_json(const advice_t* advice, const health_t* health) {
  json list = json::array();
  for (int i = 0; i < kNumShownInputs; ++i) {
    json input = {{"input", i}};
    if (advice != nullptr) {
      input["use"] = advice->input_use[i];
      input["source_id"] = advice->input_source_id[i];
      input["utime"] = advice->input_utime[i];
    }
    if (health != nullptr) {
      input["age_s"] = known(health->input_age_s[i]);
      input["stale_after_s"] = known(health->input_stale_after_s[i]);
      input["received"] = health->input_received[i];
      input["refused"] = health->input_refused[i];
      input["last_refusal"] = health->input_last_refusal[i] != 0
                                  ? json(message(static_cast<Refusal>(health->input_last_refusal[i])))
                                  : json(nullptr);
    }
    list.push_back(std::move(input));
  }
  return list;
}

json alerts_json(const Shown& shown) {
  json list = json::array();
  for (const auto& [key, m] : shown.alerts) {
    list.push_back({{"alert_id", m.alert_id},
                    {"instance", m.instance},
                    {"revision", m.revision},
                    {"priority", m.priority},
                    {"state", m.state},
                    {"raised_utime", m.raised_utime},
                    {"title", field_text(m.title)},
                    {"text", field_text(m.text)}});
  }
  std::sort(list.begin(), list.end(), [](const json& a, const json& b) {  // warnings first
    return a["priority"].get<int>() < b["priority"].get<int>();
  });
  return list;
}

json comparison_json(const comparison_t& m) {
  json lines = json::array();
  const int num = std::clamp<int>(m.num_lines, 0, kMaxLines);
  for (int i = 0; i < num; ++i) {
    lines.push_back({{"text", field_text(m.text[i])},
                     {"state", m.state[i]},
                     {"quantity", m.quantity[i]},
                     {"place", field_text(m.place_name[i])},
                     {"unit", m.unit[i]},
                     {"predicted", known(m.predicted_rms[i])},
                     {"measured", known(m.measured_rms[i])},
                     {"low", known(m.low_rms[i])},
                     {"high", known(m.high_rms[i])},
                     {"gap_since_s", known(m.gap_since_s[i])}});
  }
  return {{"utime", m.utime},
          {"window_s", known(m.window_s)},
          {"confidence", m.confidence},
          {"lines", std::move(lines)}};
}

json health_json(const health_t& m) {
  return {{"state", m.state},
          {"clock", m.clock},
          {"cycle_period_s", m.cycle_period_s},
          {"cycle_last_s", known(m.cycle_last_s)},
          {"cycle_max_s", known(m.cycle_max_s)},
          {"num_cycles", m.num_cycles},
          {"deadline_misses", m.num_deadline_misses},
          {"publish_failures", m.publish_failures},
          {"started_utime", m.started_utime},
          {"resident_bytes", m.resident_bytes},
          {"version", field_text(m.version)},
          {"hull", field_text(m.hull_name)}};
}

json notes_json(const Shown& shown) {
  json list = json::array();
  for (auto note = shown.notes.rbegin(); note != shown.notes.rend(); ++note) {
    list.push_back({{"utime", note->utime},
                    {"kind", note->kind},
                    {"author", field_text(note->author)},
                    {"text", field_text(note->text)}});
  }
  return list;
}

}  // namespace quickstrip
