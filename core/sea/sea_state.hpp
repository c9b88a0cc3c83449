// What the sea is, as it comes in: up to six wave systems by height and period, or a measured directional
// spectrum.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/angles.hpp"
#include "core/base/capacity.hpp"
#include "core/base/static_vector.hpp"

namespace quickstrip {

enum class PeriodKind : std::uint8_t {
  kPeak,          // Tp
  kMean,          // T1 = Tm01
  kZeroCrossing,  // T2 = Tm02
};

enum class SpectrumShape : std::uint8_t { kBretschneider, kJonswap, kNeumann };

/// One wave system. hs > 0 [m]; period > 0 [s]; spreading: circular standard deviation of cos^2s(theta/2)
/// [rad], 0 = long-crested; peakedness: gamma of JONSWAP, 3.3 = mean JONSWAP, ignored by the other shapes.
struct WaveSystem {
  double hs = 0.0;
  double period = 0.0;
  PeriodKind period_kind = PeriodKind::kPeak;
  WaveFrom from;
  double spreading = 0.0;
  SpectrumShape shape = SpectrumShape::kBretschneider;
  double peakedness = 3.3;
};

struct SeaState {
  StaticVector<WaveSystem, kMaxWaveSystems> systems;
};

/// A measured directional spectrum. frequencies: omega [rad/s], strictly increasing; directions: where waves
/// come from [rad], evenly spaced all round; density[f][d] >= 0 [m2 s / rad].
struct DirectionalSpectrum {
  StaticVector<double, kMaxSpectrumFrequencies> frequencies;
  StaticVector<double, kMaxSpectrumDirections> directions;
  std::array<std::array<double, kMaxSpectrumDirections>, kMaxSpectrumFrequencies> density{};
};

}  // namespace quickstrip
