// Interruptions of both sides together, and how much the waves may grow until they reach a limit.
//
// With heights times f a side gives N exp(-E / f^2) a minute (response/interruptions.hpp; N and the periods
// stay). In x = 1/f^2 the logarithm of the sum over the sides is convex and falls: Newton comes up to the
// root from the left, where one side alone starts. Some 4 steps, at most 60.
#pragma once

#include <span>

#include "core/response/moments.hpp"

namespace quickstrip {

/// A minute; level [m/s2], moments of the channel of each side.
double sum_of_interruptions(double level, std::span<const ResponseMoments> sides);

/// Factor on wave height at which the sum becomes `limit` [1/min]; infinite where the sides have fewer
/// oscillations than interruptions are allowed. limit, level > 0.
double interruptions_margin(double limit, double level, std::span<const ResponseMoments> sides);

}  // namespace quickstrip
