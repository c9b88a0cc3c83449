// Fields into numbers. An empty field is "not given", which is no error; anything else is a number in its
// range or makes the sentence refused: what passes the checksum and is still no number was never one.
#pragma once

#include <optional>
#include <string_view>

#include "firmware/nmea/fate.hpp"
#include "firmware/nmea/reading.hpp"
#include "msgs/convert/ranges.hpp"

namespace quickstrip::nmea {

/// Digits with at most one point and a sign before them: no exponent, no "inf", no "nan", no spaces.
std::optional<double> number(std::string_view field);

/// What may stand for a letter: that letter, or nothing.
inline bool is_letter_or_empty(std::string_view field, char letter) {
  return field.empty() || (field.size() == 1 && field[0] == letter);
}
inline bool is_letter(std::string_view field, char letter) {
  return field.size() == 1 && field[0] == letter;
}
/// Of a field that older editions of its sentence do not have: absent or empty, or one of `letters`.
inline bool is_one_of(std::string_view field, std::string_view letters) {
  return field.empty() || (field.size() == 1 && letters.find(field[0]) != std::string_view::npos);
}

/// Gathers the readings of a sentence. After the first bad field nothing more is taken, and fate() says why.
class Gatherer {
 public:
  explicit Gatherer(Readings& out) : out_(out) { out_.clear(); }

  /// The number of `field` times `factor`; left out when the field is empty.
  void take(Quantity quantity, std::string_view field, double factor = 1.0);
  /// Likewise, of a direction; 360 is 0.
  void take_direction(Quantity quantity, std::string_view field);
  /// The number of `field`, not taken yet; nothing when it is empty or bad (then fate() says so).
  std::optional<double> value_of(std::string_view field);
  void give(Quantity quantity, double value);
  void refuse(Fate fate);

  /// kTaken, or the first reason, or kNotValid when there was nothing to take.
  [[nodiscard]] Fate fate();

 private:
  Readings& out_;
  Fate fate_ = Fate::kTaken;
};

/// What a ship can give, both ends included (own_ship_t, motion_t).
Range plausible_range(Quantity quantity);

}  // namespace quickstrip::nmea
