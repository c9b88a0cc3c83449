// The wave frequencies of the paper, and its way between them: motions by Theilheimer polynomials, which are
// not-a-knot cubic splines (core/base/interpolation.hpp). [Journee1992] §4.
#pragma once

#include <vector>

#include "core/strip/motion_transfer.hpp"

namespace quickstrip::hull_tool {

/// Motions at `at` by not-a-knot cubic splines through motions at `nodes`, of real and imaginary part or of
/// amplitude and phase.
std::vector<MotionTransfer> spline_motions(const std::vector<double>& nodes,
                                           const std::vector<MotionTransfer>& motions,
                                           const std::vector<double>& at, bool by_amplitude);

/// The paper's 18 frequencies, and the 52 with two more in each interval.
std::vector<double> paper_frequencies();
std::vector<double> paper_frequencies_filled();

}  // namespace quickstrip::hull_tool
