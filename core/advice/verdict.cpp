#include "core/advice/verdict.hpp"

#include <algorithm>
#include <cmath>

#include "core/advice/interruptions_margin.hpp"
#include "core/base/check.hpp"
#include "core/response/deck_wetness.hpp"
#include "core/response/motion_sickness.hpp"
#include "core/response/short_term.hpp"
#include "core/response/slamming.hpp"

namespace quickstrip {
namespace {

constexpr double kExtremeRoll = radians(10.0);  // RMS; linear roll damping is not valid above
constexpr double kLowEncounterWorthSaying = 0.01;

bool is_bridge_vertical(const Channel& channel) {
  return channel.quantity == Quantity::kVerticalAcceleration && channel.role == PointRole::kBridge;
}

/// Drawn in the picture whatever the criteria are.
bool is_column(const Channel& channel) {
  return channel.quantity == Quantity::kRoll || channel.quantity == Quantity::kSlamming ||
         channel.quantity == Quantity::kDeckWetness || is_bridge_vertical(channel);
}

/// q of P = exp(-q): a freeboard or a propeller is a slamming station without threshold velocity.
double event_exponent(const Channel& channel, double speed, const ResponseMoments& moments) {
  return slamming_exponent(level_at(channel, speed), channel.threshold_velocity, moments.m0, moments.m2);
}

double event_margin(const Criterion& criterion, const Channel& channel, double speed,
                    const ResponseMoments& moments) {
  double probability = criterion.limit;
  if (criterion.statistic == Statistic::kPerHour) {
    const double per_hour = oscillations_per_hour(moments.m0, moments.m2);
    if (!(per_hour > criterion.limit)) {
      return static_cast<double>(kMarginUnbounded);  // fewer oscillations than events allowed
    }
    probability = criterion.limit / per_hour;
  }
  return std::sqrt(event_exponent(channel, speed, moments) / -std::log(probability));
}

struct Tally {
  bool any_exceeded = false;
  bool any_caution = false;
  bool any_unwatched = false;
  bool all_finite = true;
  bool governing_is_caution = false;
  double governing_margin = static_cast<double>(kMarginUnbounded);
  bool next_is_caution = false;
  double next_margin = static_cast<double>(kMarginUnbounded);
};

/// A criterion that gives cause for caution goes before one that does not, whatever their margins: the one
/// that is named must be the one that decides. Whoever exceeds has the smallest margin anyway.
bool goes_before(bool is_caution, double margin, bool other_is_caution, double other_margin) {
  return is_caution != other_is_caution ? is_caution : margin < other_margin;
}

/// Keeps the first two in that order.
void place_criterion(std::uint8_t index, bool is_caution, double margin, Tally& tally, Cell& cell) {
  const bool governs = cell.governing == kNoCriterion ||
                       goes_before(is_caution, margin, tally.governing_is_caution, tally.governing_margin);
  if (governs) {
    cell.next = cell.governing;
    tally.next_is_caution = tally.governing_is_caution;
    tally.next_margin = tally.governing_margin;
    cell.governing = index;
    tally.governing_is_caution = is_caution;
    tally.governing_margin = margin;
  } else if (cell.next == kNoCriterion ||
             goes_before(is_caution, margin, tally.next_is_caution, tally.next_margin)) {
    cell.next = index;
    tally.next_is_caution = is_caution;
    tally.next_margin = margin;
  }
}

void judge_criterion(const Criterion& criterion, std::size_t index, const Channel& channel, double speed,
                     std::span<const ResponseMoments> moments, Tally& tally, Cell& cell) {
  const double value = criterion_value(criterion, channel, speed, moments);
  const double margin = height_margin(criterion, channel, speed, moments);
  tally.all_finite = tally.all_finite && std::isfinite(value) && std::isfinite(margin);
  cell.values[index] = static_cast<float>(value);
  tally.any_exceeded = tally.any_exceeded || value > criterion.limit;
  const bool is_caution = value > criterion.caution_fraction * criterion.limit;
  tally.any_caution = tally.any_caution || is_caution;
  place_criterion(static_cast<std::uint8_t>(index), is_caution, margin, tally, cell);
  for (const ResponseMoments& one : moments) {
    const double share = one.m0 > 0.0 ? one.m0_low_encounter / one.m0 : 0.0;
    cell.low_encounter_share = std::max(cell.low_encounter_share, static_cast<float>(share));
  }
}

Verdict verdict_of(const Tally& tally, unsigned hazards) {
  const bool in_zone = (hazards & kZoneBits) != 0;
  if (tally.any_exceeded || (hazards & kSevereZoneBits) != 0) {
    return Verdict::kExceeded;
  }
  if (in_zone) {
    return Verdict::kCaution;
  }
  if ((hazards & kHazardFollowingUnwatched) != 0) {
    return Verdict::kUnknown;
  }
  if (tally.any_caution) {
    return Verdict::kCaution;
  }
  const bool is_unknown = tally.any_unwatched || (hazards & kHazardZonesUnknown) != 0;
  return is_unknown ? Verdict::kUnknown : Verdict::kGood;
}

/// The amplitude that the roll limit means: a limit on RMS allows a significant amplitude of twice that.
double roll_amplitude_limit(const Criteria& criteria) {
  for (const Criterion& criterion : criteria) {
    if (criterion.quantity == Quantity::kRoll && criterion.is_watched()) {
      return criterion.statistic == Statistic::kRms ? 2.0 * criterion.limit : criterion.limit;
    }
  }
  return 0.0;
}

void fill_columns(const Criteria& criteria, const Watch& watch, std::span<const ResponseMoments> moments,
                  double speed, Cell& cell) {
  const auto worst = [](float& column, double value) {
    column = std::max(column, static_cast<float>(value));
  };
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    const Channel& channel = watch.channels[c];
    const ResponseMoments& m = moments[c];
    if (channel.quantity == Quantity::kRoll) {
      cell.rms_roll = static_cast<float>(std::sqrt(m.m0));
      if (const double limit = roll_amplitude_limit(criteria); limit > 0.0) {
        cell.roll_exceedance = static_cast<float>(rayleigh_exceedance(limit, m.m0));
      }
    } else if (is_bridge_vertical(channel)) {
      worst(cell.rms_bridge_vertical, std::sqrt(m.m0));
    } else if (channel.quantity == Quantity::kSlamming) {
      worst(cell.slam_probability,
            slamming_probability(channel.level, channel.threshold_velocity, m.m0, m.m2));
      worst(cell.slams_per_hour, slams_per_hour(channel.level, channel.threshold_velocity, m.m0, m.m2));
    } else if (channel.quantity == Quantity::kDeckWetness) {
      worst(cell.wetness_probability, wetness_probability(level_at(channel, speed), m.m0));
    }
  }
}

bool needed_are_finite(const CriteriaChannels& channels, std::span<const ResponseMoments> moments) {
  for (std::size_t c = 0; c < moments.size(); ++c) {
    if (channels.is_needed[c] && !(std::isfinite(moments[c].m0) && std::isfinite(moments[c].m2))) {
      return false;
    }
  }
  return true;
}

Cell unknown_cell(const CellCircumstances& circumstances) {
  Cell cell;
  cell.values.fill(kNotComputed);
  cell.hazards = circumstances.hazards;
  cell.quality = circumstances.quality;
  cell.roll_damping_ratio = static_cast<float>(circumstances.roll_damping_ratio);
  cell.roll_damping_residual = static_cast<float>(circumstances.roll_damping_residual);
  return cell;
}

}  // namespace

