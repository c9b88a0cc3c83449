// What is known of the natural roll period: the measured one, or strip theory's with +-10 %, and the IS
// Code's estimate beside it. Zones count for every period of the band: its ends decide. No state. Sources:
// [IMO2008] for the estimate, [IMO2007] for the use.
#pragma once

#include <cstdint>

#include "core/hull/hull.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

enum class RollPeriodSource : std::uint8_t { kNotKnown, kComputed, kMeasured };

struct RollPeriodBand {
  RollPeriodSource source = RollPeriodSource::kNotKnown;
  double shortest = 0.0;  // s
  double longest = 0.0;   // s
  double is_code = 0.0;   // s, cross-check; 0: its formula does not hold for this ship
  [[nodiscard]] bool is_known() const { return source != RollPeriodSource::kNotKnown; }
};

/// Measured period of the loading if it is one (> 0), else computed from the loaded hull.
RollPeriodBand roll_period_band(const Hull& hull, const Loading& loading, const LoadedHull& loaded);

/// The two estimates differ by more than twice the error that either is given: GM or the gyradius may be
/// wrong.
bool contradicts_is_code(const RollPeriodBand& band);

}  // namespace quickstrip
