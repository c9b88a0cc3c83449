// One line of CSV per advice.
#pragma once

#include <string>

#include "quickstrip/advice_t.hpp"
#include "sim/replay/sea_summary.hpp"

namespace quickstrip {

/// time_utc,hs_m,tp_s,heading_deg,speed_kn,verdict,governing,value,limit,margin,...
std::string advice_table_header();

/// What is not computed or not known is an empty field; text stands in double quotes.
std::string advice_table_line(const advice_t& advice, const SeaSummary& sea);

/// "unknown", "good", "caution", "exceeded"; "no advice".
std::string verdict_word(const advice_t& advice);

}  // namespace quickstrip
