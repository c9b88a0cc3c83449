// The arithmetic and the memory traffic that a change of loading cannot do without, as it is formulated
// (core/strip): what its floor is on a machine of known speed. Divisions and square roots count as one, and
// what only moves or compares numbers as nothing.
#pragma once

#include "core/strip/loaded_hull.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip::bench {

struct LoadingWork {
  double contours = 0.0;   // flops: pressure of the undisturbed wave over the contours
  double sums = 0.0;       // at nodes of encounter frequency
  double solutions = 0.0;  // loads, coefficients, equations of motion, added resistance
  double peaks = 0.0;      // points of the roll peak
  double bytes = 0.0;      // read and written

  [[nodiscard]] double flops() const { return contours + sums + solutions + peaks; }
};

/// Of the ordinary method with Lewis forms or a table's a and b, loads by kHaskind.
LoadingWork loading_work(const LoadedHull& hull, const TransferFunctions& transfer);

}  // namespace quickstrip::bench
