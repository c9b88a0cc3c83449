// Limits: a quantity at a place, a statistic of it, and the value not to be exceeded. RMS is never judged
// against a significant value: the statistic is part of the criterion.
#pragma once

#include <cstdint>

#include "core/base/capacity.hpp"
#include "core/base/name.hpp"
#include "core/base/result.hpp"
#include "core/base/static_vector.hpp"
#include "core/hull/hull.hpp"
#include "core/response/interruptions.hpp"
#include "core/response/quantity.hpp"

namespace quickstrip {

enum class Statistic : std::uint8_t {
  kRms,
  kSignificant,    // single amplitude
  kProbability,    // per wave encounter
  kPerHour,        // events
  kShareOfPeople,  // who are sick
  kPerMinute,      // interruptions
};

/// kNowhere: the criterion asks for a role that the hull file does not give; listed as not watched, and no
/// cell is good without it.
inline constexpr std::uint8_t kNowhere = 255;

struct Criterion {
  Name name{};  // "roll", "slamming at bow"
  Quantity quantity = Quantity::kRoll;
  std::uint8_t place =
      0;  // index into the hull's points, slamming stations or freeboard points; propeller: 0
  Statistic statistic = Statistic::kRms;
  // m, rad, m/s2, probability per encounter, number per hour, share of people or number per minute
  double limit = 0.0;
  double caution_fraction = 0.75;  // of the limit: amber from here on
  double exposure = 0.0;           // s, motion sickness; 0: the two hours of 1974 (motion_sickness.hpp)
  Stance stance{};                 // interruptions
  [[nodiscard]] bool is_watched() const { return place != kNowhere; }
};

using Criteria = StaticVector<Criterion, kMaxCriteria>;

/// Motions and accelerations are judged by RMS or significant amplitude, slamming, deck wetness and propeller
/// emergence by probability or rate per hour, motion sickness by the share of people, interruptions by their
/// number per minute.
bool suits(Statistic statistic, Quantity quantity);

/// Whether the profile makes sense for this hull: every place exists or is kNowhere; every statistic suits
/// its quantity; limits are finite and above zero, a probability or a share below one; caution fractions in
/// (0, 1]; an exposure is 0 or 5 min to 24 h; interruptions at one place have one stance. Errors: kNotFinite,
/// kOutOfRange.
Status check_criteria(const Criteria& criteria, const Hull& hull);

}  // namespace quickstrip
