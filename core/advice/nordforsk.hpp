// The default criteria: NORDFORSK 1987, general operability limits for merchant ships.
//
//   RMS roll 6 degrees; RMS vertical acceleration 0.275 g (L <= 100 m) ... 0.05 g (L >= 330 m) at the forward
//   perpendicular and 0.15 g at the bridge; RMS lateral acceleration 0.12 g at the bridge; probability per
//   encounter of slamming 0.03 (L <= 100 m) ... 0.01 (L >= 300 m) and of deck wetness 0.05. Linear in L
//   between.
// Caution from 0.75 of a limit on motion and 0.5 of a probability on: our choice.
// Source: NORDFORSK, Assessment of Ship Performance in a Seaway (1987), as in Faltinsen, Sea Loads (1990),
// table 1.1. Roll is confirmed by a second source; the others are quoted from memory of that table.
#pragma once

#include "core/advice/criteria.hpp"
#include "core/base/result.hpp"
#include "core/hull/hull.hpp"

namespace quickstrip {

/// One criterion for each place of the hull that bears the role; where the hull has none, one with place
/// kNowhere: not watched. Errors: kTooMany (more than kMaxCriteria), kOutOfRange (lpp).
Result<Criteria> nordforsk_merchant(const Hull& hull);

}  // namespace quickstrip
