// Division of a measured directional spectrum into at most six wave systems, without losing energy.
//
// 1. The spectrum is smoothed (1-2-1 over frequency and direction, twice), for the search only.
// 2. Watershed by steepest ascent: cells in descending order join the highest neighbour (of eight) that has
//    been seen; a cell without one is a peak. Where two basins meet above 0.65 of the lower peak there is no
//    valley, and they are one.
// 3. Basins closer than half the smaller one's spread in the plane omega (cos, sin) are one; so are, nearest
//    first, basins of less than 2 % of the energy and what exceeds six.
// 4. Every remaining cell goes to the nearest system. Each cell belongs to exactly one system.
// After Hanson and Phillips 2001 (J. Atmos. Oceanic Technol. 18, 278-293) and Portilla et al. 2009 (26,
// 107-122); the thresholds are ours, chosen on a buoy's record of a hurricane.
//
// Deterministic: ties are broken by the cell's place. Systems in descending order of energy.
// Height, mean direction and spreading of a system are those of its cells; Tp is the peak of its own spectrum
// over frequency, by a parabola through three bands. Limits: two systems that overlap without a valley stay
// one; a boundary cuts through a skirt, so heights of close systems are some per cent off.
// Cost: sorting of at most 4,608 cells and some passes: below 1 ms. Memory: the workspace, 69 kB, static.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/capacity.hpp"
#include "core/base/result.hpp"
#include "core/sea/sea_state.hpp"
#include "core/sea/watershed.hpp"

namespace quickstrip {

struct WavePartition {
  std::size_t num_systems = 0;
  /// system_of[f][d] < num_systems.
  std::array<std::array<std::uint8_t, kMaxSpectrumDirections>, kMaxSpectrumFrequencies> system_of{};
  /// hs, Tp, mean direction, spreading; the shape of a measured system is not told.
  std::array<WaveSystem, kMaxWaveSystems> system{};
  std::array<double, kMaxWaveSystems> m0{};  // m2; their sum is the spectrum's
};

/// Errors: those of check_spectrum.
Status divide_into_systems(const DirectionalSpectrum& spectrum, PartitionWorkspace& work, WavePartition& out);

/// Fills system and m0 from num_systems and system_of; called by divide_into_systems.
void describe_systems(const DirectionalSpectrum& spectrum, WavePartition& out);

}  // namespace quickstrip
