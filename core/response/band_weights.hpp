// What a band of the sea makes of a response at one speed and direction: weights at the wave frequencies and
// at the points of the roll peak, so that its integral over the band is the sum of products. They depend on
// no response: found once, they serve every channel.
//
// variance = sum over the frequencies of value times wave energy (a straight line between them) + integral of
// (value - straight line) times wave energy density over the intervals of the peak (strip/roll_peak.hpp),
// the density a cubic in each interval (sea/sea_energy.hpp). A response that is linear there gets nothing
// added. Relative error of the cubic: below 1 % of the peak for JONSWAP of gamma 7 (tests/sea).
// In single precision, as responses are; sums are double. Cost: 10 flops a point of the peak and band. No
// state.
#pragma once

#include <array>
#include <span>

#include "core/base/capacity.hpp"
#include "core/base/lanes.hpp"
#include "core/response/channel_energy.hpp"
#include "core/sea/sea_energy.hpp"
#include "core/strip/roll_peak.hpp"

namespace quickstrip {

/// What does not depend on the sea: each point's place in its interval, 0 ... 1, and its weight times
/// Legendre terms.
struct PeakShapes {
  std::array<double, kMaxPeakPoints> place{};
  std::array<std::array<double, kDensityTerms>, kMaxPeakPoints> term{};
};
void list_peak_shapes(const RollPeak& peak, std::span<const double> omega, PeakShapes& out);

/// Zero outside the ranges. A response without points is weighed by the band's own energies.
struct alignas(kCacheLine) BandWeights {
  NodeValues energy{};  // m2
  NodeValues at_nodes{};
  PointValues at_points{};
  LaneRange nodes{};
  LaneRange points{};
};

void list_band_weights(const EnergyBand& band, const RollPeak& peak, const PeakShapes& shapes,
                       BandWeights& out);

/// out[b]: integral over bands[b] of a response. Spans of one length.
void integrate(std::span<const BandWeights> bands, const ChannelValues& values, std::span<double> out);

/// Of its part in waves that are met below the floor; the peak keeps off those.
void integrate_low(std::span<const BandWeights> bands, const Encounters& encounters,
                   const NodeValues& at_nodes, std::span<double> out);

/// Over a band of a response without points.
double integrate(const EnergyNodes& band, const NodeValues& at_nodes);

}  // namespace quickstrip
