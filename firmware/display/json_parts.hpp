// Parts of the frames, each from the messages it shows.
#pragma once

#include <nlohmann/json.hpp>

#include "firmware/display/shown.hpp"

namespace quickstrip {

/// null for what is not known (negative) or not finite.
nlohmann::json known(double value);

/// Text of a message's field; what fills it to the last byte was cut, and says so.
template <std::size_t N>
std::string field_text(const std::uint8_t (&field)[N]) {
  std::size_t n = 0;
  while (n < N && field[n] != 0) {
    ++n;
  }
  std::string text(reinterpret_cast<const char*>(field), n);
  constexpr std::size_t kLongestCharacter = 4;  // the cut is before the character that did not fit
  return N > 64 && n + kLongestCharacter >= N ? text + "…" : text;
}

nlohmann::json advice_json(const advice_t& advice);
nlohmann::json changes_json(const advice_t& advice, const outlook_t* outlook);
nlohmann::json outlook_json(const outlook_t& outlook);
nlohmann::json criteria_json(const limits_t& limits, const advice_t* advice, const outlook_t* outlook);
nlohmann::json inputs_json(const advice_t* advice, const health_t* health);
nlohmann::json sea_json(const ShownSea& sea);
nlohmann::json own_ship_json(const own_ship_t& ship);
nlohmann::json alerts_json(const Shown& shown);
nlohmann::json comparison_json(const comparison_t& comparison);
nlohmann::json health_json(const health_t& health);
nlohmann::json notes_json(const Shown& shown);
nlohmann::json cell_json(const grid_t& grid, int speed, int heading);
nlohmann::json answer_json(const response_t& response, const limits_t* limits);

/// Words for the hazard and quality bits of a cell, for the bridge.
nlohmann::json hazard_words(std::int32_t hazards);
nlohmann::json quality_words(std::int32_t quality);

}  // namespace quickstrip
