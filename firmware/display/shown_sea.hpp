// The sea as its wave systems, for arrows and words. A spectrum is divided by the same function of core that
// the advisor uses, so that the systems have the advisor's numbers.
#pragma once

#include <string>
#include <vector>

#include "quickstrip/sea_state_t.hpp"
#include "quickstrip/wave_spectrum_t.hpp"

namespace quickstrip {

struct ShownSystem {
  double hs_m = 0.0;
  double period_s = 0.0;
  int period_kind = 0;  // sea_state_t.PERIOD_...
  double dir_from_deg = 0.0;
  int kind = 0;  // sea_state_t.SYSTEM_...
};

struct ShownSea {
  double hs_m = -1.0;  // of the whole; -1: none
  int source_kind = 0;
  std::int64_t utime = 0;
  std::vector<ShownSystem> systems;  // in the advisor's order
};

/// Nothing (hs_m -1) when the message is refused.
ShownSea shown_sea(const sea_state_t& message);
ShownSea shown_sea(const wave_spectrum_t& message);

}  // namespace quickstrip
