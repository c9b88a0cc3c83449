// A sea as beams: long-crested waves of one direction each, with a density over wave frequency. What the
// simulator makes of a sea state, apart from how the advisor places it on its grid (core/sea/sea_energy.hpp).
//
// A wave system is cut into directions no wider than 5 degrees and half its spreading, the share of each the
// value of cos^2s(theta/2) there: for a smooth periodic function the sum over even steps is exact. Long-
// crested: one beam. A measured spectrum: a beam for each of its directions, linear in frequency between its
// bands. Shares below 1e-5 of the largest are left out and the rest scaled up.
// Waves outside [lowest, highest] are left out and the rest of the system scaled so that its height is kept,
// as the advisor does; `lost` says how much that was.
#pragma once

#include <optional>
#include <vector>

#include "core/base/angles.hpp"
#include "core/base/result.hpp"
#include "core/sea/sea_state.hpp"
#include "core/sea/spectrum.hpp"

namespace quickstrip::seaway {

struct FrequencyRange {
  double lowest = 0.0;  // wave frequency [rad/s]
  double highest = 0.0;
};

struct Beam {
  WaveFrom from;
  double share = 0.0;                // of the density below
  std::optional<Spectrum> spectrum;  // of a wave system; else the bands
  std::vector<double> band_omega;    // rad/s
  std::vector<double> band_density;  // m2 s

  /// m2 s; 0 outside the bands.
  [[nodiscard]] double density(double omega) const;
};

struct Beams {
  std::vector<Beam> beams;
  FrequencyRange range;
  double m0 = 0.0;    // m2, of all
  double lost = 0.0;  // share of m0 outside the range, before scaling
};

/// Errors: kEmptySpectrum, kNotFinite, kOutOfRange.
Result<Beams> beams_of(const SeaState& sea, const FrequencyRange& range);
Result<Beams> beams_of(const DirectionalSpectrum& spectrum, const FrequencyRange& range);

}  // namespace quickstrip::seaway
