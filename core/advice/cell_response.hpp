// Every watched quantity at one course and speed: what QS_RESPONSE and `quickstrip-hull responses` print.
//
// Between grid nodes the variances (and the other moments) are interpolated bilinearly, in heading between
// the directions of the wave energy (5 degrees) and in speed between the solved speeds; statistics are taken
// afterwards. At a cell of the grid this is the grid's own sum.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/advice/advice.hpp"
#include "core/advice/criteria.hpp"
#include "core/advice/grid.hpp"
#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/base/static_vector.hpp"

namespace quickstrip {

/// One quantity at one place. Slamming, deck wetness and propeller emergence: rms, significant and periods
/// are those of the vertical relative motion [m]. Motion sickness: those of the vertical acceleration, with
/// the period of motion that the incidence rests on, and the variance by system in the proportions of the
/// vertical velocity. Interruptions: one a side, of what tips [m/s2] (interruptions.hpp). Periods are 0 where
/// nothing moves.
struct QuantityResponse {
  Quantity quantity = Quantity::kRoll;
  std::uint8_t place = 0;           // index into points, slamming stations or freeboard points; motions: 0
  bool to_starboard = false;        // interruptions
  double rms = 0.0;                 // m, rad or m/s2
  double significant = 0.0;         // single amplitude
  double t1 = 0.0;                  // s
  double t2 = 0.0;                  // s
  double t4 = kNotComputed;         // s, between maxima; where bandwidth is
  double bandwidth = kNotComputed;  // epsilon, 0 ... 1: of watched quantities, or of all if asked
  // Events: per wave encounter. Interruptions: per oscillation. Motion sickness: share of people in the two
  // hours of 1974.
  double probability = kNotComputed;
  double per_hour = kNotComputed;                  // events and interruptions
  double low_encounter_share = 0.0;                // of the variance, below the encounter-frequency floor
  std::array<double, kMaxWaveSystems> variance{};  // by wave system; their sum is rms^2
};

/// 83 quantities of about 150 bytes: static. `cell` holds verdict, governing criterion and margin.
struct CellResponse {
  Heading heading{};
  double speed = 0.0;  // m/s
  std::size_t num_systems = 0;
  Cell cell{};
  StaticVector<QuantityResponse, kMaxChannels> quantities{};
};

/// Of a channel at the ship's speed [m/s].
QuantityResponse quantity_response(const Channel& channel, double speed, const ResponseMoments& moments);

/// What the next `duration` [s] is most likely to bring: the largest single amplitude of a motion or an
/// acceleration [m, rad, m/s2] (short_term.hpp); of what is counted, how often. 0 where nothing moves.
double expected_largest(const QuantityResponse& response, double duration);

/// Any heading; speed within the solved speeds. Cost: that of response_moments.
/// Errors: kSpeedOutOfGrid, kNotFinite, kTooMany.
Status respond(const GridInputs& inputs, Heading heading, double speed, CellResponse& out);

}  // namespace quickstrip
