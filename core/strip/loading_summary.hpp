// What a cycle asks of the loaded hull (loaded_hull.hpp), which is there only while its transfer functions
// are made.
#pragma once

#include "core/hull/hydrostatics.hpp"
#include "core/strip/loaded_hull.hpp"

namespace quickstrip {

struct LoadingSummary {
  Hydrostatics hydrostatics;
  double roll_natural_frequency = 0.0;  // rad/s, with a44 there, undamped
  bool has_table = false;               // coefficients come from a compiled hull table
};

inline LoadingSummary summary_of(const LoadedHull& loaded) {
  return {loaded.hydrostatics, loaded.roll_natural_frequency, loaded.table != nullptr};
}

}  // namespace quickstrip
