// The verdict on one cell: every criterion's value and margin from the moments of its channel.
//
// Margin: the factor by which wave height may grow before the limit is reached. Variances grow with its
// square: RMS and significant amplitude, limit / value; slamming, P = exp(-q / f^2) = limit gives
// f = sqrt(q / ln(1 / limit)), likewise deck wetness with q = freeboard^2 / 2 m0 and propeller emergence with
// q = depth^2 / 2 m0; for a rate per hour the
// limit on P is limit / (3600 / T2), since T2 does not change with height. Motion sickness:
// motion_sickness.hpp; interruptions: where the sum over both sides reaches the limit, by Newton on a convex
// function, which cannot overshoot.
//
// Verdict, the first that holds:
//   exceeded  any watched value is over its limit, or an IMO zone is met with its warning (kSevereZoneBits);
//   caution   an IMO zone is met (kZoneBits), whatever linear motions say;
//   unknown   components of low encounter frequency carry more than a fifth of the wave energy or of a
//   watched
//             variance: linear motions say nothing there. Of the waves, not of the responses alone: what
//             nearly stands still beside the ship makes small accelerations and no relative motion, so it
//             never shows in a watched variance, and yet it broaches ships;
//   caution   any watched value is over caution_fraction x limit;
//   unknown   any criterion is not watched, or there is none: no cell is good without it; or waves come from
//             abaft the beam, and a zone could not be evaluated (kHazardZonesUnknown);
//   good      otherwise. So no following sea is good on linear motion alone: there the zones have been looked
//             at, for a period and a stability in waves that are known, and the waves pass her fast enough.
// Zone only, motion only and both are told apart by kZoneBits and kHazardMotions; governing criterion and
// margin are always those of the motions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "core/advice/people_channels.hpp"
#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/response/moments.hpp"
#include "core/response/watch.hpp"

namespace quickstrip {

inline constexpr std::uint8_t kNoChannel = 255;

/// Share of the wave energy or of a watched variance below the encounter-frequency floor above which linear
/// motions say nothing.
inline constexpr double kLowEncounterLimit = 0.2;

/// Where each criterion finds its channel, and the channels that the grid needs.
struct CriteriaChannels {
  std::array<std::uint8_t, kMaxCriteria> of_criterion{};  // kNoChannel: not watched
  std::array<bool, kMaxChannels> is_needed{};             // by a criterion or a column of the grid
  std::array<bool, kMaxChannels> is_watched{};            // by a criterion
};

CriteriaChannels bind_criteria(const Criteria& criteria, const Watch& watch);

/// Of the channels of a criterion that is bound to `channel`: one; of interruptions both sides. `all`: of the
/// watch.
std::span<const ResponseMoments> moments_of(const Criterion& criterion, std::size_t channel,
                                            std::span<const ResponseMoments> all);

/// In the criterion's own statistic, at the ship's speed [m/s]. `moments`: moments_of the criterion.
double criterion_value(const Criterion& criterion, const Channel& channel, double speed,
                       std::span<const ResponseMoments> moments);

/// In [0, kMarginUnbounded]; 1 at the limit.
double height_margin(const Criterion& criterion, const Channel& channel, double speed,
                     std::span<const ResponseMoments> moments);

/// The wave system of the largest variance, of both sides for interruptions; kNoSystem when there is none.
std::uint8_t largest_system(std::span<const ResponseMoments> moments);

/// What is known of a cell besides its moments.
struct CellCircumstances {
  double speed = 0.0;  // m/s
  std::uint32_t quality = 0;
  std::uint16_t hazards = 0;
  double low_encounter_share = 0.0;  // of the wave energy
  double roll_damping_ratio = 0.0;
  double roll_damping_residual = 0.0;
};

/// moments: one per channel; those not needed may be zero. Governing: the criterion that decides, which is
/// the one of smallest margin among those that give cause for caution, or among all when none does; the first
/// of equals. governing_system is left to the caller. A moment that is not finite makes the cell unknown,
/// without values.
Cell judge(const Criteria& criteria, const CriteriaChannels& channels, const Watch& watch,
           std::span<const ResponseMoments> moments, const CellCircumstances& circumstances);

}  // namespace quickstrip
