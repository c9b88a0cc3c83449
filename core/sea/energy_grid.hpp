// Steps that both ways of placing a sea on the grid have in common. Internal to core/sea.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/sea/sea_energy.hpp"

namespace quickstrip {

// Less than this share of a system on the nodes is no basis for scaling: the end node takes it whole.
inline constexpr double kLeastShare = 1e-6;

// Energy [m2], density [m2 s] and share of direction that is as good as none: of waves of 1e-14 m. Numbers
// near the smallest of single precision, 1e-38, which far tails of spectra and seas of no height have, take a
// processor up to a hundred times as long as others, and a cycle in them took eighteen times its time.
inline constexpr double kLeastEnergy = 1e-28;

/// 3 ... kMaxFrequencies nodes, finite, positive, increasing. Errors: kNotFinite, kOutOfRange.
Status check_nodes(std::span<const double> omega);

/// No systems, no bands.
void clear_grid(std::size_t num_frequencies, SeaEnergy& out);

/// A band without energy, appended.
EnergyBand& add_band(SeaEnergy& out);

/// Bounds of each band, transforms of each system, height, lost tail; the systems' factors are set. m0 of the
/// input > 0; `on_nodes`: what of it lay on the nodes.
void complete(double m0, double on_nodes, SeaEnergy& out);

}  // namespace quickstrip
