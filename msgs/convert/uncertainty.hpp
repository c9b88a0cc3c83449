// How uncertain the inputs of a cycle are, for the ensemble (core/advice/ensemble.hpp): what a message says
// of itself, else what is typical of such a source. Typical ones are ours, on the wide side of what buoys,
// X-band radars, hindcasts and visual observers are known to scatter:
//   buoy 8 % of the height, 5 % of the period, 8 degrees · radar 12 %, 6 %, 10 · model 15 %, 10 %, 15 ·
//   visual or by hand 20 %, 15 %, 15 · not known 15 %, 10 %, 15.
// No heap.
#pragma once

#include <cstdint>

#include "core/advice/ensemble.hpp"
#include "core/hull/hull.hpp"
#include "quickstrip/sea_state_t.hpp"
#include "quickstrip/wave_spectrum_t.hpp"

namespace quickstrip {

/// Bits as outlook_t.std_assumed.
enum UncertaintyAssumption : std::uint32_t {
  kAssumedHeightStd = 1u << 0,
  kAssumedPeriodStd = 1u << 1,
  kAssumedDirectionStd = 1u << 2,
  kAssumedGmStd = 1u << 3,
  kAssumedRollDampingStd = 1u << 4,
};

struct StatedUncertainty {
  Uncertainty of;
  std::uint32_t assumed = 0;  // UncertaintyAssumption
};

/// Of a message that its converter has taken. Leaves GM and damping.
StatedUncertainty uncertainty_of(const sea_state_t& sea);
StatedUncertainty uncertainty_of(const wave_spectrum_t& sea);

/// GM [m] and roll damping of a loading.
void add_ship_uncertainty(const Loading& loading, double gm, StatedUncertainty& out);

}  // namespace quickstrip