CriteriaChannels bind_criteria(const Criteria& criteria, const Watch& watch) {
  CriteriaChannels out;
  out.of_criterion.fill(kNoChannel);
  for (std::size_t c = 0; c < watch.channels.size(); ++c) {
    out.is_needed[c] = is_column(watch.channels[c]);
  }
  for (std::size_t i = 0; i < criteria.size(); ++i) {
    const std::size_t c = find_channel(watch, criteria[i].quantity, criteria[i].place);
    if (criteria[i].is_watched() && c < watch.channels.size()) {
      out.of_criterion[i] = static_cast<std::uint8_t>(c);
      for (std::size_t k = c; k < c + num_channels(criteria[i]); ++k) {
        out.is_needed[k] = true;
        out.is_watched[k] = true;
      }
    }
  }
  return out;
}

std::span<const ResponseMoments> moments_of(const Criterion& criterion, std::size_t channel,
                                            std::span<const ResponseMoments> all) {
  return all.subspan(channel, num_channels(criterion));
}

double criterion_value(const Criterion& criterion, const Channel& channel, double speed,
                       std::span<const ResponseMoments> of_channels) {
  const ResponseMoments& moments = of_channels.front();
  switch (criterion.statistic) {
    case Statistic::kRms:
      return std::sqrt(moments.m0);
    case Statistic::kSignificant:
      return significant_amplitude(moments.m0);
    case Statistic::kProbability:
      return std::exp(-event_exponent(channel, speed, moments));
    case Statistic::kPerHour:
      return oscillations_per_hour(moments.m0, moments.m2) *
             std::exp(-event_exponent(channel, speed, moments));
    case Statistic::kShareOfPeople:
      return motion_sickness(vertical_shaking(moments.m0, moments.m2), criterion.exposure);
    case Statistic::kPerMinute:
      return sum_of_interruptions(channel.level, of_channels);
  }
  check_failed("a statistic that is not one", __FILE__, __LINE__);
}

