#include "core/sea/energy_grid.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/base/direction_transform.hpp"
#include "core/sea/moments.hpp"

namespace quickstrip {

Status check_nodes(std::span<const double> omega) {
  if (omega.size() < 3 || omega.size() > kMaxFrequencies) {
    return Error::kOutOfRange;
  }
  double last = 0.0;
  for (const double w : omega) {
    if (!std::isfinite(w)) {
      return Error::kNotFinite;
    }
    if (!(w > last)) {
      return Error::kOutOfRange;
    }
    last = w;
  }
  return {};
}

void clear_grid(std::size_t num_frequencies, SeaEnergy& out) {
  out.num_systems = 0;
  out.num_bands = 0;
  out.num_frequencies = num_frequencies;
  out.system.fill(WaveSystem{});
  out.lost_tail = 0.0;
  out.hs = 0.0;
}

EnergyBand& add_band(SeaEnergy& out) {
  QS_CHECK(out.num_bands < kMaxEnergyBands);
  EnergyBand& band = out.band[out.num_bands++];
  band.node.fill(0.0);
  band.density.fill(DensityTerms{});
  return band;
}

namespace {

void drop_least(std::span<double> values) {
  for (double& value : values) {
    value = std::fabs(value) < kLeastEnergy ? 0.0 : value;
  }
}

void set_bounds(std::size_t num_frequencies, EnergyBand& band) {
  band.first = num_frequencies;
  band.last = 0;
  for (std::size_t f = 0; f < num_frequencies; ++f) {
    if (band.node[f] != 0.0) {
      band.first = std::min(band.first, f);
      band.last = f;
    }
  }
  band.first = std::min(band.first, band.last);
}

// Energy from d and from the mirrored direction: even and odd in direction.
void transform_factors(SystemEnergy& system) {
  static_assert(sizeof(HalfCircle<kTransformBlock>) < 4096, "kept on the stack");
  for (std::size_t b = system.first; b < system.first + system.count; b += kTransformBlock) {
    HalfCircle<kTransformBlock> even{};
    HalfCircle<kTransformBlock> odd{};
    const std::size_t count = std::min(kTransformBlock, system.first + system.count - b);
    for (std::size_t m = 0; m < kNumSolvedDirections; ++m) {
      for (std::size_t j = 0; j < count; ++j) {
        const double one = system.factor[b + j][m];
        const double other = system.factor[b + j][(kNumDirections - m) % kNumDirections];
        even[m][j] = 0.5 * (one + other);
        odd[m][j] = 0.5 * (one - other);
      }
    }
    HalfCircle<kTransformBlock> cosine;
    HalfCircle<kTransformBlock> sine;
    cosine_transform(even, count, cosine);
    sine_transform(odd, count, sine);
    for (std::size_t k = 0; k < kNumSolvedDirections; ++k) {
      for (std::size_t j = 0; j < count; ++j) {
        system.cosine[k][b + j] = cosine[k][j];
        system.sine[k][b + j] = sine[k][j];
      }
    }
  }
}

}  // namespace

void complete(double m0, double on_nodes, SeaEnergy& out) {
  for (EnergyBand& band : std::span(out.band).first(out.num_bands)) {
    drop_least(band.node);
    for (DensityTerms& terms : band.density) {
      drop_least(terms);
    }
  }
  for (SystemEnergy& part : std::span(out.part).first(out.num_systems)) {
    for (DirectionWeights& factor : std::span(part.factor).subspan(part.first, part.count)) {
      drop_least(factor);
    }
  }
  for (std::size_t b = 0; b < out.num_bands; ++b) {
    set_bounds(out.num_frequencies, out.band[b]);
  }
  for (std::size_t s = 0; s < out.num_systems; ++s) {
    transform_factors(out.part[s]);
  }
  out.hs = significant_wave_height(m0);
  out.lost_tail = m0 > 0.0 ? std::clamp(1.0 - on_nodes / m0, 0.0, 1.0) : 0.0;
}

}  // namespace quickstrip
