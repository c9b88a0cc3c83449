// The sea on the grid of the transfer functions: wave energy per system, direction and frequency node [m2],
// so that a response variance is sum(|H|^2 energy). The energy of a node is the integral of S times the
// node's hat function: exact for a response that is linear between nodes. Built once per sea state, read by
// every cell of the cycle.
//
// Systems: spectrum.hpp over frequency times spreading.hpp over direction; in the order given. A measured
// spectrum: divided into systems (partition.hpp), in descending order of energy; piecewise linear between its
// bands, where the integrals are exact, nothing outside them; N directions are mapped onto the 72 by linear
// interpolation with the energy of each band kept (72 directions on the grid: as they are).
//
// What a node's energy does not tell, where within an interval it lies, is kept beside it: the density of
// each interval between nodes as a cubic (least squares), for responses that are anything but linear there.
//
// Kept as bands: wave energy over frequency that is spread over direction in one way. A parametric system is
// one band; of a measured spectrum each frequency is one, which every system takes in its own directions. A
// response is integrated over a band first, then convolved over direction, where the transform of each band
// over direction is kept ready (base/direction_transform.hpp).
//
// What lies outside [omega.front(), omega.back()] is the lost tail: the energies of each system are scaled so
// that their sum is its m0 all the same. With a tail of some per cent this is harmless; a system that lies
// outside the nodes altogether is put on the end node next to it and is wrong in period, never in height:
// callers flag advice by lost_tail.
// Cost: below 2 ms for six systems, 3 ms for a measured spectrum of 47 bands. Re-entrant: scratch is in
// SeaEnergy.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/capacity.hpp"
#include "core/base/direction_transform.hpp"
#include "core/base/result.hpp"
#include "core/sea/moments.hpp"
#include "core/sea/partition.hpp"
#include "core/sea/sea_state.hpp"
#include "core/sea/spreading.hpp"

namespace quickstrip {

/// Energy [m2] by node; zero outside nodes first ... last.
struct EnergyNodes {
  std::size_t first = 0;
  std::size_t last = 0;
  std::array<double, kMaxFrequencies> node{};
};

/// And density [m2 s] by interval as Legendre terms.
struct EnergyBand : EnergyNodes {
  std::array<DensityTerms, kMaxFrequencies - 1> density{};
};

/// What a system takes of every band: bands first ... first + count - 1, and the factor by direction that
/// waves come from, 2 pi d / kNumDirections. The transform is that of the factor: sum of factor e^{-i k d}.
struct SystemEnergy {
  std::size_t first = 0;
  std::size_t count = 0;
  std::array<DirectionWeights, kMaxEnergyBands> factor{};
  HalfCircle<kBandWidth> cosine{};  // real part, by wave number and band
  HalfCircle<kBandWidth> sine{};    // minus the imaginary part
};

/// Renormalised: the sum over all equals the m0 of the input; lost_tail is the fraction of m0 that lay
/// outside the frequency nodes before. Memory: 0.7 MB: static, never on the stack.
struct SeaEnergy {
  std::size_t num_systems = 0;
  std::size_t num_frequencies = 0;
  std::size_t num_bands = 0;
  std::array<EnergyBand, kMaxEnergyBands> band{};
  std::array<SystemEnergy, kMaxWaveSystems> part{};
  std::array<WaveSystem, kMaxWaveSystems>
      system{};                  // hs, Tp, mean direction and spreading of each, for words
  double lost_tail = 0.0;        // fraction of m0
  double hs = 0.0;               // of all systems together [m]
  WavePartition partition;       // of a measured spectrum
  PartitionWorkspace workspace;  // scratch, no meaning between calls
};

/// From wave systems. After an error there are no systems in `out`. Errors: kEmptySpectrum, kNotFinite,
/// kOutOfRange. `omega` increasing, 3 ... kMaxFrequencies.
Status place_on_grid(const SeaState& sea, std::span<const double> omega, SeaEnergy& out);

/// From a measured directional spectrum, divided into systems (no energy is lost by the division).
Status place_on_grid(const DirectionalSpectrum& spectrum, std::span<const double> omega, SeaEnergy& out);

}  // namespace quickstrip
