// Words of a report: quantities, places, remarks. Internal to sim/seaway.
#pragma once

#include <string>
#include <vector>

#include "sim/seaway/report.hpp"

namespace quickstrip::seaway {

/// Names and SI units as `quickstrip-hull responses` has them.
const char* quantity_word(Quantity quantity);
const char* unit_word(Quantity quantity);
std::string place_words(const Channel& channel, const Hull& hull);

/// As a field of CSV.
std::string quoted(const std::string& text);

inline constexpr const char* kSeveralCrossings = "several_crossings_a_cycle";
inline constexpr const char* kNotGaussian = "not_gaussian";

/// Where the count and the statement part, and why they may.
std::vector<std::string> remarks_on(const Report& report, std::size_t count);

}  // namespace quickstrip::seaway
