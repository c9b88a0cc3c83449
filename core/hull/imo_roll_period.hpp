// The natural roll period estimated from the principal dimensions alone, for a first look and where strip
// theory has nothing better: 2008 IS Code (MSC.267(85)), part A, 2.3.5, as MSC.1/Circ.1228 uses it:
//   T = 2 C B / sqrt(GM),  C = 0.373 + 0.023 B/d - 0.043 L/100  (L in m, at the waterline).
// Fitted to conventional merchant ships, 24 m and longer; expect +-10 %. S-175: 18.3 s, with potential added
// mass 18.1 s. Not for models: the formula has a length in it and does not obey Froude's law.
#pragma once

#include "core/base/result.hpp"

namespace quickstrip {

/// Waterline length, breadth and mean draught at the waterline, fluid GM [m] -> s.
/// kNotFinite; kOutOfRange where an argument is not positive or C comes out not positive.
Result<double> imo_roll_period(double length, double breadth, double draught, double gm);

}  // namespace quickstrip
