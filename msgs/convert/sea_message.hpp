// QS_SEA_STATE and QS_WAVE_SPECTRUM against core's SeaState and DirectionalSpectrum. No heap.
//
// What a sea state does not give is assumed, and said: spreading 25 degrees (s about 9.5, a wind sea; never
// long-crested, for that hides the roll in head and following seas), shape Bretschneider, peakedness 3.3.
#pragma once

#include <cstdint>

#include "core/sea/sea_state.hpp"
#include "msgs/convert/refusal.hpp"
#include "quickstrip/sea_forecast_t.hpp"
#include "quickstrip/sea_state_t.hpp"
#include "quickstrip/wave_spectrum_t.hpp"

namespace quickstrip {

inline constexpr double kAssumedSpreading_deg = 25.0;
inline constexpr double kAssumedPeakedness = 3.3;

/// Bits as advice_t's ASSUMED_...
enum SeaAssumption : std::uint32_t {
  kAssumedSpreading = 1u << 0,
  kAssumedShape = 1u << 1,
  kAssumedPeakednessOfJonswap = 1u << 2,
};

/// On refusal `out` and `assumed` are as they were.
Conversion to_sea_state(const sea_state_t& message, SeaState& out, std::uint32_t& assumed);

/// Directions come out increasing. On refusal `out` is not to be used.
Conversion to_directional_spectrum(const wave_spectrum_t& message, DirectionalSpectrum& out);

/// Every state as a sea state of its own, times increasing; they may lie ahead. Not used yet.
Conversion check_forecast(const sea_forecast_t& message);

/// The way back, for the simulator: fills the systems and their masks, leaves utime, seq, source to the
/// caller. All of `sea` must be in range (our own error if not: the message would be refused).
void to_message(const SeaState& sea, sea_state_t& out);
void to_message(const DirectionalSpectrum& spectrum, wave_spectrum_t& out);

}  // namespace quickstrip
