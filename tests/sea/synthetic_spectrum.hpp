// Directional spectra with known systems, for the tests of this room.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/constants.hpp"
#include "core/sea/sea_state.hpp"
#include "core/sea/spectrum.hpp"

namespace quickstrip::testing {

/// 64 bands from 0.03 to 0.5 Hz, spaced geometrically; directions evenly spaced from `first_deg` on. Sampled
/// at the cells, with D = cos^2s((theta - mean)/2) normalised over the circle by the gamma function.
inline std::unique_ptr<DirectionalSpectrum> sampled(const std::vector<WaveSystem>& systems,
                                                    std::size_t num_directions = kMaxSpectrumDirections,
                                                    double first_deg = 0.0) {
  auto spectrum = std::make_unique<DirectionalSpectrum>();
  const bool fits =
      spectrum->frequencies.resize(kMaxSpectrumFrequencies) && spectrum->directions.resize(num_directions);
  QS_CHECK(fits);
  for (std::size_t f = 0; f < kMaxSpectrumFrequencies; ++f) {
    const double share = static_cast<double>(f) / static_cast<double>(kMaxSpectrumFrequencies - 1);
    spectrum->frequencies[f] = kTwoPi * 0.03 * std::pow(0.5 / 0.03, share);
  }
  for (std::size_t d = 0; d < num_directions; ++d) {
    spectrum->directions[d] = wrap_two_pi(radians(first_deg) + kTwoPi * static_cast<double>(d) /
                                                                   static_cast<double>(num_directions));
  }
  for (const WaveSystem& system : systems) {
    const Spectrum shape = *spectrum_of(system);
    const double s = 2.0 / (system.spreading * system.spreading) - 1.0;
    const double peak = std::exp(std::lgamma(s + 1.0) - std::lgamma(s + 0.5)) / (2.0 * std::sqrt(kPi));
    for (std::size_t f = 0; f < kMaxSpectrumFrequencies; ++f) {
      for (std::size_t d = 0; d < num_directions; ++d) {
        const double c = std::cos(0.5 * (spectrum->directions[d] - system.from.radians));
        spectrum->density[f][d] +=
            quickstrip::density(shape, spectrum->frequencies[f]) * peak * std::pow(c * c, s);
      }
    }
  }
  return spectrum;
}

inline WaveSystem swell_or_sea(double hs, double tp, double from_deg, double spreading_deg, double gamma) {
  WaveSystem system;
  system.hs = hs;
  system.period = tp;
  system.from.radians = radians(from_deg);
  system.spreading = radians(spreading_deg);
  system.shape = SpectrumShape::kJonswap;
  system.peakedness = gamma;
  return system;
}

}  // namespace quickstrip::testing