double height_margin(const Criterion& criterion, const Channel& channel, double speed,
                     std::span<const ResponseMoments> moments) {
  constexpr auto kUnbounded = static_cast<double>(kMarginUnbounded);
  const ResponseMoments& first = moments.front();
  if (criterion.statistic == Statistic::kProbability || criterion.statistic == Statistic::kPerHour) {
    return std::min(event_margin(criterion, channel, speed, first), kUnbounded);
  }
  if (criterion.statistic == Statistic::kShareOfPeople) {
    const VerticalShaking shaking = vertical_shaking(first.m0, first.m2);
    return std::min(motion_sickness_margin(shaking, criterion.exposure, criterion.limit), kUnbounded);
  }
  if (criterion.statistic == Statistic::kPerMinute) {
    return std::min(interruptions_margin(criterion.limit, channel.level, moments), kUnbounded);
  }
  const double value = criterion_value(criterion, channel, speed, moments);
  return value <= criterion.limit / kUnbounded ? kUnbounded : criterion.limit / value;
}

std::uint8_t largest_system(std::span<const ResponseMoments> moments) {
  std::array<double, kMaxWaveSystems> parts{};
  for (const ResponseMoments& one : moments) {
    for (std::size_t s = 0; s < kMaxWaveSystems; ++s) {
      parts[s] += one.m0_by_system[s];
    }
  }
  const auto* const largest = std::max_element(parts.begin(), parts.end());
  return *largest > 0.0 ? static_cast<std::uint8_t>(largest - parts.begin()) : kNoSystem;
}

Cell judge(const Criteria& criteria, const CriteriaChannels& channels, const Watch& watch,
           std::span<const ResponseMoments> moments, const CellCircumstances& circumstances) {
  QS_CHECK(moments.size() == watch.channels.size());
  Cell cell = unknown_cell(circumstances);
  if (!needed_are_finite(channels, moments)) {
    return cell;
  }
  cell.low_encounter_share = static_cast<float>(circumstances.low_encounter_share);
  Tally tally;
  tally.any_unwatched = criteria.empty();  // without a limit nothing is known to be good
  for (std::size_t i = 0; i < criteria.size(); ++i) {
    const std::size_t c = channels.of_criterion[i];
    if (c == kNoChannel) {
      tally.any_unwatched = true;
      continue;
    }
    judge_criterion(criteria[i], i, watch.channels[c], circumstances.speed,
                    moments_of(criteria[i], c, moments), tally, cell);
  }
  if (!tally.all_finite) {
    return unknown_cell(circumstances);
  }
  if (static_cast<double>(cell.low_encounter_share) > kLowEncounterLimit) {
    cell.hazards |= kHazardFollowingUnwatched;
  }
  if (tally.any_exceeded || tally.any_caution) {
    cell.hazards |= kHazardMotions;
  }
  cell.verdict = verdict_of(tally, cell.hazards);
  cell.margin = cell.governing == kNoCriterion ? 0.0F : static_cast<float>(tally.governing_margin);
  cell.next_margin_steps =
      static_cast<std::uint16_t>(tally.next_margin / static_cast<double>(kNextMarginStep));
  fill_columns(criteria, watch, moments, circumstances.speed, cell);
  if (static_cast<double>(cell.low_encounter_share) > kLowEncounterWorthSaying) {
    cell.quality |= kQualityLowEncounter;
  }
  if (static_cast<double>(cell.rms_roll) > kExtremeRoll) {
    cell.quality |= kQualityExtremeMotion;
  }
  return cell;
}

}  // namespace quickstrip
