// What the roll peak adds to a variance beyond the straight line between wave frequencies.
//
// variance = sum over the frequencies of value times wave energy (a straight line between them) + integral of
// (value - straight line) times wave energy density over the intervals of the peak (strip/roll_peak.hpp).
// With the density as a cubic in each interval, the second is a sum of products of two sets of Legendre
// terms: one of the response, here, one of the sea (sea/sea_energy.hpp). The wave energy itself (value 1)
// gets nothing added. Relative error of the cubic: below 1 % of the peak for JONSWAP of gamma 7 (tests/sea).
// No state.
#pragma once

#include <array>
#include <span>

#include "core/base/capacity.hpp"
#include "core/response/channel_energy.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/roll_peak.hpp"

namespace quickstrip {

/// By interval of a RollPeak, in its order.
using PeakTerms = std::array<std::array<double, kDensityTerms>, kMaxPeakIntervals>;

/// What does not depend on the response: each point's weight times Legendre terms, and their sums over each
/// interval, plain and times the place in it, which a straight line takes.
struct PeakShapes {
  std::array<std::array<double, kDensityTerms>, kMaxPeakPoints> point{};
  PeakTerms whole{};
  PeakTerms rising{};
};
void list_peak_shapes(const RollPeak& peak, std::span<const double> omega, PeakShapes& out);

/// Terms of a response whose values (|H|^2, or times a power of omega_e) are `at_nodes`, the wave frequencies
/// of the shapes, and `at_points`, those of the peak.
void list_peak_terms(const RollPeak& peak, const PeakShapes& shapes, const NodeValues& at_nodes,
                     const PointValues& at_points, PeakTerms& out);

/// What each band of the sea brings at one direction: integral of value times band. Values beyond the last
/// frequency finite; `terms` may be null.
void integrate_over_bands(const SeaEnergy& sea, const NodeValues& at_nodes, const RollPeak& peak,
                          const PeakTerms* terms, std::span<double> out);

}  // namespace quickstrip
