#include "core/advice/nordforsk.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/angles.hpp"
#include "core/base/constants.hpp"

namespace quickstrip {
namespace {

constexpr double kMotionCaution = 0.75;
constexpr double kProbabilityCaution = 0.5;

/// From `low` at short_length and below to `high` at long_length and above.
double by_length(double lpp, double short_length, double low, double long_length, double high) {
  const double part = std::clamp((lpp - short_length) / (long_length - short_length), 0.0, 1.0);
  return (1.0 - part) * low + part * high;
}

/// "slamming at bow", cut between two characters of UTF-8 when it is too long for a Name.
Name name_at(std::string_view what, std::string_view place) {
  std::array<char, 2 * kMaxNameBytes> text{};
  std::size_t length = 0;
  for (const std::string_view part : {what, place}) {
    for (const char c : part.substr(0, kMaxNameBytes)) {
      text[length++] = c;
    }
  }
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; };
  std::size_t end = std::min(length, kMaxNameBytes - 1);
  while (end > 0 && end < length && continues(text[end])) {
    --end;
  }
  return Name(std::string_view(text.data(), end));
}

bool add(Criteria& out, const Criterion& criterion) {
  return out.push_back(criterion);
}

bool add_acceleration(Criteria& out, const Hull& hull, PointRole role, Quantity quantity,
                      std::string_view what, std::string_view role_name, double limit) {
  bool fits = true;
  bool found = false;
  Criterion criterion{.quantity = quantity, .limit = limit, .caution_fraction = kMotionCaution};
  for (std::size_t i = 0; i < hull.points.size(); ++i) {
    if (hull.points[i].role == role) {
      criterion.name = name_at(what, hull.points[i].name.view());
      criterion.place = static_cast<std::uint8_t>(i);
      fits = add(out, criterion) && fits;
      found = true;
    }
  }
  if (!found) {
    criterion.name = name_at(what, role_name);
    criterion.place = kNowhere;
    fits = add(out, criterion);
  }
  return fits;
}

template <typename Places>
bool add_events(Criteria& out, const Places& places, Quantity quantity, std::string_view what, double limit) {
  bool fits = true;
  Criterion criterion{.quantity = quantity,
                      .statistic = Statistic::kProbability,
                      .limit = limit,
                      .caution_fraction = kProbabilityCaution};
  for (std::size_t i = 0; i < places.size(); ++i) {
    criterion.name = name_at(what, places[i].name.view());
    criterion.place = static_cast<std::uint8_t>(i);
    fits = add(out, criterion) && fits;
  }
  if (places.empty()) {
    criterion.name = name_at(what, "bow");
    criterion.place = kNowhere;
    fits = add(out, criterion);
  }
  return fits;
}

}  // namespace

Result<Criteria> nordforsk_merchant(const Hull& hull) {
  if (!(hull.lpp > 0.0)) {
    return Error::kOutOfRange;
  }
  constexpr double g = kStandardGravity;  // limits are multiples of the standard one
  Criteria out;
  const bool fits =
      add(out, {.name = Name("roll"),
                .quantity = Quantity::kRoll,
                .limit = radians(6.0),
                .caution_fraction = kMotionCaution}) &&
      add_acceleration(out, hull, PointRole::kForwardPerpendicular, Quantity::kVerticalAcceleration,
                       "vertical acc. at ", "fp", by_length(hull.lpp, 100.0, 0.275, 330.0, 0.05) * g) &&
      add_acceleration(out, hull, PointRole::kBridge, Quantity::kVerticalAcceleration, "vertical acc. at ",
                       "bridge", 0.15 * g) &&
      add_acceleration(out, hull, PointRole::kBridge, Quantity::kLateralAcceleration, "lateral acc. at ",
                       "bridge", 0.12 * g) &&
      add_events(out, hull.slamming, Quantity::kSlamming, "slamming at ",
                 by_length(hull.lpp, 100.0, 0.03, 300.0, 0.01)) &&
      add_events(out, hull.freeboard, Quantity::kDeckWetness, "deck wetness at ", 0.05);
  if (!fits) {
    return Error::kTooMany;
  }
  return out;
}

}  // namespace quickstrip
