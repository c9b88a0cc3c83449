#include "core/strip/boundary_value.hpp"

#include <cmath>

#include "core/base/check.hpp"
#include "core/sea/dispersion.hpp"

namespace quickstrip {
namespace {

Complex at(const HullTable::WaveStencil& stencil, const std::array<Complex, kHullTableWaves>& values) {
  Complex sum;
  for (std::size_t n = 0; n < stencil.weight.size(); ++n) {
    sum += stencil.weight[n] * values[stencil.first + n];
  }
  return sum;
}

}  // namespace

void boundary_value_motions(const LoadedHull& hull, std::span<const double> omega, EncounterAngle mu,
                            std::span<SectionDiffraction> out) {
  QS_CHECK(hull.table != nullptr && omega.size() <= kMaxFrequencies && out.size() >= omega.size());
  std::array<HullTable::WaveStencil, kMaxFrequencies> stencil;
  for (std::size_t f = 0; f < omega.size(); ++f) {
    stencil[f] = hull.table->wave_stencil(wave_number(omega[f], hull.gravity));
  }
  const double sin_mu = std::sin(mu.radians);
  HullTable::WaveFactors factors;
  for (std::size_t i = 0; i < hull.num_sections; ++i) {
    hull.table->wave_factors(hull.level[i], sin_mu, factors);
    for (std::size_t f = 0; f < omega.size(); ++f) {
      out[f].heave[i] = at(stencil[f], factors.heave);
      out[f].sway[i] = at(stencil[f], factors.sway);
      out[f].roll[i] = at(stencil[f], factors.roll_lever);
    }
  }
}

}  // namespace quickstrip
