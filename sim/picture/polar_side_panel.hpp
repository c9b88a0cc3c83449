// What stands beside and above the polar: title, verdict in words, the changes, the waves, the legend.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "sim/picture/polar_picture.hpp"

namespace quickstrip {

inline constexpr int kNumShownChanges = 3;
/// By advice_t's VERDICT_...: unknown, good, caution, exceeded.
inline constexpr std::array<const char*, 4> kVerdictColours{"#F4F4F2", "#CDE9E2", "#F4B942", "#C9503F"};
inline constexpr const char* kFarExceededColour = "#8A1F24";
// Hatches over the verdict where an IMO zone is met: alone, and together with motions near or above a limit.
inline constexpr int kZoneOnlyPattern = 6;
inline constexpr const char* kZoneOnlyColour = "#7A4E00";
inline constexpr int kZoneAndMotionsPattern = 1;
inline constexpr const char* kZoneAndMotionsColour = "#4A1010";

/// Of the cells at steerage speed and above, 0 ... 1; -1 where there is none.
double unknown_share(const grid_t& grid);

/// Text in gnuplot's single quotes.
std::string quoted(std::string_view text);

/// Words broken into lines of at most `width` characters (bytes of UTF-8).
std::string wrapped(std::string_view text, std::size_t width, std::size_t max_lines);

/// Gnuplot commands (labels and objects) in the plane of polar_picture.cpp.
std::string side_panel(const PolarPicture& picture);

}  // namespace quickstrip
