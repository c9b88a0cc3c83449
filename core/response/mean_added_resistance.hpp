// Mean added resistance in a seaway, spreading included: 2 times the sum over relative directions and wave
// frequencies of R / zeta_a^2 times the wave energy [N], + aft [Journee1992] §3. Once by strip theory, once
// by the semi-empirical method where that has an answer at this speed.
//
// It is the same from both sides of the ship, has no roll peak, and adds over wave systems, so all of them
// are turned back to headings together: a sweep costs 37 directions x (frequencies x bands) + 532 x bands
// multiply-adds for each of the two. Linear between the wave frequencies. May be negative: waves from astern
// push. Expected error: rounding, 1e-15 of the largest; of the sum over frequencies: tests/response.
// Frequencies outside the grid of the transfer functions count as sea_energy.hpp places them.
#pragma once

#include <cstddef>
#include <optional>

#include "core/base/angles.hpp"
#include "core/base/result.hpp"
#include "core/response/heading_moments.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/transfer_functions.hpp"

namespace quickstrip {

/// By heading 2 pi h / kNumDirections, at one speed [N].
struct HeadingResistance {
  ByHeading strip{};
  ByHeading empirical{};
  bool has_empirical = false;
};

/// Uses of `work` what depends on speed.
void list_mean_added_resistance(const TransferFunctions& transfer, std::size_t speed, const SeaEnergy& sea,
                                SweepWorkspace& work, HeadingResistance& out);

/// At one course and speed [N].
struct MeanResistance {
  double strip = 0.0;
  std::optional<double> empirical;
};

/// Any heading; between the directions of the wave energy and between the solved speeds interpolated as the
/// moments are; at a cell of the grid its own sum. Errors: kSpeedOutOfGrid, kNotFinite.
Result<MeanResistance> mean_added_resistance(const TransferFunctions& transfer, const SeaEnergy& sea,
                                             Heading heading, double speed);

}  // namespace quickstrip
