#include "firmware/nmea/fields.hpp"

#include <charconv>

namespace quickstrip::nmea {
namespace {

constexpr std::size_t kMaxDigits = 20;

bool is_plain(std::string_view digits) {
  std::size_t num_points = 0;
  std::size_t num_digits = 0;
  for (const char c : digits) {
    num_points += c == '.' ? 1U : 0U;
    num_digits += c >= '0' && c <= '9' ? 1U : 0U;
  }
  return num_digits >= 1 && num_points <= 1 && num_points + num_digits == digits.size();
}

}  // namespace

std::optional<double> number(std::string_view field) {
  const bool is_signed = field.starts_with('-') || field.starts_with('+');
  const std::string_view digits = is_signed ? field.substr(1) : field;
  if (digits.size() > kMaxDigits || !is_plain(digits)) {
    return {};
  }
  double value = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto [stopped, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc{} || stopped != end) {
    return {};
  }
  return field.starts_with('-') ? -value : value;
}

Range plausible_range(Quantity quantity) {
  switch (quantity) {
    case Quantity::kHeading:
    case Quantity::kCourse:
      return {0.0, 360.0};
    case Quantity::kSpeedThroughWater:
      return kSpeedThroughWater_kn;
    case Quantity::kSpeedOverGround:
      return kSpeedOverGround_kn;
    case Quantity::kRateOfTurn:
      return {-720.0, 720.0};
    case Quantity::kLatitude:
      return {-90.0, 90.0};
    case Quantity::kLongitude:
      return {-180.0, 180.0};
    case Quantity::kDepth:
      return {0.0, 12'000.0};
    case Quantity::kRoll:
    case Quantity::kPitch:
      return {-90.0, 90.0};
    case Quantity::kHeave:
      return {-30.0, 30.0};
  }
  return {1.0, 0.0};  // holds nothing
}

std::optional<double> Gatherer::value_of(std::string_view field) {
  if (field.empty()) {
    return {};
  }
  const std::optional<double> value = number(field);
  if (!value) {
    refuse(Fate::kBadField);
  }
  return value;
}

void Gatherer::give(Quantity quantity, double value) {
  if (!plausible_range(quantity).holds(value)) {
    refuse(Fate::kOutOfRange);
    return;
  }
  if (fate_ == Fate::kTaken && !out_.push_back({quantity, value})) {
    refuse(Fate::kTooManyFields);
  }
}

void Gatherer::take(Quantity quantity, std::string_view field, double factor) {
  if (const std::optional<double> value = value_of(field)) {
    give(quantity, *value * factor);
  }
}

void Gatherer::take_direction(Quantity quantity, std::string_view field) {
  if (const std::optional<double> value = value_of(field)) {
    give(quantity, *value == 360.0 ? 0.0 : *value);
  }
}

void Gatherer::refuse(Fate fate) {
  if (fate_ == Fate::kTaken) {
    fate_ = fate;
  }
  out_.clear();
}

Fate Gatherer::fate() {
  if (fate_ == Fate::kTaken && out_.empty()) {
    return Fate::kNotValid;
  }
  return fate_;
}

}  // namespace quickstrip::nmea
