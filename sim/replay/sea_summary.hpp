// The sea in a few figures, as pictures and tables need it: whole height, and the wave systems.
#pragma once

#include <vector>

#include "core/sea/sea_energy.hpp"
#include "firmware/session/session.hpp"

namespace quickstrip {

struct SummedSystem {
  double hs_m = 0.0;
  double tp_s = 0.0;
  double dir_from_deg = 0.0;
};

struct SeaSummary {
  double hs_m = 0.0;
  std::vector<SummedSystem> systems;  // the highest first
  /// Of the highest system; 0 without one.
  [[nodiscard]] double tp_s() const { return systems.empty() ? 0.0 : systems.front().tp_s; }
};

/// Of the last cycle of a session; nothing when it gave no advice.
SeaSummary summary(const StepOutput& output);

/// Of a message; nothing when it is refused.
SeaSummary summary(const wave_spectrum_t& message);
SeaSummary summary(const sea_state_t& message);

}  // namespace quickstrip
