#include "sim/replay/advice_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "msgs/convert/text.hpp"
#include "sim/sea_files/utc_time.hpp"

namespace quickstrip {
namespace {

std::string number(double value) {
  return fmt::format("{:.9g}", value);
}

/// Empty for "not computed".
std::string number_or_nothing(double value) {
  return value < 0.0 ? std::string() : number(value);
}

std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    out += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return out + "\"";
}

}  // namespace

std::string verdict_word(const advice_t& advice) {
  constexpr std::array<const char*, 4> kWords{"unknown", "good", "caution", "exceeded"};
  return advice.no_advice != 0 ? "no advice"
                               : kWords[static_cast<std::size_t>(std::clamp<int>(advice.verdict, 0, 3))];
}

std::string advice_table_header() {
  return "time_utc,hs_m,tp_s,heading_deg,speed_kn,verdict,governing,value,limit,margin,roll_rms_deg,"
         "bridge_vertical_rms_m_s2,roll_exceedance,slam_probability,slams_per_hour,wetness_probability,"
         "change_heading_deg,change_speed_kn,change_to_heading_deg,change_to_speed_kn,change_text,text,"
         "sea_seq,own_ship_seq,digest\n";
}

std::string advice_table_line(const advice_t& advice, const SeaSummary& sea) {
  const bool has_advice = advice.no_advice == 0;
  const bool has_change = has_advice && advice.num_changes > 0;
  const bool has_sea = !sea.systems.empty();
  const int sea_input = advice.input_use[1] != 0 ? 1 : 0;  // QS_WAVE_SPECTRUM, else QS_SEA_STATE
  const bool has_course = advice.speed_kind != 0;
  std::string line = format_utc(advice.utime);
  const auto field = [&line](const std::string& text) { line += "," + text; };
  field(has_sea ? number(sea.hs_m) : "");
  field(has_sea ? number(sea.tp_s()) : "");
  field(has_course ? number(advice.heading_deg) : "");
  field(has_course ? number(advice.speed_kn) : "");
  field(verdict_word(advice));
  field(in_quotes(get_text(advice.governing_name)));
  for (const double value : {advice.governing_value, advice.governing_limit, advice.margin,
                             advice.roll_rms_deg, advice.bridge_vertical_rms_m_s2, advice.roll_exceedance,
                             advice.slam_probability, advice.slams_per_hour, advice.wetness_probability}) {
    field(has_advice ? number_or_nothing(value) : "");
  }
  field(has_change ? number(advice.change_heading_deg[0]) : "");
  field(has_change ? number(advice.change_speed_kn[0]) : "");
  field(has_change ? number(advice.change_to_heading_deg[0]) : "");
  field(has_change ? number(advice.change_to_speed_kn[0]) : "");
  field(in_quotes(has_change ? get_text(advice.change_text[0]) : std::string_view()));
  field(in_quotes(has_advice ? get_text(advice.reasons_text) : get_text(advice.no_advice_text)));
  field(fmt::format("{}", advice.input_seq[sea_input]));
  field(fmt::format("{}", advice.input_seq[3]));
  field(fmt::format("{:016x}", static_cast<std::uint64_t>(advice.digest)));
  return line + "\n";
}

}  // namespace quickstrip
