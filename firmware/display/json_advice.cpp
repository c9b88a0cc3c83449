// Advice, outlook, limits, cells and answers of json_parts.hpp.
#include <algorithm>
#include <cmath>

#include "firmware/display/json_parts.hpp"
#include "msgs/convert/hazard_text.hpp"
#include "msgs/convert/quality_text.hpp"
#include "msgs/convert/refusal.hpp"

namespace quickstrip {
namespace {

using nlohmann::json;

constexpr int kListedCriteria = 32;
constexpr int kListedChanges = 8;

json index_or_null(int index) {
  return index >= 0 ? json(index) : json(nullptr);
}

json name_of(const limits_t* limits, int criterion) {
  if (limits == nullptr || criterion < 0 || criterion >= limits->num_criteria) {
    return nullptr;
  }
  return field_text(limits->name[criterion]);
}

json turn_json(const outlook_t& outlook, std::size_t i) {
  return {{"time_s", known(outlook.turn_time_s[i])},
          {"exceeded_s", known(outlook.turn_exceeded_s[i])},
          {"worst_verdict", outlook.turn_worst_verdict[i]},
          {"worst_heading_deg", known(outlook.turn_worst_heading_deg[i])},
          {"max_roll_deg", known(outlook.turn_max_roll_deg[i])},
          {"text", field_text(outlook.turn_text[i])}};
}

}  // namespace

json known(double value) {
  return std::isfinite(value) && value >= 0.0 ? json(value) : json(nullptr);
}

json hazard_words(std::int32_t hazards) {
  json words = json::array();
  for (const HazardWords& one : kHazardWords) {
    if ((static_cast<std::uint32_t>(hazards) & static_cast<std::uint32_t>(one.bit)) != 0U &&
        *one.bridge != '\0') {
      words.push_back(one.bridge);
    }
  }
  return words;
}

json quality_words(std::int32_t quality) {
  json words = json::array();
  for (const QualityWords& one : kQualityWords) {
    if ((static_cast<std::uint32_t>(quality) & static_cast<std::uint32_t>(one.bit)) != 0U &&
        *one.bridge != '\0') {
      words.push_back(one.bridge);
    }
  }
  return words;
}

json advice_json(const advice_t& m) {
  return {{"utime", m.utime},
          {"seq", m.seq},
          {"valid_until_utime", m.valid_until_utime},
          {"hull", field_text(m.hull_name)},
          {"profile", field_text(m.profile_name)},
          {"no_advice", m.no_advice},
          {"no_advice_text", field_text(m.no_advice_text)},
          {"heading_deg", m.heading_deg},
          {"speed_kn", m.speed_kn},
          {"speed_kind", m.speed_kind},
          {"verdict", m.verdict},
          {"governing", index_or_null(m.governing)},
          {"governing_name", field_text(m.governing_name)},
          {"governing_value", known(m.governing_value)},
          {"governing_limit", known(m.governing_limit)},
          {"governing_system", index_or_null(m.governing_system)},
          {"margin", known(m.margin)},
          {"roll_rms_deg", known(m.roll_rms_deg)},
          {"slams_per_hour", known(m.slams_per_hour)},
          {"hazards", m.hazards},
          {"hazard_words", hazard_words(m.hazards)},
          {"quality_words", quality_words(m.quality)},
          {"sea_assumptions", m.sea_assumptions},
          {"change_needed", m.change_needed != 0},
          {"none_is_good", m.none_is_good != 0},
          {"no_change_helps", m.no_change_helps != 0},
          {"reasons", field_text(m.reasons_text)}};
}

json changes_json(const advice_t& m, const outlook_t* outlook) {
  json list = json::array();
  const int num = std::clamp<int>(m.num_changes, 0, kListedChanges);
  for (std::size_t i = 0; i < static_cast<std::size_t>(num); ++i) {
    json change = {{"to_heading_deg", m.change_to_heading_deg[i]},
                   {"to_speed_kn", m.change_to_speed_kn[i]},
                   {"verdict", m.change_verdict[i]},
                   {"margin", known(m.change_margin[i])},
                   {"text", field_text(m.change_text[i])}};
    if (outlook != nullptr) {
      change["kind"] = outlook->change_kind[i];
      change["members_exceeded"] = index_or_null(outlook->change_exceeded[i]);
      change["turn"] = turn_json(*outlook, i);
    }
    list.push_back(std::move(change));
  }
  return list;
}

json outlook_json(const outlook_t& m) {
  return {{"num_members", m.num_members},
          {"present_exceeded", index_or_null(m.present_exceeded)},
          {"next_criterion", index_or_null(m.next_criterion)},
          {"next_margin", known(m.next_margin)},
          {"verdict_now", m.verdict_now},
          {"better_in_s", known(m.better_in_s)},
          {"expect_s", known(m.expect_s)},
          {"expected_max_roll_deg", known(m.expected_max_roll_deg)},
          {"expected_max_pitch_deg", known(m.expected_max_pitch_deg)},
          {"expected_max_heave_m", known(m.expected_max_heave_m)},
          {"roll_period_low_s", known(m.roll_period_low_s)},
          {"roll_period_high_s", known(m.roll_period_high_s)},
          {"roll_period_kind", m.roll_period_kind},
          {"unknown_share", known(m.unknown_share)},
          {"std_assumed", m.std_assumed}};
}

json criteria_json(const limits_t& m, const advice_t* advice, const outlook_t* outlook) {
  json list = json::array();
  const int num = std::clamp<int>(m.num_criteria, 0, kListedCriteria);
  for (int c = 0; c < num; ++c) {
    const bool has_value = advice != nullptr && advice->no_advice == 0 && c < advice->num_criteria;
    list.push_back({{"name", field_text(m.name[c])},
                    {"place", field_text(m.place_name[c])},
                    {"quantity", m.quantity[c]},
                    {"statistic", m.statistic[c]},
                    {"unit", m.unit[c]},
                    {"limit", known(m.limit[c])},
                    {"caution_fraction", known(m.caution_fraction[c])},
                    {"watched", m.watched[c] != 0},
                    {"value", has_value ? known(advice->criterion_value[c]) : json(nullptr)},
                    {"expected", outlook != nullptr ? known(outlook->expected_max[c]) : json(nullptr)}});
  }
  return list;
}

json cell_json(const grid_t& m, int s, int h) {
  const auto step = [](int value, double size) { return value < 0 ? json(nullptr) : json(value * size); };
  return {{"heading_deg", 360.0 * h / m.num_headings},
          {"speed_kn", static_cast<double>(m.speed_kn[s])},
          {"verdict", m.verdict[s][h]},
          {"governing", index_or_null(m.governing[s][h])},
          {"governing_system", index_or_null(m.governing_system[s][h])},
          {"margin", step(m.margin[s][h], 0.01)},
          {"hazard_words", hazard_words(m.hazards[s][h])},
          {"quality_words", quality_words(m.quality[s][h])},
          {"roll_rms_deg", step(m.roll_rms[s][h], 0.01)},
          {"bridge_vertical_rms_m_s2", step(m.bridge_vertical_rms[s][h], 0.001)},
          {"roll_exceedance", step(m.roll_exceedance[s][h], 0.00005)},
          {"slam_probability", step(m.slam_probability[s][h], 0.00005)},
          {"slams_per_hour", step(m.slams_per_hour[s][h], 0.1)},
          {"wetness_probability", step(m.wetness_probability[s][h], 0.00005)},
          {"speed_loss_kn", step(m.speed_loss[s][h], 0.1)}};
}

json answer_json(const response_t& m, const limits_t* limits) {
  const bool is_refused = m.refusal != 0;
  const limits_t* const same_limits =
      limits != nullptr && limits->digest == m.limits_digest ? limits : nullptr;
  json lines = json::array();
  for (std::size_t i = 0; !is_refused && i < static_cast<std::size_t>(m.num_quantities); ++i) {
    json shares = json::array();
    for (std::size_t s = 0; s < static_cast<std::size_t>(m.num_systems); ++s) {
      shares.push_back(known(static_cast<double>(m.system_share[i][s])));
    }
    lines.push_back({{"quantity", m.quantity[i]},
                     {"place", field_text(m.place_name[i])},
                     {"unit", m.unit[i]},
                     {"rms", known(m.rms[i])},
                     {"significant", known(m.significant[i])},
                     {"tm02_s", known(m.tm02_s[i])},
                     {"probability", known(m.probability[i])},
                     {"per_hour", known(m.per_hour[i])},
                     {"shares", std::move(shares)},
                     {"criterion", index_or_null(m.criterion[i])}});
  }
  return {{"query_id", std::to_string(m.query_id)},  // beyond what a browser's numbers hold
          {"source_id", m.query_source_id},
          {"refusal", is_refused ? json(message(static_cast<Refusal>(m.refusal))) : json(nullptr)},
          {"heading_deg", known(m.heading_deg)},
          {"speed_kn", std::isfinite(m.speed_kn) ? json(m.speed_kn) : json(nullptr)},
          {"verdict", m.verdict},
          {"governing", index_or_null(m.governing)},
          {"governing_name", name_of(same_limits, m.governing)},
          {"governing_system", index_or_null(m.governing_system)},
          {"margin", known(m.margin)},
          {"hazard_words", hazard_words(m.hazards)},
          {"quality_words", quality_words(m.quality)},
          {"lines", std::move(lines)}};
}

}  // namespace quickstrip
