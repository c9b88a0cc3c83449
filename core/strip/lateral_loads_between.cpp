#include "core/strip/lateral_loads_between.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/check.hpp"
#include "core/base/interpolation.hpp"
#include "core/sea/dispersion.hpp"

namespace quickstrip {
namespace {

constexpr std::size_t kStencil = 4;

struct Cubic {
  std::size_t first = 0;
  std::array<double, kStencil> weight{};
};

Cubic cubic_at(std::span<const double> omega, std::size_t interval, double at) {
  Cubic out;
  out.first = std::min(interval > 0 ? interval - 1 : 0, omega.size() - kStencil);
  lagrange_weights(omega.subspan(out.first, kStencil), at, out.weight);
  return out;
}

// out[i] = sum over the stencil of weight times values[i].
template <typename Values, typename Of>
void interpolate(const Cubic& cubic, std::size_t num_sections, const Of& values_of, Values& out) {
  const Values& v0 = values_of(cubic.first);
  const Values& v1 = values_of(cubic.first + 1);
  const Values& v2 = values_of(cubic.first + 2);
  const Values& v3 = values_of(cubic.first + 3);
  for (std::size_t i = 0; i < num_sections; ++i) {
    out[i] = (cubic.weight[0] * v0[i] + cubic.weight[1] * v1[i]) +
             (cubic.weight[2] * v2[i] + cubic.weight[3] * v3[i]);
  }
}

}  // namespace

double turn_between(const LoadedHull& hull, EncounterAngle mu, double omega, double next_omega) {
  const double change = wave_number(next_omega, hull.gravity) - wave_number(omega, hull.gravity);
  return 0.5 * hull.lpp * std::fabs(change * std::cos(mu.radians));
}

void set_lateral_wave_between(const LoadedHull& hull, const DirectionWaves& waves, EncounterAngle mu,
                              std::size_t interval, double omega, WaveWork& work) {
  QS_CHECK(waves.omega.size() >= kStencil && waves.sections.size() == waves.omega.size());
  const Cubic cubic = cubic_at(waves.omega, interval, omega);
  const std::size_t n = hull.num_sections;
  const auto section = [&waves](auto member) {
    return [&waves, member](std::size_t f) -> const HeldSectionValues& { return waves.sections[f].*member; };
  };
  SectionWaves sections;
  interpolate(cubic, n, section(&SectionWaves::sway), sections.sway);
  interpolate(cubic, n, section(&SectionWaves::roll), sections.roll);
  interpolate(cubic, n, section(&SectionWaves::horizontal_factor), sections.horizontal_factor);
  const bool has_diffraction = !waves.diffraction.empty();
  SectionDiffraction diffraction;
  if (has_diffraction) {
    const auto part = [&waves](auto member) {
      return [&waves, member](std::size_t f) -> const HeldComplexValues& {
        return waves.diffraction[f].*member;
      };
    };
    interpolate(cubic, n, part(&SectionDiffraction::sway), diffraction.sway);
    interpolate(cubic, n, part(&SectionDiffraction::roll), diffraction.roll);
  }
  lateral_wave_field(hull, omega, mu, sections, has_diffraction ? &diffraction : nullptr, work.field);
  arrange_lateral(hull, work.field, work.columns);
  work.nodes.forget();
}

LateralLoad lateral_load(const LoadedHull& hull, double omega_e, double speed, WaveWork& work) {
  WaveSums& sums = work.sums[0];
  work.nodes.lateral_at(hull, work.columns, node_stencil(hull, omega_e), omega_e, sums);
  const std::array<Pair, 6> load = lateral_loads_of(hull, work.columns, sums, omega_e, speed);
  return {complex_of(load[1]), complex_of(load[3]), complex_of(load[5])};
}

}  // namespace quickstrip
